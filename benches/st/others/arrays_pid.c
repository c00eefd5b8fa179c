#include "st.h"

#define TS 0.01f

typedef struct { float err, last, integ, deriv, out; } Pid;

static float limit(float mn, float x, float mx)
{
    return x < mn ? mn : x > mx ? mx : x;
}

static float pid(Pid *p, float sp, float pv, float kp, float ki, float kd)
{
    p->err = sp - pv;
    p->integ = limit(-50.0f, p->integ + ki * p->err * TS, 50.0f);
    p->deriv = p->deriv + ((p->err - p->last) / TS - p->deriv) * 0.2f;
    p->out = limit(0.0f, kp * p->err + p->integ + kd * p->deriv, 100.0f);
    p->last = p->err;
    return p->out;
}

static int32_t n;
static Pid loops[64];
static float sp[64], pv[64], kp[64], ki[64], kd[64], gain[64], lag[64];

void scan(void)
{
    if (n == 0)
        for (int i = 0; i < 64; i++) {
            kp[i] = 1.5f + (float)(i % 7) * 0.3f;
            ki[i] = 0.8f + (float)(i % 5) * 0.4f;
            kd[i] = 0.01f + (float)(i % 3) * 0.02f;
            gain[i] = 0.7f + (float)(i % 11) * 0.05f;
            lag[i] = 0.02f + (float)(i % 13) * 0.01f;
            sp[i] = 20.0f + (float)i;
            pv[i] = 15.0f;
        }
    sp[n % 64] = 10.0f + (float)((n * 13) % 71);

    int32_t acc = 0;
    for (int i = 0; i < 64; i++) {
        float out = pid(&loops[i], sp[i], pv[i], kp[i], ki[i], kd[i]);
        pv[i] = pv[i] + (out * gain[i] - pv[i]) * lag[i];
        acc += (int32_t)(out * 100.0f) + (int32_t)(pv[i] * 50.0f);
    }

    n++;
    check = (check * 31 + acc) % 1000003;
}
