/* 64 PID loops: level, flow, pressure and temperature control with a first order process each */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

struct pid {
    float kp, tn, tv, ta, dead_band, out_min, out_max;      /* settings */
    float out;
    bool lim_hi, lim_lo;
    float i_part, d_part, pv_old;
    bool started;
};

static bool init;
static int32_t scan_no;
static struct pid pid[LOOPS];
static float pv[LOOPS], sp[LOOPS], gain[LOOPS], lag[LOOPS];
static bool man[LOOPS];

static void pid_run(struct pid *c, float set, float act, bool manual, float man_out)
{
    float e, p_part, u;

    if (!c->started) {
        c->pv_old = act;
        c->started = true;
    }

    e = set - act;
    if (fabsf(e) < c->dead_band)
        e = 0.0f;

    p_part = c->kp * e;

    if (c->tv > 0.0f) {
        /* derivative of the process value, filtered with tv/5 */
        c->d_part = c->d_part + (-c->kp * c->tv * (act - c->pv_old) / c->ta - c->d_part)
                    * c->ta / (c->ta + c->tv * 0.2f);
    } else {
        c->d_part = 0.0f;
    }
    c->pv_old = act;

    if (manual) {
        c->out = man_out;
        c->i_part = man_out - p_part;       /* bumpless */
        c->lim_hi = false;
        c->lim_lo = false;
    } else {
        if (c->tn > 0.0f) {
            /* anti windup: do not integrate further into the limit */
            if (!(c->lim_hi && e > 0.0f) && !(c->lim_lo && e < 0.0f))
                c->i_part = c->i_part + c->kp * e * c->ta / c->tn;
        }
        u = p_part + c->i_part + c->d_part;
        c->lim_hi = u > c->out_max;
        c->lim_lo = u < c->out_min;
        if (c->lim_hi)
            c->out = c->out_max;
        else if (c->lim_lo)
            c->out = c->out_min;
        else
            c->out = u;
    }
}

void scan(void)
{
    int i, k;
    float sum;
    int32_t n_lim;

    if (!init) {
        for (i = 0; i < LOOPS; i++) {
            pid[i].kp = 0.8f + (float)(i % 8) * 0.2f;
            pid[i].tn = 4.0f + (float)(i % 5);
            pid[i].ta = 0.1f;
            pid[i].out_max = 100.0f;
            if (i % 4 == 3)
                pid[i].tv = 0.5f;
            pid[i].dead_band = 0.05f;
            gain[i] = 0.9f + (float)(i % 3) * 0.3f;
            lag[i] = 0.02f + (float)(i % 7) * 0.01f;
            sp[i] = 20.0f + (float)i;
        }
        init = true;
    }

    scan_no++;

    /* operator: step one setpoint every 16 scans, one loop to manual or back every 64 */
    if (scan_no % 16 == 0) {
        k = (scan_no / 16) % 64;
        sp[k] = 20.0f + (float)(scan_no % 83);
    }
    if (scan_no % 64 == 0) {
        k = (scan_no / 64 * 5) % 64;
        man[k] = !man[k];
    }

    sum = 0.0f;
    n_lim = 0;
    for (i = 0; i < LOOPS; i++) {
        pid_run(&pid[i], sp[i], pv[i], man[i], 35.0f);
        /* process */
        pv[i] = pv[i] + (gain[i] * pid[i].out - pv[i]) * lag[i];
        sum = sum + pid[i].out;
        if (pid[i].lim_hi || pid[i].lim_lo)
            n_lim++;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 10.0f) + n_lim));
}
