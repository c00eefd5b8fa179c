#include <stdbool.h>
#include "st.h"

typedef struct {
    float sp, pv;
    bool man;
    float yman;
    float kp, tn, tv, ts, ymin, ymax;
    float y;
    bool lim;
    float integ, eOld, dFilt;
} Pid;

static void pid_step(Pid *c, float sp, float pv, bool man, float yman)
{
    float e, p, d, u;

    c->sp = sp;
    c->pv = pv;
    c->man = man;
    c->yman = yman;
    e = sp - pv;
    p = c->kp * e;
    d = c->kp * c->tv * (e - c->eOld) / c->ts;
    c->dFilt = c->dFilt + 0.2f * (d - c->dFilt);
    c->eOld = e;
    if (man) {
        c->y = yman;
        c->integ = yman - p;
        c->lim = false;
    } else {
        u = p + c->integ + c->dFilt;
        c->lim = false;
        if (u > c->ymax) {
            u = c->ymax;
            c->lim = true;
        } else if (u < c->ymin) {
            u = c->ymin;
            c->lim = true;
        }
        if (!c->lim)
            c->integ = c->integ + p * c->ts / c->tn;
        c->y = u;
    }
}

static int32_t scanNo;
static bool first = true;
static Pid loops[64];
static float pv[64], sp[64], dist[64], gain[64], tau[64];

void scan(void)
{
    int32_t i, pass, nlim;
    float sum;
    bool man;

    if (first) {
        for (i = 0; i < 64; i++) {
            loops[i].kp = 0.5f + (float)(i % 8) * 0.25f;
            loops[i].tn = 4.0f + (float)(i % 5);
            loops[i].tv = 0.1f * (float)(i % 3);
            loops[i].ts = 0.1f;
            loops[i].ymin = 0.0f;
            loops[i].ymax = 100.0f;
            gain[i] = 0.8f + (float)(i % 7) * 0.1f;
            tau[i] = 2.0f + (float)(i % 11) * 0.5f;
            sp[i] = 40.0f;
        }
        first = false;
    }

    for (pass = 1; pass <= 12; pass++) {
        scanNo++;
        sum = 0.0f;
        nlim = 0;
        for (i = 0; i < 64; i++) {
            if ((scanNo + i * 16) % 500 == 0) {
                if (sp[i] > 50.0f)
                    sp[i] = 30.0f;
                else
                    sp[i] = 65.0f;
            }
            dist[i] = (float)((scanNo + i * 5) % 20) * 0.1f;
            man = (scanNo / 256 + i) % 16 == 0;
            pid_step(&loops[i], sp[i], pv[i], man, 35.0f);
            pv[i] = pv[i] + (gain[i] * loops[i].y + dist[i] - pv[i]) * 0.1f / tau[i];
            if (loops[i].lim)
                nlim++;
            sum = sum + loops[i].y + pv[i];
        }
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 10.0f) + nlim));
    }
}
