#include <stdbool.h>
#include "st.h"

typedef struct {
    float kp, ti, td, nd, ts, low, high;
    float integral, deriv, pv_old;
    float out;
    bool started, at_limit;
} Pid;

static Pid controllers[64];
static float temperature[64], setpoint[64];
static int scans;

static inline float limit(float low, float x, float high)
{
    return x < low ? low : x > high ? high : x;
}

static void pid(Pid *p, float sp, float pv, bool manual, float man_value)
{
    if (!p->started) {
        p->pv_old = pv;
        p->started = true;
    }
    float err = sp - pv;
    float prop = p->kp * err;
    float tf = p->td / p->nd;
    p->deriv = (tf * p->deriv - p->kp * p->td * (pv - p->pv_old)) / (tf + p->ts);
    p->pv_old = pv;

    if (manual) {
        p->out = limit(p->low, man_value, p->high);
        p->integral = p->out - prop;
        p->at_limit = false;
        return;
    }
    float raw = prop + p->integral + p->deriv;
    p->out = limit(p->low, raw, p->high);
    p->at_limit = raw > p->high || raw < p->low;
    if (!p->at_limit || (raw > p->high && err < 0) || (raw < p->low && err > 0))
        p->integral += prop * p->ts / p->ti;
}

void scan(void)
{
    scans++;
    if (scans == 1)
        for (int i = 0; i < 64; i++)
            controllers[i] = (Pid){ .kp = 2.0f + (float)i * 0.05f, .ti = 0.5f, .td = 0.04f,
                .nd = 8.0f, .ts = 0.01f, .low = 0.0f, .high = 100.0f };
    float total = 0;
    int limited = 0;
    for (int i = 0; i < 64; i++) {
        Pid *p = &controllers[i];
        if ((scans + i * 7) % 200 == 0)
            setpoint[i] = (float)((scans + i * 13) % 90);
        pid(p, setpoint[i], temperature[i], (scans + i * 5) % 400 < 50, (float)(i * 2));
        temperature[i] = temperature[i] + (p->out * 1.2f - temperature[i]) * 0.01f / 0.4f;
        total = total + temperature[i] + p->out;
        limited += p->at_limit;
    }
    check = (check * 31 + (int)(total * 8.0f) + limited) % 1000003;
}
