#include "st.h"
#include <stdbool.h>

typedef struct {
    float y;
    bool limited;
    float integral, last_pv, d_filt;
} pid_st;

static float limitf(float mn, float v, float mx)
{
    if (v < mn)
        return mn;
    if (v > mx)
        return mx;
    return v;
}

static void pid(pid_st *s, float sp, float pv, float kp, float tn, float tv,
                float ymin, float ymax, bool manual, float ymanual, float cyc)
{
    float e = sp - pv;

    if (manual) {
        s->y = limitf(ymin, ymanual, ymax);
        s->integral = s->y - kp * e;
        s->last_pv = pv;
        s->d_filt = 0.0f;
        s->limited = false;
    } else {
        float p = kp * e;
        float d = kp * tv * (s->last_pv - pv) / cyc;
        float u;
        s->d_filt = s->d_filt + 0.2f * (d - s->d_filt);
        s->last_pv = pv;
        u = p + s->integral + s->d_filt;
        if (u > ymax) {
            s->y = ymax;
            s->limited = true;
            if (e < 0.0f)
                s->integral = s->integral + kp * e * cyc / tn;
        } else if (u < ymin) {
            s->y = ymin;
            s->limited = true;
            if (e > 0.0f)
                s->integral = s->integral + kp * e * cyc / tn;
        } else {
            s->y = u;
            s->limited = false;
            s->integral = s->integral + kp * e * cyc / tn;
        }
    }
}

static bool first = true;
static int16_t cycle;
static pid_st loops[64];
static float sp[64], pv[64], kp[64], tn[64], tv[64], gain[64];

void scan(void)
{
    int i;
    int32_t n = 0;

    if (first) {
        first = false;
        for (i = 0; i < 64; i++) {
            sp[i] = 20.0f + (float)i;
            pv[i] = 15.0f;
            kp[i] = 0.8f + (float)(i % 8) * 0.15f;
            tn[i] = 2.0f + (float)(i % 5) * 0.5f;
            tv[i] = 0.05f * (float)(i % 3);
            gain[i] = 0.01f + (float)(i % 7) * 0.002f;
        }
    }
    cycle++;
    if (cycle >= 500) {
        cycle = 0;
        for (i = 0; i < 64; i++)
            sp[i] = 100.0f - sp[i];
    }
    for (i = 0; i < 64; i++) {
        pid(&loops[i], sp[i], pv[i], kp[i], tn[i], tv[i], 0.0f, 100.0f,
            i == cycle / 8, 50.0f, 0.01f);
        pv[i] = pv[i] + (loops[i].y - pv[i]) * gain[i];
        n += (int32_t)(loops[i].y * 10.0f);
        if (loops[i].limited)
            n += 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
