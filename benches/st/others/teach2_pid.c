/* Example 6: 64 temperature loops with PID controller and process model. */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

struct pid {
    float kp, ti, td, dt, out_min, out_max;
    float out;
    bool limited;
    float integ, deriv, pv_old;
    bool first;
};

struct oven {
    float ambient, gain, lag;
    float temperature;
};

static struct pid pids[LOOPS];
static struct oven ovens[LOOPS];
static float sp[LOOPS];
static int32_t cycle;
static bool init;

static float limit(float lo, float x, float hi)
{
    if (x < lo)
        x = lo;
    if (x > hi)
        x = hi;
    return x;
}

static float absf(float x)
{
    return x < 0.0f ? -x : x;
}

static void pid_run(struct pid *p, float setpoint, float pv, bool manual, float man_out)
{
    float err, raw;

    if (p->first) {
        p->pv_old = pv;
        p->first = false;
    }

    err = setpoint - pv;

    /* derivative of the process value, first-order filter */
    p->deriv = p->deriv + 0.2f * (p->td * (p->pv_old - pv) / p->dt - p->deriv);
    p->pv_old = pv;

    if (manual) {
        /* bumpless: the integral part follows the manual value */
        p->out = limit(p->out_min, man_out, p->out_max);
        p->integ = p->out - p->kp * err;
        p->limited = false;
    } else {
        raw = p->kp * (err + p->deriv) + p->integ;
        p->limited = false;
        if (raw > p->out_max) {
            p->out = p->out_max;
            p->limited = true;
        } else if (raw < p->out_min) {
            p->out = p->out_min;
            p->limited = true;
        } else {
            p->out = raw;
        }

        /* anti-windup: integrate only if this does not drive further into the limit */
        if (!p->limited || (raw > p->out_max && err < 0.0f) || (raw < p->out_min && err > 0.0f))
            p->integ = p->integ + p->kp * err * p->dt / p->ti;
    }
}

static void oven_run(struct oven *o, float power)
{
    o->temperature = o->temperature + (o->ambient + o->gain * power - o->temperature) * o->lag;
}

void scan(void)
{
    int i;
    float sum_err = 0.0f;
    int16_t n_limit = 0;

    if (!init) {
        for (i = 0; i < LOOPS; i++) {
            sp[i] = 100.0f + (float)(i + 1) * 2.0f;
            pids[i].dt = 0.1f;
            pids[i].out_min = 0.0f;
            pids[i].out_max = 100.0f;
            pids[i].first = true;
            ovens[i].ambient = 20.0f;
            ovens[i].lag = 0.02f;
            ovens[i].temperature = 20.0f;
        }
        init = true;
    }

    cycle = (cycle + 1) % 6400;
    /* one loop gets a new set point every 100 cycles */
    if (cycle % 100 == 0) {
        i = cycle / 100;
        if (sp[i] > 200.0f)
            sp[i] = sp[i] - 90.0f;
        else
            sp[i] = sp[i] + 40.0f;
    }

    for (i = 0; i < LOOPS; i++) {
        struct pid *p = &pids[i];
        struct oven *o = &ovens[i];
        int nr = i + 1;

        p->kp = 0.8f + (float)(nr % 4) * 0.2f;
        p->ti = 12.0f;
        p->td = 0.4f;
        pid_run(p, sp[i], o->temperature, nr == 64 && cycle < 500, 35.0f);
        o->gain = 2.5f + (float)(nr % 3) * 0.5f;
        oven_run(o, p->out);
        sum_err += absf(sp[i] - o->temperature);
        if (p->limited)
            n_limit++;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum_err * 100.0f)
                      + (uint32_t)n_limit + (uint32_t)(int32_t)(pids[6].out * 1000.0f));
}
