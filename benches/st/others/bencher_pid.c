/* 64 PID loops, each with a second order plant and a dead time buffer. */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float sp, pv, kp, ti, td, dt, ymin, ymax;
    float y;
    bool sat;
    float integ, dfil, pvold;
} pid_ctl;

static pid_ctl pid[64];
static float kp[64], ti[64], td[64], x1[64], x2[64];
static float buf[64][8];
static int32_t cyc;
static bool init;

static float limit(float mn, float in, float mx)
{
    if (in < mn) return mn;
    if (in > mx) return mx;
    return in;
}

static void pid_run(pid_ctl *p, float sp, float pv, float kp, float ti, float td,
                    float dt, float ymin, float ymax)
{
    float e, u;

    p->sp = sp;
    p->pv = pv;
    p->kp = kp;
    p->ti = ti;
    p->td = td;
    p->dt = dt;
    p->ymin = ymin;
    p->ymax = ymax;
    e = sp - pv;
    p->dfil = p->dfil + 0.3f * ((p->pvold - pv) / dt - p->dfil);
    p->pvold = pv;
    u = kp * (e + p->integ + td * p->dfil);
    p->y = limit(ymin, u, ymax);
    p->sat = u != p->y;
    if (!p->sat)
        p->integ = p->integ + e * dt / ti;
}

void scan(void)
{
    int32_t i, pos, nsat = 0;
    float sp, ud, sum = 0.0f;

    if (!init) {
        for (i = 0; i < 64; i++) {
            kp[i] = 1.0f + (float)(i % 8) * 0.25f;
            ti[i] = 2.0f + (float)(i % 5);
            td[i] = 0.05f * (float)(i % 3);
        }
        init = true;
    }

    cyc++;
    pos = cyc % 8;
    for (i = 0; i < 64; i++) {
        if ((cyc / 200 + i) % 2 == 0)
            sp = 40.0f + (float)i * 0.5f;
        else
            sp = 60.0f;
        pid_run(&pid[i], sp, x2[i], kp[i], ti[i], td[i], 0.1f, 0.0f, 100.0f);
        ud = buf[i][pos];
        buf[i][pos] = pid[i].y;
        x1[i] = x1[i] + 0.05f * (ud - x1[i]);
        x2[i] = x2[i] + 0.08f * (x1[i] - x2[i]);
        sum += x2[i];
        if (pid[i].sat)
            nsat++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 100.0f) + (uint32_t)nsat);
}
