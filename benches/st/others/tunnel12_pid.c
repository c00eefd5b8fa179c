/* 64 control loops: air speed in the tunnel and levels in the pump sumps. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define CYCLE_TIME 0.01f

typedef struct {
    float kp, ti, td, cycle, out_min, out_max;
} pid_param_t;

typedef struct {
    float out;
    bool limited;
    float integral, last_actual, filtered;
} pid_ctrl_t;

typedef struct {
    float value, actuator;
} process_t;

static const pid_param_t param = {
    .kp = 1.5f, .ti = 0.4f, .td = 0.02f, .cycle = CYCLE_TIME,
    .out_min = 0.0f, .out_max = 100.0f,
};

static pid_ctrl_t pid[LOOPS];
static process_t process[LOOPS];
static float target[LOOPS];
static uint32_t seed = 12345;

static inline float limit(float lo, float v, float hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static void pid_update(pid_ctrl_t *p, const pid_param_t *k, float setpoint, float actual,
                       bool manual, float manual_value)
{
    float error = setpoint - actual;

    /* Derivative on the measured value, first-order filter */
    p->filtered += 0.2f * ((p->last_actual - actual) / k->cycle - p->filtered);
    p->last_actual = actual;

    if (manual) {
        p->out = limit(k->out_min, manual_value, k->out_max);
        p->integral = p->out - k->kp * error;
        p->limited = false;
        return;
    }

    float raw = k->kp * (error + k->td * p->filtered) + p->integral;
    p->out = limit(k->out_min, raw, k->out_max);
    p->limited = p->out != raw;

    /* Anti-windup: integrate only while not limited, or back from the limit */
    if (!p->limited || (raw > k->out_max && error < 0.0f) || (raw < k->out_min && error > 0.0f))
        p->integral += k->kp * error * k->cycle / k->ti;
}

/* Second-order process: actuator and air (or water) behind it */
static void process_update(process_t *p, float drive, float disturbance, float gain, float lag)
{
    p->actuator += (drive - p->actuator) * 0.25f;
    p->value += (gain * p->actuator - p->value + disturbance) * lag;
}

static inline uint32_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed;
}

void scan(void)
{
    /* One loop a scan gets a new setpoint */
    uint32_t r = next_random();
    int changed = (int)((r >> 16) % LOOPS);
    target[changed] = (float)((r / 1024) % 1000) * 0.1f;

    uint32_t sum = 17, at_limit = 0;
    for (int i = 0; i < LOOPS; i++) {
        float noise = (float)(next_random() >> 24) * 0.01f - 1.28f;
        process_update(&process[i], pid[i].out, noise, 0.8f + (float)(i + 1) * 0.01f, 0.05f);
        pid_update(&pid[i], &param, target[i], process[i].value, changed == i, 50.0f);
        if (pid[i].limited)
            at_limit++;
        sum = sum * 31u + (uint32_t)(int32_t)lrintf(pid[i].out * 100.0f);
        sum += (uint32_t)(int32_t)(process[i].value * 10.0f);
    }

    check = (int32_t)(sum * 31u + at_limit);
}
