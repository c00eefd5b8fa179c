/* 64 sealing-bar heating zones under PID control */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define ZONES 64
#define CYCLE 0.01f
#define AMBIENT 20.0f

typedef struct {
    float kp, tn, tv, out_min, out_max;
} pid_par_t;

typedef struct {
    float integral, diff, actual_old;
    float out;
    bool limited, started;
} pid_t_;

typedef struct {
    float temp, setpoint, power, tau, gain;
    pid_par_t par;
    pid_t_ pid;
} zone_t;

static zone_t zone[ZONES];
static bool initialised, down;
static int tri;

static inline float clampf(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static float pid_update(pid_t_ *p, const pid_par_t *par, float setpoint, float actual, float cycle)
{
    if (!p->started) {
        p->started = true;
        p->actual_old = actual;
    }
    float error = setpoint - actual;
    p->diff += 0.25f * (par->kp * par->tv * (p->actual_old - actual) / cycle - p->diff);
    p->actual_old = actual;

    float sum = par->kp * error + p->integral + p->diff;
    bool high = sum > par->out_max;
    bool low = sum < par->out_min;
    p->out = clampf(par->out_min, sum, par->out_max);
    p->limited = high || low;
    if (!p->limited || (high && error < 0.0f) || (low && error > 0.0f))
        p->integral += par->kp * error * cycle / par->tn;
    return p->out;
}

static void init(void)
{
    for (int i = 1; i <= ZONES; i++) {
        zone_t *z = &zone[i - 1];
        z->par.kp = 2.0f + (float)(i % 8) * 0.25f;
        z->par.tn = 1.5f + (float)(i % 5) * 0.5f;
        z->par.tv = 0.05f + (float)(i % 3) * 0.02f;
        z->par.out_min = 0.0f;
        z->par.out_max = 100.0f;
        z->temp = 20.0f;
        z->tau = 1.0f + (float)(i % 7) * 0.3f;
        z->gain = 2.5f + (float)(i % 4) * 0.2f;
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        init();
    }
    if (down) {
        tri--;
        down = tri > 0;
    } else {
        tri++;
        down = tri >= 400;
    }
    float offset = (float)tri * 0.2f;

    int limited = 0;
    float power_sum = 0.0f, temp_sum = 0.0f;
    for (int i = 0; i < ZONES; i++) {
        zone_t *z = &zone[i];
        z->setpoint = 120.0f + (float)(i + 1) * 0.5f + offset;
        z->power = pid_update(&z->pid, &z->par, z->setpoint, z->temp, CYCLE);
        z->temp += (z->power * z->gain + AMBIENT - z->temp) * CYCLE / z->tau;
        limited += z->pid.limited;
        power_sum += z->power;
        temp_sum += z->temp;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)lrintf(power_sum * 10.0f) +
                      (uint32_t)lrintf(temp_sum * 10.0f) * 3u + (uint32_t)limited);
}
