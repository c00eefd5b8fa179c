/* 64 PID loops with a simulated process each */
#include "st.h"
#include <stdbool.h>

typedef enum { MODE_OFF, MODE_MANUAL, MODE_AUTO } pid_mode_t;

#define CYCLE 0.01f
#define OUT_MIN 0.0f
#define OUT_MAX 100.0f
#define N_LOOP 64

static float limit_real(float min, float in, float max)
{
    if (in < min)
        return min;
    if (in > max)
        return max;
    return in;
}

static float deadband(float in, float band)
{
    float mag = in < 0.0f ? -in : in;
    return mag < band ? 0.0f : in;
}

typedef struct {
    float kp, tn, tv, band;
    float out;
    bool limit;
    float err_old, integ, der;
} pid_ctl_t;

static void pid_step(pid_ctl_t *p, pid_mode_t mode, float sp, float pv, float man)
{
    float err, sum;

    switch (mode) {
    case MODE_OFF:
        p->out = 0.0f;
        p->integ = 0.0f;
        p->der = 0.0f;
        p->err_old = 0.0f;
        p->limit = false;
        break;
    case MODE_MANUAL:
        p->out = limit_real(OUT_MIN, man, OUT_MAX);
        p->integ = p->out;
        p->err_old = sp - pv;
        p->limit = false;
        break;
    case MODE_AUTO:
        err = deadband(sp - pv, p->band);
        if (p->tn > 0.0f && !p->limit)
            p->integ = p->integ + p->kp * err * CYCLE / p->tn;
        p->der = p->der + 0.2f * (p->kp * p->tv * (err - p->err_old) / CYCLE - p->der);
        sum = p->kp * err + p->integ + p->der;
        p->out = limit_real(OUT_MIN, sum, OUT_MAX);
        p->limit = p->out != sum;
        p->err_old = err;
        break;
    }
}

typedef struct {
    float gain, t;
    float y, x;
} process_t;

static void process_step(process_t *p, float u)
{
    p->x = p->x + (u * p->gain - p->x) * 0.05f;
    p->y = p->y + (p->x - p->y) * p->t;
}

static bool init_done;
static int32_t scan_no;
static pid_ctl_t pid[N_LOOP];
static process_t process[N_LOOP];
static float setpoint[N_LOOP];
static pid_mode_t mode[N_LOOP];

void scan(void)
{
    int i;
    int32_t sum = 0;

    if (!init_done) {
        init_done = true;
        for (i = 0; i < N_LOOP; i++) {
            setpoint[i] = 20.0f + (float)i;
            pid[i].kp = 0.5f + (float)(i % 8) * 0.25f;
            pid[i].tn = 0.5f + (float)(i % 5) * 0.5f;
            pid[i].tv = (float)(i % 3) * 0.02f;
            pid[i].band = 0.05f;
            process[i].gain = 0.8f + (float)(i % 7) * 0.1f;
            process[i].t = 0.02f + (float)(i % 4) * 0.01f;
            mode[i] = MODE_AUTO;
        }
    }

    scan_no++;
    if (scan_no >= 2000)
        scan_no = 0;
    if (scan_no % 50 == 0) {
        i = scan_no / 50 * 7 % 64;
        setpoint[i] = 90.0f - setpoint[i];
        if (mode[i] == MODE_AUTO)
            mode[i] = MODE_MANUAL;
        else if (mode[i] == MODE_MANUAL && i % 4 == 0)
            mode[i] = MODE_OFF;
        else
            mode[i] = MODE_AUTO;
    }

    for (i = 0; i < N_LOOP; i++) {
        pid_step(&pid[i], mode[i], setpoint[i], process[i].y, 35.0f);
        process_step(&process[i], pid[i].out);
        if (pid[i].limit)
            sum += 1000;
        sum += (int32_t)(pid[i].out * 10.0f) + (int32_t)(process[i].y * 10.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
