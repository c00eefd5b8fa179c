/* 64 temperature loops of fermentation tanks with their cooling jackets. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define LOOPS 64
#define DT 0.01f

struct pid_param {
    float kp, ti, td, out_min, out_max;
};

struct pid {
    float out, integral, deriv, pv_last;
    bool sat;
};

struct jacket {
    float temp, jacket;
};

static struct pid pids[LOOPS];
static struct jacket jackets[LOOPS];
static struct pid_param params[LOOPS];
static float sp[LOOPS];
static bool init_done;
static int scans, step;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid_step(struct pid *p, const struct pid_param *par, float setpoint, float pv, float dt,
                     bool manual, float manual_out)
{
    float error = setpoint - pv;
    p->deriv = p->deriv * 0.8f + 0.2f * (p->pv_last - pv) / dt;
    p->pv_last = pv;

    if (manual) {
        p->out = clampf(par->out_min, manual_out, par->out_max);
        p->integral = p->out - par->kp * error;
        p->sat = false;
        return;
    }

    float raw = par->kp * (error + par->td * p->deriv) + p->integral;
    bool high = raw > par->out_max, low = raw < par->out_min;
    p->out = high ? par->out_max : low ? par->out_min : raw;
    p->sat = high || low;
    if (!p->sat || (high && error < 0.0f) || (low && error > 0.0f))
        p->integral += par->kp * error * dt / par->ti;
}

static void jacket_step(struct jacket *j, float valve, float load, float dt)
{
    j->jacket += (valve * 0.4f - j->jacket) * dt * 2.0f;
    j->temp += ((j->jacket - j->temp) * 0.8f + load) * dt;
}

static void init(void)
{
    for (int i = 0; i < LOOPS; i++) {
        int n = i + 1;
        sp[i] = 10.0f + (float)n * 0.2f;
        params[i] = (struct pid_param){
            .kp = 3.0f + (float)(n % 7) * 0.5f,
            .ti = 1.0f + (float)(n % 5) * 0.4f,
            .td = 0.05f,
            .out_min = 0.0f,
            .out_max = 100.0f,
        };
        jackets[i] = (struct jacket){8.0f, 8.0f};
    }
    init_done = true;
}

void scan(void)
{
    if (!init_done)
        init();

    scans = (scans + 1) % 1024;
    if (scans % 16 == 0) {
        sp[step] = 8.0f + (float)((scans + (step + 1) * 7) % 160) * 0.1f;
        step = (step + 1) % LOOPS;
    }

    uint32_t sum = 0;
    for (int i = 0; i < LOOPS; i++) {
        struct pid *p = &pids[i];
        struct jacket *j = &jackets[i];
        pid_step(p, &params[i], sp[i], j->temp, DT, (i + 1 + scans / 64) % 16 == 0, 35.0f);
        jacket_step(j, p->out, (float)((scans + i + 1) % 8) * 0.25f, DT);
        sum = sum * 3u + (uint32_t)lrintf(p->out * 100.0f) + (uint32_t)lrintf(j->temp * 1000.0f) + p->sat;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
