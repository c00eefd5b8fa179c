/* PID controller with filtered derivative on the actual value, limits and anti-windup */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

struct pid {
    float kp, ti, td, dt, out_min, out_max;
    float y;
    bool limited;
    float integral, pv_old, deriv;
};

static float limit(float mn, float in, float mx)
{
    if (in < mn)
        return mn;
    if (in > mx)
        return mx;
    return in;
}

static void pid_run(struct pid *r, float sp, float pv, bool manual, float man_value)
{
    float e = sp - pv;
    float p, u;

    if (manual) {
        r->y = limit(r->out_min, man_value, r->out_max);
        r->integral = r->y - r->kp * e;
        r->pv_old = pv;
        r->deriv = 0.0f;
        r->limited = false;
        return;
    }

    p = r->kp * e;
    r->deriv = r->deriv + 0.2f * (r->kp * r->td * (r->pv_old - pv) / r->dt - r->deriv);
    u = p + r->integral + r->deriv;
    r->limited = false;
    if (u > r->out_max) {
        r->y = r->out_max;
        r->limited = true;
    } else if (u < r->out_min) {
        r->y = r->out_min;
        r->limited = true;
    } else {
        r->y = u;
    }
    if (!r->limited || (u > r->out_max && e < 0.0f) || (u < r->out_min && e > 0.0f)) {
        if (r->ti > 0.0f)
            r->integral = r->integral + r->kp * e * r->dt / r->ti;
    }
    r->pv_old = pv;
}

static bool ready;
static int16_t tick;
static struct pid loops[LOOPS];
static float setpoint[LOOPS], level[LOOPS], lag[LOOPS];

void scan(void)
{
    int i;
    float sum;
    int32_t sat;

    if (!ready) {
        ready = true;
        for (i = 0; i < LOOPS; i++) {
            loops[i].kp = 0.8f + (float)i * 0.05f;
            loops[i].ti = 4.0f + (float)(i % 9);
            loops[i].td = (float)(i % 4) * 0.1f;
            loops[i].dt = 0.1f;
            loops[i].out_min = 0.0f;
            loops[i].out_max = 100.0f;
            setpoint[i] = 20.0f + (float)i;
            lag[i] = 0.02f + (float)(i % 5) * 0.01f;
        }
    }

    /* every 200 scans the operator moves the setpoints */
    tick++;
    if (tick >= 200) {
        tick = 0;
        for (i = 0; i < LOOPS; i++) {
            setpoint[i] += 15.0f;
            if (setpoint[i] > 90.0f)
                setpoint[i] -= 75.0f;
        }
    }

    sum = 0.0f;
    sat = 0;
    for (i = 0; i < LOOPS; i++) {
        pid_run(&loops[i], setpoint[i], level[i], i % 16 == 5 && tick < 50, 40.0f);
        /* process: first order lag with a loss */
        level[i] = level[i] + lag[i] * (1.2f * loops[i].y - level[i]) - 0.05f;
        sum += loops[i].y;
        if (loops[i].limited)
            sat++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 100.0f) + (uint32_t)sat);
}
