/* Temperature control of a sealing machine: 64 heating zones */
#include "st.h"
#include <stdbool.h>
#include <math.h>

#define ZONES 64

enum pid_mode { PID_OFF, PID_MANUAL, PID_AUTO, PID_HOLD };

struct pid_param {
    float kp, ti, td, filter, deadband, out_min, out_max;
};

struct zone {
    enum pid_mode mode;
    float setpoint, temperature, ambient, gain, tau, heater;
};

struct pid {
    float output, integral, derivative, last_actual;
    bool saturated;
};

static struct zone zones[ZONES];
static struct pid_param params[ZONES];
static struct pid loops[ZONES];
static bool started;
static int scans;

static float clamp(float lo, float v, float hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static float apply_deadband(float v, float band)
{
    if (v > band)
        return v - band;
    if (v < -band)
        return v + band;
    return 0.0f;
}

static void pid_update(struct pid *p, const struct pid_param *par, enum pid_mode mode,
                       float setpoint, float actual, float manual, float dt)
{
    p->saturated = false;
    switch (mode) {
    case PID_OFF:
        p->integral = p->derivative = p->output = 0.0f;
        break;
    case PID_MANUAL:
        p->output = clamp(par->out_min, manual, par->out_max);
        p->integral = p->output;
        p->derivative = 0.0f;
        break;
    case PID_AUTO: {
        float error = apply_deadband(setpoint - actual, par->deadband);
        p->derivative += par->filter * ((p->last_actual - actual) / dt - p->derivative);
        float raw = par->kp * (error + par->td * p->derivative) + p->integral;
        p->output = clamp(par->out_min, raw, par->out_max);
        p->saturated = p->output != raw;
        if (!p->saturated || (raw > par->out_max && error < 0.0f) || (raw < par->out_min && error > 0.0f))
            p->integral += par->kp * error * dt / par->ti;
        break;
    }
    case PID_HOLD:
        break;
    }
    p->last_actual = actual;
}

static void heat_zone(struct zone *z, float dt)
{
    float target = z->ambient + z->gain * z->heater;
    z->temperature += (target - z->temperature) * dt / z->tau;
}

static void init(void)
{
    for (int i = 0; i < ZONES; i++) {
        params[i] = (struct pid_param){
            .kp = 1.5f + (float)(i % 8) * 0.25f, .ti = 8.0f + (float)(i % 5), .td = 0.4f,
            .filter = 0.2f, .deadband = 0.05f, .out_min = 0.0f, .out_max = 100.0f };
        zones[i] = (struct zone){
            .mode = PID_AUTO, .setpoint = 120.0f + (float)i, .ambient = 20.0f,
            .temperature = 20.0f, .gain = 2.0f, .tau = 5.0f + (float)(i % 7) * 0.5f };
    }
    started = true;
}

void scan(void)
{
    const float dt = 0.1f;
    if (!started)
        init();

    scans = (scans + 1) % 6400;
    struct zone *z = &zones[scans * 5 % ZONES];
    z->setpoint = 100.0f + (float)(scans % 83);
    switch (scans % 11) {
    case 0: z->mode = PID_MANUAL; break;
    case 3: z->mode = PID_HOLD; break;
    case 7: z->mode = PID_OFF; break;
    default: z->mode = PID_AUTO; break;
    }

    float sum = 0.0f;
    int limited = 0;
    for (int i = 0; i < ZONES; i++) {
        pid_update(&loops[i], &params[i], zones[i].mode, zones[i].setpoint, zones[i].temperature, 45.0f, dt);
        zones[i].heater = loops[i].output;
        heat_zone(&zones[i], dt);
        sum = sum + loops[i].output + zones[i].temperature;
        limited += loops[i].saturated;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(sum * 50.0f) + (uint32_t)limited);
}
