#include <math.h>
#include <stdbool.h>
#include "st.h"

/* REAL_TO_DINT: to the nearest, halves to even (the bench links without -lm). */
static int32_t to_dint(float x)
{
    return (int32_t)((double)x + 0x1.8p52 - 0x1.8p52);
}

#define N 64

typedef struct { float kp, ti, td, out_min, out_max, dead, sp_rate; } PidPar;
typedef struct {
    float out, sp_ramp, integ, pv_old, diff;
    bool sat, hi_dev;
} Pid;

static Pid pid[N];
static PidPar par[N];
static float temp[N], setp[N];
static bool init;
static int32_t nscan;

static float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static float dead_band(float x, float band)
{
    if (x > band) return x - band;
    if (x < -band) return x + band;
    return 0.0f;
}

static void pid_step(Pid *p, const PidPar *k, bool autom, float sp, float pv, float man)
{
    const float ts = 0.01f;
    p->sp_ramp += limit(-k->sp_rate, sp - p->sp_ramp, k->sp_rate);
    float err = dead_band(p->sp_ramp - pv, k->dead);
    p->diff += 0.2f * ((p->pv_old - pv) / ts - p->diff);
    p->pv_old = pv;
    if (autom) {
        float sum = k->kp * (err + k->td * p->diff) + p->integ;
        if (sum > k->out_max) {
            p->out = k->out_max;
            p->sat = true;
        } else if (sum < k->out_min) {
            p->out = k->out_min;
            p->sat = true;
        } else {
            p->out = sum;
            p->sat = false;
        }
        if (!p->sat || (sum > 0.0f) != (err > 0.0f))
            p->integ += k->kp * err * ts / k->ti;
    } else {
        p->out = limit(k->out_min, man, k->out_max);
        p->integ = p->out - k->kp * err;
        p->sat = false;
    }
    p->hi_dev = fabsf(err) > 20.0f;
}

void scan(void)
{
    if (!init) {
        init = true;
        for (int i = 0; i < N; i++) {
            par[i] = (PidPar){ 1.0f + (float)i * 0.05f, 2.0f + (float)(i % 8), 0.05f, 0.0f, 100.0f, 0.05f, 0.5f };
            temp[i] = 20.0f;
            setp[i] = 40.0f + (float)i * 0.5f;
        }
    }
    nscan++;
    int32_t alarms = 0, sat = 0;
    float sum = 0.0f;
    if (nscan % 250 == 0)
        for (int i = 0; i < N; i++)
            setp[i] = 110.0f - setp[i];
    for (int i = 0; i < N; i++) {
        Pid *p = &pid[i];
        pid_step(p, &par[i], (nscan + i * 16) % 1024 > 100, setp[i], temp[i], 35.0f);
        temp[i] = temp[i] + p->out * 0.012f - (temp[i] - 20.0f) * 0.01f;
        sum += p->out;
        alarms += p->hi_dev;
        sat += p->sat;
    }
    int32_t s = to_dint(sum * 10.0f), t = to_dint(temp[nscan % N] * 100.0f);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(s + alarms * 3 + sat * 5 + t));
}
