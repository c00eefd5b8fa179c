#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define TS 0.01f

struct pid_par { float kp, ti, td, min, max; };

struct pid {
    float y, err;
    bool at_max, at_min;
    float integral, d_filt, pv_old;
};

static bool init_done;
static int scan_no;
static struct pid pid[LOOPS];
static struct pid_par par[LOOPS];
static float sp[LOOPS], pv[LOOPS], tau[LOOPS];

static void pid_step(struct pid *c, const struct pid_par *p, float sp, float pv, float ts,
                     bool manual, float man_val)
{
    c->err = sp - pv;
    float p_part = p->kp * c->err;

    if (manual) {
        c->y = man_val;
        c->integral = man_val - p_part;
        c->d_filt = 0.0f;
        c->at_max = false;
        c->at_min = false;
    } else {
        c->d_filt += 0.2f * (p->kp * p->td * (c->pv_old - pv) / ts - c->d_filt);
        float raw = p_part + c->integral + c->d_filt;
        c->at_max = raw > p->max;
        c->at_min = raw < p->min;
        if (c->at_max)
            c->y = p->max;
        else if (c->at_min)
            c->y = p->min;
        else
            c->y = raw;
        if (!(c->at_max && c->err > 0.0f) && !(c->at_min && c->err < 0.0f))
            c->integral += p->kp * c->err * ts / p->ti;
    }
    c->pv_old = pv;
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < LOOPS; i++) {
            int n = i + 1;
            par[i].kp = 0.8f + 0.05f * (float)(n % 17);
            par[i].ti = 0.2f + 0.01f * (float)n;
            par[i].td = 0.002f * (float)(n % 5);
            par[i].min = -20.0f;
            par[i].max = 100.0f;
            tau[i] = 0.1f + 0.02f * (float)(n % 23);
            sp[i] = (float)n;
        }
        init_done = true;
    }

    scan_no = (scan_no + 1) % 640;
    if (scan_no % 10 == 0) {
        int i = scan_no / 10;
        sp[i] = 95.0f - 0.75f * sp[i];
    }

    float sum_y = 0.0f, sum_err = 0.0f;
    int32_t limited = 0;
    for (int i = 0; i < LOOPS; i++) {
        struct pid *c = &pid[i];
        pid_step(c, &par[i], sp[i], pv[i], TS, (i + 1) % 16 == 0 && scan_no < 100, 25.0f);
        pv[i] += (1.2f * c->y - pv[i]) * TS / tau[i];
        sum_y += c->y;
        sum_err += fabsf(c->err);
        if (c->at_max || c->at_min)
            limited++;
    }

    add((int32_t)lrintf(sum_y * 100.0f));
    add((int32_t)lrintf(sum_err * 100.0f));
    add(limited);
}
