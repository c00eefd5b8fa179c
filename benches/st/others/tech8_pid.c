#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define TS 0.1f
#define OUT_MIN 0.0f
#define OUT_MAX 100.0f
#define MAX_STEP 8.0f
#define DEADBAND 0.05f

enum mode { MANUAL, AUTOMATIC, HOLD };

struct pid {
    float kp, ti, td, manual;
    float output, integral, derivative, last_actual, target;
    bool saturated;
};

struct loop {
    struct pid pid;
    float plant, setpoint, gain, speed;
    enum mode mode;
};

static struct loop loops[LOOPS];
static bool initialised;
static int32_t scan_no;

static float limited(float low, float value, float high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}

static void pid_update(struct pid *p, float setpoint, float actual, enum mode mode)
{
    float error = setpoint - actual;
    if (fabsf(error) < DEADBAND)
        error = 0.0f;
    p->derivative = p->derivative * 0.8f + 0.2f * (p->last_actual - actual) / TS;
    p->last_actual = actual;

    switch (mode) {
    case MANUAL:
        p->target = limited(OUT_MIN, p->manual, OUT_MAX);
        p->integral = p->target - p->kp * error;
        p->saturated = false;
        break;
    case AUTOMATIC: {
        float raw = p->kp * error + p->integral + p->kp * p->td * p->derivative;
        p->target = limited(OUT_MIN, raw, OUT_MAX);
        p->saturated = raw != p->target;
        if (!p->saturated || (raw > OUT_MAX && error < 0.0f) || (raw < OUT_MIN && error > 0.0f))
            p->integral += p->kp * error * TS / p->ti;
        break;
    }
    default:
        p->saturated = false;
        break;
    }
    p->output = limited(p->output - MAX_STEP, p->target, p->output + MAX_STEP);
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < LOOPS; i++) {
            struct loop *l = &loops[i];
            int n = i + 1;
            l->setpoint = 20.0f + (float)n;
            l->gain = 0.8f + (float)n / 100.0f;
            l->speed = 0.02f + (float)n / 1000.0f;
            l->mode = AUTOMATIC;
            l->pid.kp = 1.0f + (float)n / 32.0f;
            l->pid.ti = 0.5f + (float)n / 16.0f;
            l->pid.td = (float)(n % 5) / 20.0f;
            l->pid.manual = (float)(n * 2);
        }
    }

    struct loop *l = &loops[scan_no % 64];
    l->setpoint = (float)(scan_no * 7 % 110);
    switch (l->mode) {
    case MANUAL:
        l->mode = AUTOMATIC;
        break;
    case AUTOMATIC:
        if (scan_no / 64 % 4 == 3)
            l->mode = HOLD;
        break;
    case HOLD:
        l->mode = MANUAL;
        break;
    }
    scan_no = (scan_no + 1) % 100000;

    float sum = 0.0f;
    int32_t limits = 0;
    for (int i = 0; i < LOOPS; i++) {
        l = &loops[i];
        pid_update(&l->pid, l->setpoint, l->plant, l->mode);
        l->plant += l->speed * (l->gain * l->pid.output - l->plant);
        sum += l->pid.output;
        if (l->pid.saturated)
            limits++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(sum * 100.0f) + (uint32_t)limits);
}
