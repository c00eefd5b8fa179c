/* 64 PID controllers, each with a simulated plant. */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float kp, tn, tv, tf, cycle, min, max;
    float integral, deriv, actual_old;
    float out;
    bool limited;
} pid_t_;

typedef struct {
    float gain, t1, t2, cycle;
    float state, out;
} plant_t;

static inline float limit(float mn, float x, float mx)
{
    if (x < mn)
        x = mn;
    return x > mx ? mx : x;
}

static void pid(pid_t_ *p, float setpoint, float actual, bool manual, float manual_out)
{
    float error = setpoint - actual;
    p->deriv = p->deriv + ((p->actual_old - actual) * p->tv / p->cycle - p->deriv) * (p->cycle / (p->tf + p->cycle));
    p->actual_old = actual;

    if (manual) {
        p->out = limit(p->min, manual_out, p->max);
        p->integral = p->out - p->kp * error;
        p->limited = false;
    } else {
        float raw = p->kp * (error + p->deriv) + p->integral;
        p->out = limit(p->min, raw, p->max);
        p->limited = raw != p->out;
        if (!p->limited || (raw > p->max && error < 0.0f) || (raw < p->min && error > 0.0f))
            p->integral = p->integral + p->kp * error * p->cycle / p->tn;
    }
}

static void plant(plant_t *p, float in, float load)
{
    p->state = p->state + (in * p->gain - load - p->state) * (p->cycle / p->t1);
    p->out = p->out + (p->state - p->out) * (p->cycle / p->t2);
}

static int32_t scan_no;
static pid_t_ pids[65];
static plant_t plants[65];
static float setpoints[65];

void scan(void)
{
    if (scan_no == 0)
        for (int i = 1; i <= 64; i++) {
            pids[i] = (pid_t_){ .kp = 1.0f + (float)(i % 7) * 0.4f, .tn = 0.4f + (float)(i % 5) * 0.15f,
                                .tv = 0.08f, .tf = 0.05f, .cycle = 0.01f, .min = 0.0f, .max = 100.0f };
            plants[i] = (plant_t){ .gain = 0.8f + (float)(i % 9) * 0.1f, .t1 = 0.6f, .t2 = 0.2f, .cycle = 0.01f };
        }

    int32_t step = scan_no % 64 + 1;
    setpoints[step] = (float)(scan_no * 37 % 80) + 10.0f;
    float load = (float)(scan_no / 50 % 10) * 0.5f;
    scan_no = (scan_no + 1) % 1000000;

    int32_t sum = 0;
    for (int i = 1; i <= 64; i++) {
        pid(&pids[i], setpoints[i], plants[i].out, i == step, 50.0f);
        plant(&plants[i], pids[i].out, load);
        sum += (int32_t)(plants[i].out * 100.0f) + (int32_t)(pids[i].out * 10.0f);
        if (pids[i].limited)
            sum += i;
    }
    check = (check * 31 + sum) % 1000003;
}
