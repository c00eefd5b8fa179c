/* 64 PID loops, each on a first order process */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float sp, pv, kp, ti, td, ts;
    bool man;
    float manval, outmin, outmax;
    float out;
    bool sat;
    float err, pv_old, d_filt, integ;
    bool started;
} pid_t_;

static float limit(float mn, float v, float mx)
{
    if (v < mn)
        return mn;
    if (v > mx)
        return mx;
    return v;
}

static void pid(pid_t_ *c, float sp, float pv, bool man, float manval)
{
    float p, u;

    c->sp = sp;
    c->pv = pv;
    c->man = man;
    c->manval = manval;

    c->err = sp - pv;
    if (!c->started) {
        c->pv_old = pv;
        c->started = true;
    }

    p = c->kp * c->err;
    c->d_filt = c->d_filt + 0.2f * (c->kp * c->td * (c->pv_old - pv) / c->ts - c->d_filt);
    c->pv_old = pv;

    if (man) {
        c->out = limit(c->outmin, manval, c->outmax);
        c->integ = c->out - p;
        c->sat = false;
        return;
    }

    u = p + c->integ + c->d_filt;
    if (u > c->outmax) {
        c->out = c->outmax;
        c->sat = true;
    } else if (u < c->outmin) {
        c->out = c->outmin;
        c->sat = true;
    } else {
        c->out = u;
        c->sat = false;
    }

    /* anti windup: integrate only away from the limit */
    if (!c->sat || (u > c->outmax && c->err < 0.0f) || (u < c->outmin && c->err > 0.0f)) {
        if (c->ti > 0.0f)
            c->integ = c->integ + c->kp * c->err * c->ts / c->ti;
    }
}

static pid_t_ loops[LOOPS];
static float sp[LOOPS], pv[LOOPS], gain[LOOPS], lag[LOOPS];
static int32_t cycle;
static bool ready;

void scan(void)
{
    int i, n;
    int32_t sum;

    if (!ready) {
        for (i = 0; i < LOOPS; i++) {
            n = i + 1;
            sp[i] = 20.0f + (float)n;
            gain[i] = 0.8f + (float)(n % 5) * 0.1f;
            lag[i] = 0.02f + (float)(n % 7) * 0.01f;
            loops[i].kp = 1.5f + (float)(n % 4) * 0.5f;
            loops[i].ti = 0.5f + (float)(n % 3) * 0.25f;
            loops[i].td = 0.01f;
            loops[i].ts = 0.01f;
            loops[i].outmin = 0.0f;
            loops[i].outmax = 100.0f;
        }
        ready = true;
    }

    cycle++;
    if (cycle % 200 == 0) {
        for (i = 0; i < LOOPS; i++) {
            if (sp[i] > 50.0f)
                sp[i] -= 30.0f;
            else
                sp[i] += 25.0f;
        }
    }

    sum = 0;
    for (i = 0; i < LOOPS; i++) {
        pid(&loops[i], sp[i], pv[i], (i + 1) % 16 == 0, 40.0f);
        pv[i] = pv[i] + lag[i] * (loops[i].out * gain[i] - pv[i]);
        sum += (int32_t)(loops[i].out * 100.0f);
        if (loops[i].sat)
            sum += 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
