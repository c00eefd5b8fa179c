#include <stdbool.h>
#include "st.h"

typedef struct { float kp, ti, td, min, max, rate, tau, gain; } Params;

typedef struct {
    float filtered, rate_out, integral, pv_old, out, err;
    bool saturated;
} Pid;

typedef struct {
    Pid pid;
    float plant1, plant2;
} Loop;

typedef struct { float abs_err, out_sum; int32_t sat; } Stats;

static Loop loops[64];
static Params params[64];
static Stats stats;
static int32_t scans;
static bool initialised;

static float limit(float lo, float x, float hi) { return x < lo ? lo : x > hi ? hi : x; }

static float deadband(float x, float band)
{
    if (x > band)
        return x - band;
    if (x < -band)
        return x + band;
    return 0.0f;
}

static void pid(Pid *p, const Params *par, float sp, float pv, float dt, bool automatic, float manual)
{
    p->filtered += (pv - p->filtered) * dt / (par->tau + dt);
    p->err = deadband(sp - p->filtered, 0.02f);
    float der = (p->filtered - p->pv_old) / dt;
    p->pv_old = p->filtered;

    float target;
    if (automatic) {
        float raw = par->kp * (p->err - par->td * der) + p->integral;
        p->saturated = raw > par->max || raw < par->min;
        if (!p->saturated)
            p->integral += par->kp * p->err * dt / par->ti;
        target = limit(par->min, raw, par->max);
    } else {
        p->saturated = false;
        p->integral = manual;
        target = manual;
    }
    float step = par->rate * dt;
    p->rate_out += limit(-step, target - p->rate_out, step);
    p->out = p->rate_out;
}

static void run_loop(Loop *l, const Params *par, float sp, float dist, bool automatic)
{
    pid(&l->pid, par, sp, l->plant2, 0.01f, automatic, 30.0f);
    l->plant1 += (par->gain * l->pid.out + dist - l->plant1) * 0.05f;
    l->plant2 += (l->plant1 - l->plant2) * 0.08f;
    stats.abs_err += __builtin_fabsf(l->pid.err);
    stats.out_sum += l->pid.out;
    if (l->pid.saturated)
        stats.sat++;
}

static void init(void)
{
    for (int i = 1; i <= 64; i++) {
        Params *p = &params[i - 1];
        p->kp = 0.8f + (float)(i % 7) * 0.1f;
        p->ti = 0.6f + (float)(i % 5) * 0.2f;
        p->td = 0.01f + (float)(i % 3) * 0.01f;
        p->min = 0.0f;
        p->max = 90.0f + (float)(i % 11);
        p->rate = 100.0f + (float)i * 5.0f;
        p->tau = 0.02f + (float)(i % 4) * 0.01f;
        p->gain = 0.9f + (float)(i % 9) * 0.05f;
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        init();
    }
    scans++;
    stats.abs_err = 0.0f;
    stats.out_sum = 0.0f;
    float base = (float)((scans / 250) % 4) * 15.0f + 20.0f;
    for (int i = 1; i <= 64; i++)
        run_loop(&loops[i - 1], &params[i - 1], base + (float)i * 0.25f, (float)((scans + i * 13) % 50) * 0.04f,
                 (scans + i * 31) % 600 > 60);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(stats.abs_err * 10.0f)
                      + (uint32_t)(int32_t)(stats.out_sum * 10.0f) + (uint32_t)stats.sat + 1u);
}
