#include "st.h"
#include <math.h>

static int32_t scans, seed = 99;
static float sp[64], pv[64], out[64], integral[64], previous[64], kp[64], ki[64], kd[64];

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 64; i++) {
            kp[i] = 1.0f + i / 32.0f;
            ki[i] = 0.05f + (i % 8) / 100.0f;
            kd[i] = 0.125f;
        }
    scans++;
    float sum = 0.0f;
    for (int i = 0; i < 64; i++) {
        seed = (seed * 171 + 11213) % 53125;
        if (seed < 500)
            sp[i] = seed / 5.0f;
        float e = sp[i] - pv[i];
        integral[i] = limit(-50.0f, integral[i] + ki[i] * e, 50.0f);
        float d = e - previous[i];
        previous[i] = e;
        float u = limit(0.0f, kp[i] * e + integral[i] + kd[i] * d, 100.0f);
        out[i] = u;
        pv[i] = pv[i] + 0.1f * (u - pv[i]) + ((float)(seed % 100) - 50.0f) * 0.001f;
        sum = sum + fabsf(e) + out[i];
    }
    check = (check + (int32_t)(sum * 8.0f)) % 1000000;
}
