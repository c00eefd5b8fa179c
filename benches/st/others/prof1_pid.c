#include "st.h"
#include <stdbool.h>

enum { LOOPS = 64 };

enum mode { MANUAL, AUTOMATIC, HOLD };

struct parameters {
    float gain, reset_time, rate_time, filter_time, out_low, out_high;
};

struct pid {
    float output, deviation;
    float integral, derivative, last_actual;
    bool limited;
};

struct process {
    float value, inner;
};

static struct pid pids[LOOPS];
static struct parameters parameters[LOOPS];
static struct process plants[LOOPS];
static int32_t scan_no;
static bool initialised;

static float limit(float low, float x, float high)
{
    return x < low ? low : x > high ? high : x;
}

static void pid_run(struct pid *p, const struct parameters *par, enum mode mode,
                    float setpoint, float actual, float manual, float cycle)
{
    p->deviation = setpoint - actual;
    switch (mode) {
    case MANUAL:
        p->output = limit(par->out_low, manual, par->out_high);
        p->integral = p->output - par->gain * p->deviation;
        p->derivative = 0.0f;
        p->limited = false;
        break;
    case AUTOMATIC: {
        float proportional = par->gain * p->deviation;
        float slope = (p->last_actual - actual) / cycle;
        p->derivative += (par->gain * par->rate_time * slope - p->derivative) * cycle
                         / (par->filter_time + cycle);
        float raw = proportional + p->integral + p->derivative;
        p->output = limit(par->out_low, raw, par->out_high);
        p->limited = raw != p->output;
        if (!p->limited)
            p->integral += proportional * cycle / par->reset_time;
        break;
    }
    case HOLD:
        p->limited = false;
        break;
    }
    p->last_actual = actual;
}

static void process_run(struct process *p, float drive, float load, float lag)
{
    p->inner += (drive - p->inner) * lag;
    p->value += (p->inner - load - p->value) * lag * 0.5f;
}

static enum mode mode_of(int32_t phase)
{
    if (phase < 40)
        return MANUAL;
    if (phase < 480)
        return AUTOMATIC;
    return HOLD;
}

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < LOOPS; i++) {
            parameters[i] = (struct parameters){
                .gain = 0.5f + (float)(i % 8) * 0.25f,
                .reset_time = 0.2f + (float)(i % 5) * 0.1f,
                .rate_time = (float)(i % 3) * 0.02f,
                .filter_time = 0.05f,
                .out_low = 0.0f,
                .out_high = 80.0f + (float)(i % 4) * 10.0f,
            };
        }
        initialised = true;
    }

    float sum = 0.0f;
    int32_t at_limit = 0;
    for (int i = 0; i < LOOPS; i++) {
        struct pid *p = &pids[i];
        int32_t phase = (scan_no + 8 * i) % 512;
        float setpoint = phase < 256 ? 30.0f : 60.0f + (float)i * 0.25f;
        pid_run(p, &parameters[i], mode_of(phase), setpoint, plants[i].value, 25.0f, 0.01f);
        process_run(&plants[i], p->output, (float)(i % 6), 0.1f);
        sum = sum + p->output - 0.5f * p->deviation;
        if (p->limited)
            at_limit++;
    }
    scan_no++;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 100.0f)
                      + (uint32_t)at_limit);
}
