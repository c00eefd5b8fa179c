/* 64 PID loops, each closed over a first-order process */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float kp, ti, td, dt, out_min, out_max;
    float integral, d_term, last_pv;
    float out;
    bool saturated;
} Pid;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline void pid_run(Pid *c, float sp, float pv, bool auto_on, float hand_out)
{
    float err = sp - pv;
    float p = c->kp * err;
    c->d_term += 0.2f * (c->kp * c->td * (c->last_pv - pv) / c->dt - c->d_term);
    c->last_pv = pv;
    if (auto_on) {
        float u = p + c->integral + c->d_term;
        c->out = limit(c->out_min, u, c->out_max);
        c->saturated = c->out != u;
        if (!c->saturated || (u > c->out_max && err < 0) || (u < c->out_min && err > 0))
            c->integral += c->kp * c->dt / c->ti * err;
    } else {
        c->out = limit(c->out_min, hand_out, c->out_max);
        c->integral = limit(c->out_min, c->out - p - c->d_term, c->out_max);
        c->saturated = false;
    }
}

static bool init_done;
static Pid loops[LOOPS];
static float process[LOOPS], gain[LOOPS], lag[LOOPS], setpt[LOOPS];
static int32_t scan_no;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < LOOPS; i++) {
            loops[i].kp = 1.0f + (float)(i % 8) * 0.5f;
            loops[i].ti = 0.5f + (float)(i % 5) * 0.25f;
            loops[i].td = (float)(i % 3) * 0.02f;
            loops[i].dt = 0.01f;
            loops[i].out_max = 100.0f;
            gain[i] = 0.8f + (float)i * 0.01f;
            lag[i] = 0.3f + (float)(i % 11) * 0.1f;
            setpt[i] = 20.0f + (float)i;
        }
        init_done = true;
    }

    scan_no++;
    setpt[scan_no % 64] = 10.0f + (float)((int32_t)((uint32_t)scan_no * 37u) % 80);

    uint32_t sat_count = 0, hash = 0;
    for (int i = 0; i < LOOPS; i++) {
        Pid *c = &loops[i];
        pid_run(c, setpt[i], process[i], (scan_no + i) % 512 > 40, 30.0f + (float)(i % 16));
        process[i] += 0.01f / lag[i] * (gain[i] * c->out - process[i]);
        if (c->saturated)
            sat_count++;
        hash = hash * 31 + (int32_t)((c->out + process[i]) * 100.0f);
    }
    check = (int32_t)(hash + sat_count);
}
