#include <stdbool.h>
#include "st.h"

typedef struct {
    float pv, sp, kp, ti, td;
    bool manual;
    float manOut;
    float out;
    bool limited;
    float integ, pvOld, dFilt;
} pid_loop;

static float absf(float x)
{
    return x < 0.0f ? -x : x;
}

static float limit(float mn, float x, float mx)
{
    if (x < mn)
        x = mn;
    if (x > mx)
        x = mx;
    return x;
}

static void pid_run(pid_loop *s)
{
    float e, p, d, u;

    e = s->sp - s->pv;
    if (absf(e) < 0.05f)
        e = 0.0f;
    p = s->kp * e;
    d = s->kp * s->td * (s->pvOld - s->pv) / 0.1f;
    s->dFilt = s->dFilt + 0.2f * (d - s->dFilt);
    s->pvOld = s->pv;

    if (s->manual) {
        s->out = limit(0.0f, s->manOut, 100.0f);
        s->integ = s->out - p;
        s->limited = false;
    } else {
        u = p + s->integ + s->dFilt;
        if (u > 100.0f) {
            s->out = 100.0f;
            s->limited = true;
        } else if (u < 0.0f) {
            s->out = 0.0f;
            s->limited = true;
        } else {
            s->out = u;
            s->limited = false;
        }
        if (!s->limited && s->ti > 0.0f)
            s->integ = s->integ + s->kp * e * 0.1f / s->ti;
    }
}

static int16_t n;
static bool init;
static pid_loop loops[64];
static float temp[64], setp[64], gain[64], reset[64], rate[64];

void scan(void)
{
    int16_t i;
    float sum;
    int32_t nLim;

    if (!init) {
        for (i = 0; i < 64; i++) {
            temp[i] = 20.0f;
            setp[i] = 40.0f + (float)i;
            gain[i] = 1.5f + (float)(i % 8) * 0.25f;
            reset[i] = 5.0f + (float)(i % 5);
            rate[i] = 0.1f * (float)(i % 4);
        }
        init = true;
    }

    n++;
    if (n >= 800)
        n = 0;
    if (n == 0) {
        for (i = 0; i < 64; i++)
            setp[i] = 40.0f + (float)i;
    } else if (n == 400) {
        for (i = 0; i < 64; i++)
            setp[i] = 80.0f - (float)i * 0.5f;
    }

    sum = 0.0f;
    nLim = 0;
    for (i = 0; i < 64; i++) {
        pid_loop *s = &loops[i];
        s->pv = temp[i];
        s->sp = setp[i];
        s->kp = gain[i];
        s->ti = reset[i];
        s->td = rate[i];
        s->manual = (i % 16 == 15) && (n < 100);
        s->manOut = 30.0f;
        pid_run(s);
        if (s->limited)
            nLim++;
        temp[i] = temp[i] + 0.02f * (s->out * 1.2f + 20.0f - temp[i]);
        sum = sum + s->out + temp[i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 10.0f) + (uint32_t)nLim);
}
