#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct {
    float kp, ti, td, min, max;
} PidPar;

typedef struct {
    float out;
    bool limit;
    float integ, act_old, d_filt;
} Pid;

static inline float clampf(float low, float x, float high)
{
    return x < low ? low : x > high ? high : x;
}

static inline void pid_run(Pid *p, const PidPar *par, bool enable, float set, float act, float dt)
{
    if (!enable) {
        p->integ = p->out;
        p->act_old = act;
        p->d_filt = 0.0f;
        p->limit = false;
        return;
    }
    float err = set - act;
    p->d_filt += 0.2f * ((p->act_old - act) / dt - p->d_filt);
    p->act_old = act;
    float raw = par->kp * (err + par->td * p->d_filt) + p->integ;
    p->out = clampf(par->min, raw, par->max);
    p->limit = p->out != raw;
    if (!p->limit)
        p->integ = clampf(par->min, p->integ + par->kp * err * dt / par->ti, par->max);
}

static Pid pid[LOOPS];
static PidPar par[LOOPS];
static float act[LOOPS], set[LOOPS];
static bool ready;
static int32_t scans;
static uint32_t crc;

void scan(void)
{
    if (!ready) {
        for (int n = 0; n < LOOPS; n++) {
            int i = n + 1;
            par[n].kp = 1.5f + (float)i * 0.05f;
            par[n].ti = 0.5f + (float)(i % 8) * 0.25f;
            par[n].td = 0.01f * (float)(i % 5);
            par[n].min = 0.0f;
            par[n].max = 100.0f;
            set[n] = 40.0f + (float)(i % 16);
            act[n] = 20.0f;
        }
        ready = true;
    }

    scans++;
    float sum = 0.0f;
    int lim = 0;
    for (int n = 0; n < LOOPS; n++) {
        int i = n + 1;
        if ((scans + i * 5) % 200 == 0)
            set[n] = 95.0f - set[n];
        pid_run(&pid[n], &par[n], (scans + i) % 150 > 4, set[n], act[n], 0.01f);
        act[n] = act[n] + (pid[n].out - act[n]) * 0.02f + (18.0f - act[n]) * 0.004f;
        lim += pid[n].limit;
        sum = sum + pid[n].out + act[n];
    }
    crc = crc * 31 + (uint32_t)(int32_t)lrintf(sum * 50.0f) + lim;
    check = (int32_t)crc;
}
