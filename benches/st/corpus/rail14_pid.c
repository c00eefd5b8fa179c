#include <math.h>
#include <stdbool.h>
#include "st.h"

struct pid {
    float integ, last_err, d_filt, out;
    bool saturated;
};

static struct pid loop[64];
static float temp[64];
static int32_t tick;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline void pid_run(struct pid *p, float sp, float act, float kp, float ki, float kd, float ts,
                           bool manual, float man_out)
{
    float err = sp - act;
    if (manual) {
        p->out = clampf(0.0f, man_out, 100.0f);
        p->integ = p->out - kp * err;
        p->saturated = false;
    } else {
        p->d_filt += 0.2f * ((err - p->last_err) / ts - p->d_filt);
        float raw = kp * err + p->integ + kd * p->d_filt;
        p->out = clampf(0.0f, raw, 100.0f);
        p->saturated = raw != p->out;
        if (!p->saturated)
            p->integ += ki * err * ts;
    }
    p->last_err = err;
}

void scan(void)
{
    uint32_t sum = 0;

    tick++;
    float ambient = (float)(tick % 400) * 0.05f - 15.0f;
    for (int32_t i = 0; i < 64; i++) {
        struct pid *p = &loop[i];
        float sp = (tick + i * 17) % 500 < 250 ? 8.0f + (float)i * 0.1f : 3.0f;
        pid_run(p, sp, temp[i], 6.0f, 1.5f, 0.02f, 0.01f, (tick + i * 5) % 128 < 4, (float)i);
        temp[i] += (p->out * 0.6f - (temp[i] - ambient)) * 0.02f;
        sum = sum * 3u + (uint32_t)lrintf(p->out * 100.0f) + (uint32_t)lrintf(temp[i] * 50.0f);
        if (p->saturated)
            sum++;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
