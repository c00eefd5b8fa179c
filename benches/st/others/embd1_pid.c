/* 64 PID loops, each with a first order plant */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define Y_MIN 0.0f
#define Y_MAX 100.0f

typedef struct {
    float y;
    bool limited;
    float integ;
    float last_pv;
    float d_filt;
} pid_ctl_t;

static pid_ctl_t pid[LOOPS];
static float temp[LOOPS];
static float target[LOOPS];
static float gain[LOOPS];
static int32_t cycle_no;
static bool init_done;

static float limit(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static void pid_run(pid_ctl_t *p, float sp, float pv, float kp, float ki, float kd, float dt,
                    bool manual, float man_y)
{
    float err, u;

    err = sp - pv;
    p->d_filt = p->d_filt + 0.2f * ((p->last_pv - pv) / dt - p->d_filt);
    p->last_pv = pv;

    if (manual) {
        p->y = limit(Y_MIN, man_y, Y_MAX);
        p->integ = p->y - kp * err;
        p->limited = false;
        return;
    }

    u = kp * err + p->integ + kd * p->d_filt;
    p->limited = false;
    if (u > Y_MAX) {
        u = Y_MAX;
        p->limited = true;
    } else if (u < Y_MIN) {
        u = Y_MIN;
        p->limited = true;
    }

    /* anti wind-up: stop integrating when the output is at a limit */
    if (!p->limited) {
        p->integ = p->integ + ki * err * dt;
        p->integ = limit(Y_MIN, p->integ, Y_MAX);
    }
    p->y = u;
}

void scan(void)
{
    int32_t i, n_lim;
    float total;

    if (!init_done) {
        for (i = 0; i < LOOPS; i++) {
            temp[i] = 20.0f + (float)i * 0.5f;
            target[i] = 60.0f;
            gain[i] = 0.8f + (float)i * 0.01f;
        }
        init_done = true;
    }

    cycle_no++;
    if (cycle_no % 200 == 0) {
        for (i = 0; i < LOOPS; i++)
            target[i] = 40.0f + (float)((cycle_no / 200 + i * 7) % 50);
    }

    n_lim = 0;
    total = 0.0f;
    for (i = 0; i < LOOPS; i++) {
        pid_run(&pid[i], target[i], temp[i], 2.0f, 0.5f, 0.05f, 0.01f,
                (cycle_no + i * 10) % 500 < 20, 35.0f);
        /* plant: heats with the output, cools towards 20 degrees */
        temp[i] = temp[i] + (gain[i] * pid[i].y - (temp[i] - 20.0f) * 0.7f) * 0.01f;
        if (pid[i].limited)
            n_lim++;
        total += pid[i].y;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 10.0f) + (uint32_t)n_lim
                      + (uint32_t)(int32_t)(temp[cycle_no % LOOPS] * 100.0f));
}
