/* 64 heating zones: PID with anti windup and filtered D part, process model of second order */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float out;
    bool limit;
    float integ, diff, err_old;
} Pid;

static float limitf(float mn, float in, float mx)
{
    if (in < mn) in = mn;
    if (in > mx) in = mx;
    return in;
}

static void pid(Pid *p, float set, float act, float kp, float tn, float tv, float ta,
                float min, float max, bool manual, float man_val)
{
    float err = set - act;
    p->diff = p->diff + 0.3f * (tv * (err - p->err_old) / ta - p->diff);
    p->err_old = err;
    if (manual) {
        p->out = limitf(min, man_val, max);
        p->integ = p->out - kp * err;
        p->limit = false;
    } else {
        float y = kp * (err + p->diff) + p->integ;
        if (y > max) {
            p->out = max;
            p->limit = true;
            if (err < 0.0f)
                p->integ = p->integ + kp * err * ta / tn;
        } else if (y < min) {
            p->out = min;
            p->limit = true;
            if (err > 0.0f)
                p->integ = p->integ + kp * err * ta / tn;
        } else {
            p->out = y;
            p->limit = false;
            p->integ = p->integ + kp * err * ta / tn;
        }
    }
}

typedef struct { float temp, heater; } HeatZone;

static void heat_zone(HeatZone *z, float power, float ambient, float ta)
{
    z->heater = z->heater + (power * 3.0f + ambient - z->heater) * ta / 5.0f;
    z->temp = z->temp + (z->heater - z->temp) * ta / 20.0f;
}

static Pid pids[64];
static HeatZone zones[64];
static bool init;
static int32_t scan_no;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 64; i++) {
            zones[i].temp = 20.0f;
            zones[i].heater = 20.0f;
        }
        init = true;
    }
    scan_no++;
    float sum = 0.0f;
    int16_t lim = 0;
    for (int i = 1; i <= 64; i++) {
        Pid *p = &pids[i - 1];
        HeatZone *z = &zones[i - 1];
        float sp;
        if (scan_no % 3000 < 1500)
            sp = 150.0f + i;
        else
            sp = 90.0f + 0.5f * i;
        pid(p, sp, z->temp, 2.0f + 0.05f * i, 25.0f, 2.0f, 0.1f, 0.0f, 100.0f,
            i % 16 == 0 && scan_no % 800 < 100, 35.0f);
        heat_zone(z, p->out, 20.0f, 0.1f);
        if (p->limit)
            lim++;
        sum = sum + z->temp + p->out * 0.5f;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 2.0f) + lim));
}
