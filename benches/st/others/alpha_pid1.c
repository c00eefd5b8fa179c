/* 64 temperature loops: position PID with filtered derivative, anti-windup, bumpless manual, simple plant */
#include <stdbool.h>
#include "st.h"

typedef struct { float kp, ti, td, tf, out_min, out_max, deadband; } PidPar;

typedef struct {
    float out, err;
    bool limited;
    float integ, pv_old, d_filt;
    bool started;
} Pid;

static float absf(float x) { return x < 0.0f ? -x : x; }
static float limitf(float mn, float x, float mx)
{
    if (x < mn) x = mn;
    if (x > mx) x = mx;
    return x;
}

static void pid_ctl(Pid *c, float sp, float pv, bool manual, float man_out, const PidPar *par, float dt)
{
    float p, raw;
    if (!c->started) {
        c->pv_old = pv;
        c->started = true;
    }
    c->err = sp - pv;
    if (absf(c->err) < par->deadband)
        c->err = 0.0f;
    p = par->kp * c->err;
    c->d_filt = c->d_filt + ((c->pv_old - pv) * par->td / dt - c->d_filt) * dt / (par->tf + dt);
    c->pv_old = pv;
    if (manual) {
        c->out = limitf(par->out_min, man_out, par->out_max);
        c->integ = c->out - p;
        c->limited = false;
    } else {
        raw = p + c->integ + par->kp * c->d_filt;
        if (raw > par->out_max) {
            c->out = par->out_max;
            c->limited = true;
            if (c->err < 0.0f) c->integ = c->integ + par->kp * c->err * dt / par->ti;
        } else if (raw < par->out_min) {
            c->out = par->out_min;
            c->limited = true;
            if (c->err > 0.0f) c->integ = c->integ + par->kp * c->err * dt / par->ti;
        } else {
            c->out = raw;
            c->limited = false;
            c->integ = c->integ + par->kp * c->err * dt / par->ti;
        }
    }
}

static bool first = true;
static int32_t cycle;
static Pid pid[64];
static PidPar par[64];
static float temp[64], heat[64];

void scan(void)
{
    int i;
    int32_t limits = 0;
    if (first) {
        for (i = 0; i < 64; i++) {
            int n = i + 1;
            par[i].kp = 1.5f + (float)(n % 8) * 0.25f;
            par[i].ti = 12.0f + (float)(n % 5) * 2.0f;
            par[i].td = 1.0f;
            par[i].tf = 0.25f;
            par[i].out_min = 0.0f;
            par[i].out_max = 100.0f;
            par[i].deadband = 0.02f;
            temp[i] = 20.0f;
        }
        first = false;
    }
    cycle++;
    for (i = 0; i < 64; i++) {
        int n = i + 1;
        float sp = 80.0f + (float)n * 0.5f;
        if ((cycle + n * 13) % 1200 < 600)
            sp = sp + 25.0f;
        pid_ctl(&pid[i], sp, temp[i], (cycle + n) % 500 < 20, 42.0f, &par[i], 0.1f);
        heat[i] = heat[i] + (pid[i].out - heat[i]) * 0.08f;
        temp[i] = temp[i] + (heat[i] * 1.8f + 20.0f - temp[i]) * 0.01f;
        if (pid[i].limited) limits++;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(pid[i].out * 100.0f) + (uint32_t)(int32_t)(temp[i] * 10.0f));
    }
    check = (int32_t)((uint32_t)check + (uint32_t)limits);
}
