#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

enum mode { MANUAL, AUTO, FEATHER };

struct gains {
    float kp, ki, kd, tf, out_min, out_max, rate;
};

struct pid {
    float integ, pv_old, d_filt, out;
    bool saturated;
};

static struct pid pids[LOOPS];
static struct gains gains[LOOPS];
static float rotor[LOOPS];
static int32_t n;
static bool init_done;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline void pid_step(struct pid *p, const struct gains *g, enum mode mode, float sp, float pv, float manual,
                            float dt)
{
    float err = sp - pv, raw, lim = 0.0f;

    p->d_filt += (dt / (g->tf + dt)) * ((p->pv_old - pv) / dt - p->d_filt);
    p->pv_old = pv;

    switch (mode) {
    case MANUAL:
        lim = clampf(g->out_min, manual, g->out_max);
        p->integ = lim - g->kp * err;
        p->saturated = false;
        break;
    case AUTO:
        raw = g->kp * err + p->integ + g->kd * p->d_filt;
        lim = clampf(g->out_min, raw, g->out_max);
        p->saturated = raw != lim;
        if (!p->saturated || (raw > lim && err < 0.0f) || (raw < lim && err > 0.0f))
            p->integ += g->ki * err * dt;
        break;
    case FEATHER:
        lim = g->out_max;
        p->integ *= 0.98f;
        p->saturated = true;
        break;
    }

    float step = g->rate * dt;
    if (lim > p->out + step)
        p->out += step;
    else if (lim < p->out - step)
        p->out -= step;
    else
        p->out = lim;
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < LOOPS; i++)
            gains[i] = (struct gains){
                .kp = 0.8f + (float)i * 0.01f,
                .ki = 0.5f + (float)(i % 8) * 0.1f,
                .kd = 0.02f,
                .tf = 0.05f + (float)(i % 4) * 0.01f,
                .out_min = -5.0f,
                .out_max = 25.0f,
                .rate = 8.0f + (float)(i % 3),
            };
        init_done = true;
    }

    n++;
    int32_t sat = 0;
    float sum = 0.0f;
    for (int i = 0; i < LOOPS; i++) {
        struct pid *p = &pids[i];
        int32_t phase = (n + i * 11) % 700;
        enum mode mode = phase < 40 ? MANUAL : phase > 660 ? FEATHER : AUTO;
        float wind = 8.0f + (float)(phase % 113) * 0.05f;
        float sched = 1.0f / (1.0f + fabsf(p->out) * 0.04f);
        gains[i].kp = (0.8f + (float)i * 0.01f) * sched;
        pid_step(p, &gains[i], mode, 12.0f, rotor[i], wind - 9.0f, 0.01f);
        rotor[i] += 0.01f * (wind + p->out * 0.9f - rotor[i] * 0.8f);
        if (p->saturated)
            sat++;
        sum = sum + p->out + rotor[i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(sum * 100.0f) + sat);
}
