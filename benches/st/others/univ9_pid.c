#include "st.h"
#include <math.h>
#include <stdbool.h>

#define LOOPS 64
#define CYCLE 0.01f
#define OUT_MIN 0.0f
#define OUT_MAX 100.0f
#define FILTER 0.2f

struct pid {
    float kp, ti, td;
    float integral, derivative, last_actual;
    float out;
    bool limited;
};

struct process { float gain, alpha, y; };

static struct pid pids[LOOPS];
static struct process processes[LOOPS];
static float target[LOOPS];
static bool ready;
static int scans;

static void pid_update(struct pid *p, float setpoint, float actual, bool manual, float man_value)
{
    float error = setpoint - actual;
    p->derivative += FILTER * (p->kp * p->td * (p->last_actual - actual) / CYCLE - p->derivative);
    p->last_actual = actual;

    if (manual) {
        p->out = man_value < OUT_MIN ? OUT_MIN : man_value > OUT_MAX ? OUT_MAX : man_value;
        p->limited = false;
        p->integral = p->out - p->kp * error;
        return;
    }
    float raw = p->kp * error + p->integral + p->derivative;
    bool high = raw > OUT_MAX, low = raw < OUT_MIN;
    p->limited = high || low;
    p->out = high ? OUT_MAX : low ? OUT_MIN : raw;
    if (!p->limited || (high && error < 0.0f) || (low && error > 0.0f))
        p->integral += p->kp * error * CYCLE / p->ti;
}

static void process_update(struct process *p, float u, float load)
{
    p->y += p->alpha * (p->gain * u - load - p->y);
}

static void add_check(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

void scan(void)
{
    if (!ready) {
        for (int k = 0; k < LOOPS; k++) {
            int i = k + 1;
            pids[k].kp = 0.8f + (float)i * 0.05f;
            pids[k].ti = 0.2f + (float)(i % 8) * 0.1f;
            pids[k].td = (float)(i % 4) * 0.002f;
            processes[k].gain = 0.9f + (float)(i % 5) * 0.1f;
            processes[k].alpha = 0.02f + (float)(i % 7) * 0.01f;
            target[k] = 20.0f + (float)i;
        }
        ready = true;
    }

    if (++scans >= 640)
        scans = 0;
    if (scans % 10 == 0)
        target[scans / 10] = 100.0f - target[scans / 10];
    float load = scans < 320 ? 2.0f : 8.0f;

    float sum_out = 0.0f, sum_y = 0.0f;
    int limited = 0;
    for (int k = 0; k < LOOPS; k++) {
        int pos = (k + 1) * 10;
        pid_update(&pids[k], target[k], processes[k].y,
                   pos > scans && pos < scans + 40, 35.0f);
        process_update(&processes[k], pids[k].out, load);
        sum_out += pids[k].out;
        sum_y += processes[k].y;
        limited += pids[k].limited;
    }
    add_check((int32_t)lrintf(sum_out * 100.0f));
    add_check((int32_t)lrintf(sum_y * 100.0f));
    add_check(limited);
}
