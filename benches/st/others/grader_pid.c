/* 64 PID loops, each with its own first-order process */
#include "st.h"
#include <stdbool.h>
#include <math.h>

struct tuning {
    float kp, ti, td;
    float ymin, ymax;
    float deadband;
};

struct pid {
    float y;
    bool limited;
    float integ, pv_old, d_filt;
    bool started;
};

static struct pid loops[64];
static struct tuning tune[64];
static float sp[64], pv[64];
static int16_t n;
static bool ready;

static float limit(float lo, float x, float hi)
{
    return x < lo ? lo : (x > hi ? hi : x);
}

static void pid_run(struct pid *s, float sp, float pv, float kp, float ti, float td,
                    float ymin, float ymax, float deadband, float dt, bool man, float yman)
{
    float e, p, d, u;

    e = sp - pv;
    if (fabsf(e) < deadband)
        e = 0.0f;
    if (!s->started) {
        s->pv_old = pv;
        s->started = true;
    }

    p = kp * e;
    d = kp * td * (s->pv_old - pv) / dt;
    s->d_filt += (d - s->d_filt) * 0.2f;
    s->pv_old = pv;

    if (man) {
        s->y = limit(ymin, yman, ymax);
        s->integ = s->y - p;
        s->limited = false;
    } else {
        if (ti > 0.0f) {
            if (!s->limited || (e > 0.0f) == (s->y <= ymin))
                s->integ += p * dt / ti;
        } else {
            s->integ = 0.0f;
        }
        u = p + s->integ + s->d_filt;
        s->limited = false;
        if (u > ymax) {
            u = ymax;
            s->limited = true;
        } else if (u < ymin) {
            u = ymin;
            s->limited = true;
        }
        s->y = u;
    }
}

void scan(void)
{
    int16_t i;
    float total;
    int32_t n_limited;

    if (!ready) {
        for (i = 0; i < 64; i++) {
            int16_t k = i + 1;
            tune[i].kp = 0.8f + (float)(k % 7) * 0.3f;
            tune[i].ti = (float)(k % 9) * 0.5f;
            tune[i].td = (float)(k % 5) * 0.05f;
            tune[i].ymin = 0.0f;
            tune[i].ymax = 100.0f;
            tune[i].deadband = 0.05f;
            sp[i] = 40.0f + (float)(k % 11);
            pv[i] = 20.0f;
        }
        ready = true;
    }

    n = (n + 1) % 1000;
    if (n == 500) {
        for (i = 0; i < 64; i++)
            sp[i] = 90.0f - sp[i];
    }

    total = 0.0f;
    n_limited = 0;
    for (i = 0; i < 64; i++) {
        pid_run(&loops[i], sp[i], pv[i], tune[i].kp, tune[i].ti, tune[i].td,
                tune[i].ymin, tune[i].ymax, tune[i].deadband, 0.1f,
                n < 50 && (i + 1) % 8 == 0, 35.0f);
        pv[i] += (loops[i].y * 0.9f - pv[i]) * 0.03f;
        total += pv[i];
        if (loops[i].limited)
            n_limited++;
    }

    check = (check + (int32_t)(total * 8.0f) + n_limited) % 10000019;
}
