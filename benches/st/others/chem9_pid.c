#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define TS 0.1f

typedef struct { float kp, ti, td, n_filt, out_min, out_max, rate; } pid_par;

typedef struct {
    float out, dev;
    float i_part, d_part, pv_old;
    bool limited, started;
} pid;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid_update(pid *c, const pid_par *par, float sp, float pv, float man, bool auto_on, float ts)
{
    if (!c->started) {
        c->pv_old = pv;
        c->started = true;
    }
    float dev = c->dev = sp - pv;
    float p = par->kp * dev;
    float d_raw = par->kp * par->td * (c->pv_old - pv) / ts;
    c->d_part += par->n_filt * (d_raw - c->d_part);
    c->pv_old = pv;

    float target;
    if (auto_on) {
        float u = p + c->i_part + c->d_part;
        target = limit(par->out_min, u, par->out_max);
        c->limited = u != target;
        if (!c->limited || (u > par->out_max && dev < 0.0f) || (u < par->out_min && dev > 0.0f))
            c->i_part += par->kp * ts / par->ti * dev;
    } else {
        target = limit(par->out_min, man, par->out_max);
        c->i_part = target - p;
        c->limited = false;
    }
    c->out = limit(c->out - par->rate, target, c->out + par->rate);
}

static pid_par par[LOOPS];
static pid pids[LOOPS];
static float plant[LOOPS];
static float sp[LOOPS];
static bool init_done;
static int32_t scan_no;

static void process_update(float *y, float u, float dist, float gain, float tau, float ts)
{
    *y += (gain * u + dist - *y) * ts / tau;
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < LOOPS; i++) {
            int k = i + 1;
            par[i] = (pid_par){
                .kp = 0.8f + 0.05f * (float)(k % 16),
                .ti = 4.0f + (float)(k % 7),
                .td = k % 3 == 0 ? 0.4f : 0.0f,
                .n_filt = 0.2f,
                .out_min = 0.0f,
                .out_max = 100.0f,
                .rate = k % 5 == 0 ? 2.0f : 5.0f,
            };
            sp[i] = 20.0f + (float)k;
        }
        init_done = true;
    }

    scan_no++;
    sp[scan_no % 64] = 10.0f + (float)((int32_t)((uint32_t)scan_no * 37u) % 80);
    float dist = (float)(scan_no % 200) * 0.02f - 2.0f;

    float sum_out = 0.0f, worst = 0.0f;
    int n_limited = 0;
    for (int i = 0; i < LOOPS; i++) {
        bool auto_on = (scan_no + i + 1) % 500 >= 40;
        pid *c = &pids[i];
        pid_update(c, &par[i], sp[i], plant[i], 35.0f, auto_on, TS);
        process_update(&plant[i], c->out, dist, 0.9f, 2.0f + 0.1f * (float)(i + 1), TS);
        sum_out += c->out;
        float e = fabsf(c->dev);
        if (e > worst)
            worst = e;
        n_limited += c->limited;
    }

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + (uint32_t)(int32_t)lrintf(sum_out * 100.0f);
    sum = sum * 31 + (uint32_t)(int32_t)lrintf(worst * 1000.0f);
    check = (int32_t)(sum * 31 + (uint32_t)n_limited);
}
