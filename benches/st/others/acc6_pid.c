#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float kp, ti, td, lo, hi;
    float integral, last_pv, d_filt, out;
    bool first, saturated;
} pid_t_;

static pid_t_ loops[LOOPS];
static float level[LOOPS], target[LOOPS];
static int32_t n;
static bool started;

static float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid(pid_t_ *p, float sp, float pv, bool manual, float man_out, float dt)
{
    if (p->first) {
        p->last_pv = pv;
        p->first = false;
    }
    float err = sp - pv;
    float d = (p->last_pv - pv) / dt;
    p->last_pv = pv;
    p->d_filt += 0.2f * (d - p->d_filt);

    if (manual) {
        p->out = limit(p->lo, man_out, p->hi);
        p->integral = p->out - p->kp * err;
        p->saturated = false;
    } else {
        float raw = p->kp * (err + p->td * p->d_filt) + p->integral;
        p->out = limit(p->lo, raw, p->hi);
        p->saturated = raw != p->out;
        if (!p->saturated || (raw > p->hi && err < 0.0f) || (raw < p->lo && err > 0.0f))
            p->integral += p->kp * err * dt / p->ti;
    }
}

void scan(void)
{
    float sum = 0.0f;
    int32_t sat = 0;

    if (!started) {
        started = true;
        for (int i = 0; i < LOOPS; i++) {
            loops[i] = (pid_t_){ .kp = 1.0f + 0.05f * (float)i, .ti = 0.5f + 0.02f * (float)i, .td = 0.05f,
                                 .lo = 0.0f, .hi = 100.0f, .first = true };
            target[i] = 20.0f + (float)i;
        }
    }
    n++;
    if (n % 100 == 0)
        for (int i = 0; i < LOOPS; i++)
            target[i] = (float)((i * 17 + n) % 90);

    for (int i = 0; i < LOOPS; i++) {
        pid_t_ *p = &loops[i];
        pid(p, target[i], level[i], (n + i * 8) % 512 < 20, 40.0f, 0.01f);
        level[i] += (p->out - level[i]) * 0.02f;
        sum += p->out;
        sat += p->saturated;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 100.0f) + sat));
}
