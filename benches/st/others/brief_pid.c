/* 64 PID loops, each on a first-order plant */
#include <stdbool.h>
#include "st.h"

#define DT 0.01f

typedef struct {
    float kp, ti, td;
    float out;
    float integral, last_e;
} pid_loop;

static float limit(float lo, float x, float hi)
{
    if (x < lo) return lo;
    if (x > hi) return hi;
    return x;
}

static void pid_step(pid_loop *p, float sp, float pv)
{
    float e = sp - pv;
    p->integral = limit(-100.0f, p->integral + p->kp * e * DT / p->ti, 100.0f);
    float d = p->kp * p->td * (e - p->last_e) / DT;
    p->out = limit(0.0f, p->kp * e + p->integral + d, 100.0f);
    p->last_e = e;
}

static pid_loop loops[64];
static float pv[64], sp[64];
static bool first = true;
static int16_t n;

void scan(void)
{
    int i;
    if (first) {
        first = false;
        for (i = 0; i < 64; i++) {
            loops[i].kp = 1.0f + (float)i * 0.05f;
            loops[i].ti = 0.5f + (float)i * 0.02f;
            loops[i].td = 0.01f;
            sp[i] = 20.0f + (float)i;
        }
    }
    n = (n + 1) % 1000;
    if (n == 500)
        for (i = 0; i < 64; i++)
            sp[i] = 90.0f - sp[i];

    float sum = 0.0f;
    for (i = 0; i < 64; i++) {
        pid_step(&loops[i], sp[i], pv[i]);
        pv[i] = pv[i] + (loops[i].out - pv[i]) * 0.02f;
        sum = sum + pv[i] + loops[i].out;
    }
    check = check * 31 + (int32_t)(sum * 10.0f);
}
