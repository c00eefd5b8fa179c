#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float out;
    bool lim;
    float integral, old_pv;
} Pid;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline void pid_step(Pid *p, float sp, float pv, float kp, float ti, float td,
                            float dt, bool automatic, float man)
{
    float err = sp - pv;
    if (automatic) {
        float deriv = (p->old_pv - pv) / dt;
        float u = kp * (err + p->integral / ti + td * deriv);
        p->out = clampf(0.0f, u, 100.0f);
        p->lim = p->out != u;
        if (!p->lim)
            p->integral += err * dt;
    } else {
        p->out = clampf(0.0f, man, 100.0f);
        p->lim = false;
        p->integral = (p->out / kp - err) * ti;
    }
    p->old_pv = pv;
}

static Pid loops[LOOPS];
static float temp[LOOPS];
static int tick;

void scan(void)
{
    int32_t sum = 0;
    for (int i = 0; i < LOOPS; i++) {
        float setp = 20.0f + (float)((tick / 100 + i) % 50);
        pid_step(&loops[i], setp, temp[i], 2.0f + (float)i * 0.05f, 4.0f, 0.05f, 0.01f,
                 (tick + i * 16) % 1024 > 60, 35.0f);
        temp[i] += (loops[i].out - temp[i]) * 0.02f;
        sum += (int32_t)(loops[i].out * 100.0f) + (int32_t)(temp[i] * 1000.0f);
        if (loops[i].lim)
            sum++;
    }
    tick = (tick + 1) % 20000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
