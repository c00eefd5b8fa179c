/* 64 PID loops, each with a first-order process. */
#include "st.h"
#include <stdbool.h>

typedef struct {
    float kp, ti, td, ts, out_min, out_max;
    float integral, last_pv, d_filt;
    float out;
    bool limited;
} PidLoop;

static float limit(float mn, float in, float mx)
{
    if (in < mn)
        return mn;
    if (in > mx)
        return mx;
    return in;
}

static void pid_loop(PidLoop *p, float sp, float pv, bool manual, float man_out)
{
    float err = sp - pv;

    if (manual) {
        p->out = limit(p->out_min, man_out, p->out_max);
        p->integral = p->out - p->kp * err;
        p->limited = false;
        p->d_filt = 0.0f;
    } else {
        float p_part = p->kp * err;
        float d_part = p->kp * p->td * (p->last_pv - pv) / p->ts;
        float u;

        p->d_filt = p->d_filt + 0.2f * (d_part - p->d_filt);
        u = p_part + p->integral + p->d_filt;
        if (u > p->out_max) {
            p->out = p->out_max;
            p->limited = true;
        } else if (u < p->out_min) {
            p->out = p->out_min;
            p->limited = true;
        } else {
            p->out = u;
            p->limited = false;
            p->integral = p->integral + p->kp * p->ts / p->ti * err;
        }
    }
    p->last_pv = pv;
}

static bool ready;
static int32_t tick;
static PidLoop loops[64];
static float setpoint[64], process[64];

void scan(void)
{
    int32_t i, sum;

    if (!ready) {
        ready = true;
        for (i = 0; i < 64; i++) {
            loops[i].kp = 1.2f;
            loops[i].ti = 4.0f;
            loops[i].td = 0.5f;
            loops[i].ts = 0.1f;
            loops[i].out_min = 0.0f;
            loops[i].out_max = 100.0f;
        }
    }

    tick = (tick + 1) % 6400;
    if (tick % 10 == 0) {
        i = (tick / 10) % 64;
        setpoint[i] = 20.0f + (float)((tick * 7) % 60);
    }

    sum = 0;
    for (i = 0; i < 64; i++) {
        pid_loop(&loops[i], setpoint[i], process[i], (tick + i * 50) % 3200 < 200, 35.0f);
        process[i] = process[i] + 0.05f * (loops[i].out * 0.9f - process[i]);
        sum += (int32_t)(loops[i].out * 100.0f);
        if (loops[i].limited)
            sum += 1;
    }
    check = (check % 1000003) * 31 + sum;
}
