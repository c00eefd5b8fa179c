#include "st.h"
#include <stdbool.h>
#include <stdint.h>

enum { FURNACES = 8, ZONES = 8 };
#define TS 0.01f

typedef struct { float integral, pv_old, filter, out; bool limited; } pid;
typedef struct { pid ctrl; float oven, temp, heating; bool sat; } zone;

static inline float lag(float *y, float x, float tau)
{
    *y = *y + (x - *y) * TS / (tau + TS);
    return *y;
}

static inline float clamp(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void run_pid(pid *p, float sp, float pv, float kp, float ti, float td,
                    bool manual, float man_value, float lo, float hi)
{
    float e = sp - pv;
    float d = kp * td * lag(&p->filter, (p->pv_old - pv) / TS, td * 0.1f);
    p->pv_old = pv;
    if (manual) {
        p->out = clamp(lo, man_value, hi);
        p->limited = false;
        p->integral = p->out - kp * e - d;
    } else {
        float raw = kp * e + p->integral + d;
        p->out = clamp(lo, raw, hi);
        p->limited = raw != p->out;
        if (!p->limited || (raw > hi && e < 0.0f) || (raw < lo && e > 0.0f))
            p->integral = p->integral + kp * e * TS / ti;
    }
}

static void run_zone(zone *z, float sp, float neighbour, bool manual, float gain)
{
    run_pid(&z->ctrl, sp, z->temp, 2.5f, 0.8f, 0.05f, manual, 35.0f, 0.0f, 100.0f);
    z->heating = z->ctrl.out;
    z->sat = z->ctrl.limited;
    z->temp = lag(&z->oven, z->heating * gain + neighbour * 0.05f, 0.5f);
}

static zone zones[FURNACES][ZONES];
static int32_t scans;

void scan(void)
{
    if (scans == 0)
        for (int f = 0; f < FURNACES; f++)
            for (int z = 0; z < ZONES; z++)
                zones[f][z].temp = 20.0f;
    scans++;
    float sum = 0.0f;
    int32_t sats = 0;
    for (int f = 1; f <= FURNACES; f++) {
        float left = 20.0f;
        float sp = (scans / 150 + f) % 2 == 0 ? 120.0f : 60.0f;
        for (int z = 1; z <= ZONES; z++) {
            zone *p = &zones[f - 1][z - 1];
            run_zone(p, sp + (float)z * 2.0f, left, (scans + f * 40 + z * 10) % 400 < 30,
                     1.5f + (float)f * 0.05f);
            left = p->temp;
            sum = sum + left + p->heating;
            sats += p->sat;
        }
    }
    check = (check + (int32_t)sum + sats) % 1000000;
}
