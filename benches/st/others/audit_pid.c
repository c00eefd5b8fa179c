/* 64 PID loops, each with a simulated first order process */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float sp, pv, kp, ti, td, dt;
    bool manual;
    float man_out;
    float out;
    bool at_limit;
    float integral, last_pv, d_filt;
} Pid;

static void pid_run(Pid *l)
{
    float err = l->sp - l->pv;
    float p = l->kp * err;
    float d = (l->last_pv - l->pv) / l->dt;
    float u;

    l->d_filt = l->d_filt + (d - l->d_filt) * 0.2f;
    l->last_pv = l->pv;
    if (l->manual) {
        u = l->man_out;
        l->integral = l->man_out - p;   /* bumpless */
    } else {
        if (!l->at_limit || (err > 0.0f) != (l->out > 50.0f))
            l->integral = l->integral + l->kp * l->dt / l->ti * err;
        u = p + l->integral + l->kp * l->td * l->d_filt;
    }
    l->at_limit = false;
    if (u > 100.0f) {
        u = 100.0f;
        l->at_limit = true;
    } else if (u < 0.0f) {
        u = 0.0f;
        l->at_limit = true;
    }
    l->out = u;
}

static bool started;
static int32_t scans;
static Pid loops[64];
static float sp[64], pv[64], gain[64], tau[64];

void scan(void)
{
    int i;
    int32_t limited = 0;
    float total = 0.0f;

    if (!started) {
        started = true;
        for (i = 0; i < 64; i++) {
            sp[i] = 20.0f + (float)(i + 1);
            pv[i] = 15.0f;
            gain[i] = 0.9f + (float)(i + 1) * 0.01f;
            tau[i] = 2.0f + (float)(i + 1) * 0.1f;
        }
    }

    scans++;
    if (scans % 500 == 0)
        for (i = 0; i < 64; i++)
            sp[i] = 95.0f - sp[i];

    for (i = 0; i < 64; i++) {
        Pid *l = &loops[i];
        l->sp = sp[i];
        l->pv = pv[i];
        l->kp = 2.5f;
        l->ti = tau[i];
        l->td = 0.1f;
        l->dt = 0.01f;
        l->manual = (i + 1) % 16 == 0;
        l->man_out = 40.0f;
        pid_run(l);
        pv[i] = pv[i] + (l->out * gain[i] - pv[i]) * (0.01f / tau[i]);
        if (l->at_limit)
            limited++;
        total += pv[i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 100.0f) + (uint32_t)limited);
}
