/* Chapter 9: closed loops. 64 sealing-bar temperatures with PID control and a simulated bar. */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float set_point, actual;
    float kp, ti, td, cycle;
    float out_min, out_max;
    bool manual;
    float manual_out;
    float out;
    bool limited;
    float integral, last_actual, d_filter;
    bool started;
} PidLoop;

typedef struct {
    float power, ambient;
    float temperature;
    float heater;
} SealingBar;

static float limit(float mn, float x, float mx)
{
    if (x < mn)
        return mn;
    if (x > mx)
        return mx;
    return x;
}

static void pid_loop(PidLoop *p)
{
    float error, p_part, d_part, raw;

    if (!p->started) {
        p->started = true;
        p->last_actual = p->actual;
    }

    error = p->set_point - p->actual;
    p_part = p->kp * error;

    d_part = p->kp * p->td * (p->last_actual - p->actual) / p->cycle;
    p->d_filter = p->d_filter + 0.25f * (d_part - p->d_filter);
    p->last_actual = p->actual;

    if (p->manual) {
        p->out = limit(p->out_min, p->manual_out, p->out_max);
        p->integral = p->out - p_part;
        p->limited = false;
    } else {
        raw = p_part + p->integral + p->d_filter;
        p->out = limit(p->out_min, raw, p->out_max);
        p->limited = p->out != raw;
        /* integrate only while the output is free, or when it leads back */
        if (!p->limited || (raw > p->out_max && error < 0.0f) || (raw < p->out_min && error > 0.0f))
            p->integral = p->integral + p->kp * error * p->cycle / p->ti;
    }
}

static void sealing_bar(SealingBar *b, float power, float ambient)
{
    b->power = power;
    b->ambient = ambient;
    b->heater = b->heater + 0.08f * (b->power * 3.0f - (b->heater - b->temperature) * 0.9f);
    b->temperature = b->temperature + 0.02f * (b->heater - b->temperature)
                   - 0.004f * (b->temperature - b->ambient);
}

static bool first = true;
static PidLoop loop[LOOPS];
static SealingBar bar[LOOPS];
static float target[LOOPS];
static float ramped[LOOPS];
static int32_t scan_no;

void scan(void)
{
    int i, sample;
    float diff, sum_temp, sum_out;
    int32_t limited_count;
    bool hand;

    if (first) {
        first = false;
        for (i = 0; i < LOOPS; i++) {
            int n = i + 1;
            loop[i].kp = 0.5f + (float)(n % 8) * 0.1f;
            loop[i].ti = 8.0f + (float)(n % 5);
            loop[i].td = (float)(n % 3) * 0.2f;
            loop[i].cycle = 0.1f;
            loop[i].out_min = 0.0f;
            loop[i].out_max = 100.0f;
            bar[i].temperature = 20.0f;
            bar[i].heater = 20.0f;
            target[i] = 120.0f + (float)(n % 16) * 2.5f;
            ramped[i] = 20.0f;
        }
    }

    scan_no++;
    if (scan_no % 500 == 0) {
        for (i = 0; i < LOOPS; i++)
            target[i] = 280.0f - target[i];
    }
    hand = scan_no % 1000 > 950;

    sum_temp = 0.0f;
    sum_out = 0.0f;
    limited_count = 0;
    /* eight samples a scan */
    for (sample = 0; sample < 8; sample++) {
        for (i = 0; i < LOOPS; i++) {
            diff = limit(-0.5f, target[i] - ramped[i], 0.5f);
            ramped[i] = ramped[i] + diff;

            loop[i].set_point = ramped[i];
            loop[i].actual = bar[i].temperature;
            loop[i].manual = hand && (i + 1) % 4 == 0;
            loop[i].manual_out = 35.0f;
            pid_loop(&loop[i]);
            sealing_bar(&bar[i], loop[i].out, 20.0f);

            sum_temp += bar[i].temperature;
            sum_out += loop[i].out;
            if (loop[i].limited)
                limited_count++;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum_temp * 100.0f)
            + (uint32_t)(int32_t)(sum_out * 100.0f) + (uint32_t)limited_count);
}
