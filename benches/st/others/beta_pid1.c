#include "st.h"
#include <stdbool.h>

typedef struct {
    float out;
    bool limited;
    float integral;
    float last_pv;
    float d_filt;
} PidLoop;

static float clampf(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static void pid_loop(PidLoop *b, float sp, float pv, float kp, float ti, float td, float cycle,
                     float out_min, float out_max, bool automatic, float manual)
{
    float e = sp - pv;
    float p = kp * e;
    b->d_filt = b->d_filt + 0.2f * ((b->last_pv - pv) / cycle - b->d_filt);
    b->last_pv = pv;
    if (automatic) {
        float u = p + b->integral + kp * td * b->d_filt;
        b->limited = false;
        if (u > out_max) {
            b->out = out_max;
            b->limited = true;
        } else if (u < out_min) {
            b->out = out_min;
            b->limited = true;
        } else {
            b->out = u;
        }
        if (!b->limited || (u > out_max && e < 0.0f) || (u < out_min && e > 0.0f))
            b->integral = b->integral + p * cycle / ti;
    } else {
        b->out = clampf(out_min, manual, out_max);
        b->integral = b->out - p;
        b->limited = false;
    }
}

static PidLoop loops[64];
static float x1[64], x2[64];
static int16_t tick;

void scan(void)
{
    tick++;
    if (tick >= 3000)
        tick = 0;
    float total = 0.0f;
    int32_t n_limited = 0;
    for (int i = 0; i < 64; i++) {
        float sp;
        if (tick < 1500)
            sp = 30.0f + (float)i * 0.5f;
        else
            sp = 70.0f - (float)i * 0.25f;
        pid_loop(&loops[i], sp, x2[i], 1.5f + (float)(i % 8) * 0.2f, 0.8f, 0.05f, 0.01f,
                 0.0f, 100.0f, (tick + i * 20) % 1000 > 100, 40.0f);
        /* process: two first order lags */
        x1[i] = x1[i] + 0.04f * (loops[i].out - x1[i]);
        x2[i] = x2[i] + 0.02f * (x1[i] - x2[i]);
        total = total + loops[i].out + x2[i];
        if (loops[i].limited)
            n_limited++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 10.0f) + (uint32_t)n_limited);
}
