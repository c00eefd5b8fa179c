#include "st.h"
#include <stdbool.h>

struct pid {
    float sp, pv;
    float kp, ki, kd;
    float cyc, lo, hi;
    bool manual;
    float man_val;
    float cv;
    bool limited;
    float integ, last_pv, dterm;
};

static struct pid loops[64];
static float temp[64], setp[64];
static bool ready;
static int32_t n;

static float limit(float mn, float x, float mx)
{
    if (x < mn)
        x = mn;
    if (x > mx)
        x = mx;
    return x;
}

static void pid_call(struct pid *p, float sp, float pv, bool manual, float man_val)
{
    float err, u;

    p->sp = sp;
    p->pv = pv;
    p->manual = manual;
    p->man_val = man_val;

    err = sp - pv;
    p->dterm = p->dterm + 0.25f * ((p->last_pv - pv) / p->cyc - p->dterm);
    p->last_pv = pv;
    if (manual) {
        p->cv = limit(p->lo, man_val, p->hi);
        p->integ = p->cv - p->kp * err;
        p->limited = false;
        return;
    }
    u = p->kp * err + p->integ + p->kd * p->dterm;
    p->limited = false;
    if (u > p->hi) {
        u = p->hi;
        p->limited = true;
    } else if (u < p->lo) {
        u = p->lo;
        p->limited = true;
    } else {
        p->integ = p->integ + p->ki * err * p->cyc;
    }
    p->cv = u;
}

void scan(void)
{
    int32_t sum = 0;

    if (!ready) {
        ready = true;
        for (int i = 0; i < 64; i++) {
            loops[i].kp = 1.5f + (float)(i + 1) * 0.02f;
            loops[i].ki = 0.4f;
            loops[i].kd = 0.05f;
            loops[i].cyc = 0.1f;
            loops[i].lo = 0.0f;
            loops[i].hi = 100.0f;
            temp[i] = 20.0f;
            setp[i] = 30.0f + (float)(i + 1) * 0.5f;
        }
    }
    n++;
    if (n >= 1000) {
        n = 0;
        for (int i = 0; i < 64; i++)
            setp[i] = 95.0f - setp[i];
    }
    for (int i = 0; i < 64; i++) {
        struct pid *p = &loops[i];
        pid_call(p, setp[i], temp[i], (i + 1) % 16 == 0 && n > 800, 35.0f);
        temp[i] = temp[i] + 0.1f * (0.9f * p->cv + 18.0f - temp[i]) * 0.3f;
        if (p->limited)
            sum += 1;
        sum += (int32_t)(p->cv * 100.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
