#include "st.h"
#include <xmmintrin.h>
#include <stdbool.h>

typedef struct {
    float kp, ti, td, cycle, out_min, out_max;
    float output;
    bool at_limit;
    float last_error, integral;
} pid_ctl;

static void pid_run(pid_ctl *p, float setpoint, float actual, bool manual, float man_value)
{
    float error = setpoint - actual;
    if (manual) {
        p->output = man_value;
        p->integral = man_value;
        p->at_limit = false;
    } else {
        float deriv = p->kp * p->td * (error - p->last_error) / p->cycle;
        float raw = p->kp * error + p->integral + deriv;
        if (raw > p->out_max) {
            p->output = p->out_max;
            p->at_limit = true;
        } else if (raw < p->out_min) {
            p->output = p->out_min;
            p->at_limit = true;
        } else {
            p->output = raw;
            p->at_limit = false;
            p->integral += p->kp * error * p->cycle / p->ti;
        }
    }
    p->last_error = error;
}

static pid_ctl loop[64];
static float temperature[64], setpoints[64];
static int32_t scans;

void scan(void)
{
    scans++;
    if (scans % 200 == 1)
        for (int i = 0; i < 64; i++)
            setpoints[i] = 40.0f + (scans / 200 * 13 + i + 1) % 50;
    bool manual = scans % 500 > 480;
    float sum = 0;
    int32_t limited = 0;
    for (int i = 0; i < 64; i++) {
        pid_ctl *p = &loop[i];
        p->kp = 4.0f;
        p->ti = 2.5f;
        p->td = 0.02f;
        p->cycle = 0.01f;
        p->out_min = 0.0f;
        p->out_max = 100.0f;
        pid_run(p, setpoints[i], temperature[i], manual && i >= 32, 35.0f);
        temperature[i] += (p->output * 1.2f + 15.0f - temperature[i]) * 0.02f;
        sum += temperature[i];
        if (p->at_limit)
            limited += i + 1;
    }
    check = (check + _mm_cvt_ss2si(_mm_set_ss(sum)) + limited) % 1000000;
}
