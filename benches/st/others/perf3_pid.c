/* 64 temperature zones: a PID with filtered derivative, bounds and anti-windup, and a model of each zone */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define ZONES 64
#define DT 0.01f

struct pid {
    float kp, ti, td;
    float integral, filtered, last_actual;
    float out;
    bool saturated;
};

static void pid_run(struct pid *p, float setpoint, float actual, bool manual, float manual_out)
{
    float err = setpoint - actual;
    if (fabsf(err) < 0.05f)
        err = 0.0f;
    p->filtered += 0.2f * ((p->last_actual - actual) / DT - p->filtered);
    p->last_actual = actual;
    if (manual) {
        p->out = manual_out;
        p->integral = manual_out - p->kp * err;
        p->saturated = false;
    } else {
        float raw = p->kp * (err + p->td * p->filtered) + p->integral;
        p->out = raw < 0.0f ? 0.0f : raw > 100.0f ? 100.0f : raw;
        p->saturated = p->out != raw;
        if (!p->saturated || (raw > 100.0f) != (err > 0.0f))
            p->integral += p->kp * err * DT / p->ti;
    }
}

static struct pid loops[ZONES];
static float temperature[ZONES], gain[ZONES], wanted[ZONES];
static bool ready;
static int tick;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < ZONES; i++) {
            temperature[i] = 20.0f;
            wanted[i] = 60.0f + (float)i;
            gain[i] = 1.5f + 0.02f * (float)i;
            loops[i].kp = 2.0f + 0.05f * (float)i;
            loops[i].ti = 0.8f + 0.01f * (float)i;
            loops[i].td = 0.02f;
        }
        ready = true;
    }
    if (++tick > 255)
        tick = 0;
    wanted[tick % ZONES] = 190.0f - wanted[tick % ZONES];

    float sum = 0.0f;
    int32_t bounds = 0;
    for (int i = 0; i < ZONES; i++) {
        pid_run(&loops[i], wanted[i], temperature[i], tick / 8 == i, 40.0f);
        temperature[i] += 0.02f * (gain[i] * loops[i].out - (temperature[i] - 20.0f));
        sum += loops[i].out;
        if (loops[i].saturated)
            bounds += i + 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 100.0f) + (uint32_t)bounds);
}
