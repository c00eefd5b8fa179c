/* 64 temperature / flow loops, each with a first-order process behind it */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float Kp, Ti, Td;
    float OutMin, OutMax;
    float Band;
} LoopPar;

typedef struct {
    float CV;
    bool AtLimit;
    float integ, pvOld, dFilt;
} Pid;

static float clamp(float x, float lo, float hi)
{
    if (x < lo)
        return lo;
    else if (x > hi)
        return hi;
    return x;
}

static void pid(Pid *p, float SP, float PV, bool Auto, float ManOut, const LoopPar *par, float Dt)
{
    float err = SP - PV;
    float raw;

    if (__builtin_fabsf(err) < par->Band)
        err = 0.0f;
    p->dFilt = p->dFilt + 0.2f * ((p->pvOld - PV) / Dt - p->dFilt);
    p->pvOld = PV;

    if (Auto) {
        raw = par->Kp * (err + p->integ + par->Td * p->dFilt);
        p->CV = clamp(raw, par->OutMin, par->OutMax);
        p->AtLimit = p->CV != raw;
        /* anti-windup: stop integrating into the limit */
        if (!p->AtLimit || (raw > p->CV && err < 0.0f) || (raw < p->CV && err > 0.0f))
            p->integ = p->integ + err * Dt / par->Ti;
    } else {
        p->CV = clamp(ManOut, par->OutMin, par->OutMax);
        p->integ = p->CV / par->Kp - err;      /* bumpless back to auto */
        p->AtLimit = false;
    }
}

static Pid loops[64];
static LoopPar par[64];
static float pv[64], sp[64];
static int16_t tick;
static bool ready;

void scan(void)
{
    int16_t i;
    float acc = 0.0f;
    int32_t limits = 0;

    if (!ready) {
        for (i = 0; i < 64; i++) {
            par[i].Kp = 0.8f + (float)i * 0.02f;
            par[i].Ti = 2.0f + (float)(i % 8);
            par[i].Td = 0.05f * (float)(i % 5);
            par[i].OutMin = 0.0f;
            par[i].OutMax = 100.0f;
            par[i].Band = 0.01f;
            pv[i] = 20.0f;
            sp[i] = 30.0f + (float)i;
        }
        ready = true;
    }

    tick = (tick + 1) % 1600;
    if (tick == 0) {
        for (i = 0; i < 64; i++)
            sp[i] = 95.0f - sp[i] * 0.5f;
    }

    for (i = 0; i < 64; i++) {
        pid(&loops[i], sp[i], pv[i], (tick + i * 16) % 400 > 20, 40.0f, &par[i], 0.1f);
        pv[i] = pv[i] + 0.05f * (loops[i].CV * 0.9f + 15.0f - pv[i]);
        acc = acc + pv[i];
        if (loops[i].AtLimit)
            limits++;
    }
    check = (check * 3 + (int32_t)(acc * 10.0f) + limits) % 1000003;
}
