/* 64 PID control loops, each with a simulated first order plant. */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define TS 0.01f

struct params { int sp; float kp, ti, td, gain, tau; };

struct loop {
    float last, iterm, cv;      /* controller */
    bool saturated;
    float y;                    /* plant */
};

static const struct params par[LOOPS] = {
    { 3, 1.2f, 4.2f, 0.2f, 1.2f, 3.7f },
    { 0, 1.8f, 1.9f, 0.07f, 1.7f, 5.5f },
    { 1, 1.0f, 2.8f, 0.15f, 0.9f, 4.9f },
    { 0, 1.0f, 2.7f, 0.01f, 2.0f, 0.7f },
    { 1, 1.1f, 3.9f, 0.02f, 1.5f, 1.9f },
    { 1, 3.9f, 1.4f, 0.03f, 1.9f, 0.4f },
    { 3, 3.0f, 1.5f, 0.1f, 1.7f, 1.1f },
    { 3, 2.7f, 3.4f, 0.1f, 1.7f, 2.6f },
    { 3, 3.8f, 1.3f, 0.02f, 0.6f, 1.7f },
    { 3, 1.5f, 1.5f, 0.08f, 0.6f, 4.4f },
    { 2, 1.8f, 4.5f, 0.08f, 1.9f, 5.3f },
    { 0, 2.4f, 0.9f, 0.06f, 1.0f, 1.7f },
    { 1, 2.0f, 1.1f, 0.2f, 1.0f, 3.0f },
    { 3, 2.4f, 4.7f, 0.12f, 0.8f, 2.0f },
    { 1, 1.6f, 2.1f, 0.02f, 0.8f, 0.6f },
    { 0, 1.2f, 3.4f, 0.02f, 1.9f, 1.3f },
    { 2, 4.0f, 1.8f, 0.14f, 1.8f, 3.3f },
    { 0, 3.6f, 2.2f, 0.17f, 1.7f, 0.5f },
    { 0, 3.9f, 2.2f, 0.05f, 1.9f, 5.9f },
    { 0, 3.7f, 2.3f, 0.1f, 1.5f, 3.5f },
    { 1, 3.0f, 2.6f, 0.12f, 0.8f, 2.3f },
    { 3, 0.5f, 4.5f, 0.01f, 2.0f, 2.2f },
    { 1, 2.9f, 1.3f, 0.17f, 1.7f, 1.7f },
    { 3, 2.2f, 3.8f, 0.15f, 0.7f, 2.3f },
    { 2, 2.1f, 0.3f, 0.14f, 1.1f, 5.0f },
    { 0, 1.2f, 3.2f, 0.12f, 1.7f, 3.4f },
    { 0, 0.7f, 3.6f, 0.17f, 0.7f, 0.4f },
    { 0, 3.1f, 2.6f, 0.04f, 1.2f, 1.3f },
    { 1, 2.3f, 2.4f, 0.19f, 0.7f, 1.6f },
    { 0, 2.6f, 1.6f, 0.05f, 1.8f, 5.5f },
    { 3, 1.0f, 1.5f, 0.17f, 1.2f, 1.1f },
    { 0, 2.3f, 2.1f, 0.14f, 1.8f, 1.1f },
    { 3, 0.6f, 2.2f, 0.17f, 2.0f, 2.0f },
    { 3, 3.4f, 2.3f, 0.05f, 0.9f, 3.7f },
    { 1, 2.6f, 1.8f, 0.18f, 0.8f, 3.4f },
    { 0, 1.6f, 0.2f, 0.11f, 1.5f, 4.6f },
    { 2, 1.5f, 1.5f, 0.1f, 1.4f, 2.8f },
    { 2, 2.4f, 0.2f, 0.14f, 1.0f, 5.4f },
    { 3, 3.8f, 2.4f, 0.01f, 1.8f, 0.6f },
    { 2, 3.2f, 1.8f, 0.13f, 2.0f, 0.4f },
    { 1, 3.5f, 0.6f, 0.15f, 1.2f, 0.5f },
    { 1, 2.9f, 3.0f, 0.15f, 1.8f, 3.1f },
    { 3, 0.6f, 2.5f, 0.13f, 2.0f, 5.0f },
    { 2, 3.8f, 3.5f, 0.01f, 0.8f, 1.6f },
    { 1, 3.2f, 0.3f, 0.13f, 1.5f, 1.8f },
    { 3, 0.9f, 4.9f, 0.01f, 1.1f, 3.8f },
    { 1, 4.0f, 4.3f, 0.08f, 1.2f, 3.6f },
    { 2, 2.0f, 4.4f, 0.09f, 2.0f, 3.5f },
    { 1, 3.2f, 0.5f, 0.1f, 0.7f, 3.9f },
    { 0, 2.9f, 2.9f, 0.16f, 1.0f, 5.3f },
    { 1, 3.5f, 3.3f, 0.14f, 1.4f, 4.9f },
    { 2, 3.2f, 2.2f, 0.04f, 1.1f, 5.1f },
    { 3, 3.2f, 1.0f, 0.12f, 1.7f, 4.1f },
    { 2, 0.9f, 0.8f, 0.01f, 0.7f, 1.4f },
    { 0, 3.5f, 3.5f, 0.16f, 1.7f, 5.2f },
    { 0, 0.6f, 0.9f, 0.12f, 1.8f, 5.0f },
    { 3, 1.3f, 4.5f, 0.01f, 0.8f, 4.4f },
    { 0, 2.0f, 3.1f, 0.08f, 2.0f, 0.5f },
    { 1, 3.3f, 4.1f, 0.03f, 1.2f, 3.5f },
    { 1, 3.2f, 4.0f, 0.06f, 0.8f, 0.7f },
    { 3, 3.3f, 0.3f, 0.01f, 1.4f, 6.0f },
    { 3, 0.7f, 3.2f, 0.07f, 1.1f, 1.6f },
    { 3, 3.6f, 2.8f, 0.13f, 0.9f, 1.4f },
    { 0, 3.9f, 1.6f, 0.15f, 1.9f, 0.6f },
};
static struct loop loops[LOOPS];
static int32_t tick, seed = 99;

static void pid(struct loop *l, const struct params *p, float sp)
{
    float e = sp - l->y;
    float d = p->kp * p->td * (e - l->last) / TS;
    float raw = p->kp * e + l->iterm + d;

    l->cv = raw < 0.0f ? 0.0f : raw > 100.0f ? 100.0f : raw;
    l->saturated = l->cv != raw;
    if (!l->saturated)
        l->iterm = l->iterm + p->kp * TS / p->ti * e;
    l->last = e;
}

static void plant(struct loop *l, const struct params *p, float load)
{
    l->y = l->y + (p->gain * l->cv - load - l->y) * TS / p->tau;
}

void scan(void)
{
    float sp[4], load;
    int32_t sum = 0;

    tick++;
    seed = (seed * 1103 + 12345) % 65536;
    load = (float)(seed % 1000) / 200.0f;
    sp[0] = tick % 400 < 200 ? 40.0f : 60.0f;
    sp[1] = tick % 1000 < 300 ? 25.0f : 75.0f;
    sp[2] = 20.0f + (float)(tick % 500) * 0.1f;
    sp[3] = 50.0f + load;

    for (int i = 0; i < LOOPS; i++) {
        struct loop *l = &loops[i];

        pid(l, &par[i], sp[par[i].sp]);
        plant(l, &par[i], load);
        sum += (int32_t)(l->y * 100.0f) + (int32_t)l->cv;
        if (l->saturated)
            sum += i + 1;
    }
    check = (check * 31 + sum) % 1000003;
}
