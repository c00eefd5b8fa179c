#include <stdbool.h>
#include <xmmintrin.h>
#include "st.h"

/* Rounds to the nearest, halves to even (no libm here, so no lrintf). */
static int32_t real_to_dint(float x)
{
    return _mm_cvtss_si32(_mm_set_ss(x));
}

#define LOOPS 64

typedef enum { MODE_OFF, MODE_MANUAL, MODE_AUTO } pid_mode_t;

typedef struct {
    float kp, ti, td;
    float out_min, out_max;
} pid_par_t;

typedef struct {
    pid_mode_t mode;
    float setpoint, actual, manual, cycle;
    float out;
    bool limit;
    float integral, error_old, deriv;
} pid_loop_t;

typedef struct {
    float in, gain, lag;
    float value;
} process_t;

static float limit(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static void pid(pid_loop_t *p, const pid_par_t *par)
{
    float error = p->setpoint - p->actual;
    switch (p->mode) {
    case MODE_OFF:
        p->out = 0.0f;
        p->integral = 0.0f;
        p->deriv = 0.0f;
        p->limit = false;
        break;
    case MODE_MANUAL:
        p->out = limit(par->out_min, p->manual, par->out_max);
        p->integral = p->out;
        p->limit = false;
        break;
    case MODE_AUTO: {
        float prop = par->kp * error;
        float d = 0.0f;
        if (par->td > 0.0f)
            d = par->kp * par->td * (error - p->error_old) / p->cycle;
        p->deriv = p->deriv + 0.2f * (d - p->deriv);
        float sum = prop + p->integral + p->deriv;
        p->limit = sum > par->out_max || sum < par->out_min;
        p->out = limit(par->out_min, sum, par->out_max);
        if (!p->limit && par->ti > 0.0f)
            p->integral = p->integral + par->kp * error * p->cycle / par->ti;
        break;
    }
    }
    p->error_old = error;
}

static void process(process_t *p)
{
    p->value = p->value + (p->in * p->gain - p->value) * p->lag;
}

static pid_loop_t pids[LOOPS];
static process_t processes[LOOPS];
static pid_par_t pars[LOOPS];
static pid_mode_t modes[LOOPS];
static float setpoints[LOOPS];
static bool init_done;
static int16_t scans;

void scan(void)
{
    if (!init_done) {
        for (int i = 1; i <= LOOPS; i++) {
            pars[i - 1].kp = 0.5f + (float)i * 0.03f;
            pars[i - 1].ti = 0.2f + (float)(i % 9) * 0.05f;
            pars[i - 1].td = (float)(i % 3) * 0.004f;
            pars[i - 1].out_min = 0.0f;
            pars[i - 1].out_max = 100.0f;
            setpoints[i - 1] = 20.0f + (float)(i % 50);
            modes[i - 1] = MODE_AUTO;
            pids[i - 1].cycle = 0.01f;
        }
        init_done = true;
    }

    scans = (int16_t)((scans + 1) % 9973);
    int which = scans % LOOPS;
    setpoints[which] = 10.0f + (float)(scans % 83);
    switch (scans % 23) {
    case 0:
        modes[which] = MODE_OFF;
        break;
    case 1:
    case 2:
    case 3:
        modes[which] = MODE_MANUAL;
        break;
    default:
        modes[which] = MODE_AUTO;
        break;
    }

    for (int i = 0; i < LOOPS; i++) {
        pids[i].mode = modes[i];
        pids[i].setpoint = setpoints[i];
        pids[i].actual = processes[i].value;
        pids[i].manual = 35.0f;
        pid(&pids[i], &pars[i]);
        processes[i].in = pids[i].out;
        processes[i].gain = 1.2f;
        processes[i].lag = 0.05f;
        process(&processes[i]);
    }

    for (int i = 0; i < LOOPS; i++) {
        check += real_to_dint(processes[i].value * 10.0f);
        if (pids[i].limit)
            check += 1000;
    }
}
