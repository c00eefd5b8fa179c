/* 64 PID loops, each on a simulated first-order process. */
#include "st.h"
#include <stdbool.h>

#define LOOPS 64

typedef struct {
    float y;
    bool limited;
    float integ, last_pv, d_part;
} pid_loop;

static void pid(pid_loop *p, float sp, float pv, float kp, float ti, float td, float ts,
                bool manual, float manual_y)
{
    float e = sp - pv;
    float p_part = kp * e;
    p->d_part += 0.2f * (kp * td * (p->last_pv - pv) / ts - p->d_part);
    p->last_pv = pv;

    if (manual) {
        p->y = manual_y;
        p->integ = p->y - p_part;
        p->limited = false;
    } else {
        float u = p_part + p->integ + p->d_part;
        p->limited = true;
        if (u > 100.0f) {
            p->y = 100.0f;
        } else if (u < 0.0f) {
            p->y = 0.0f;
        } else {
            p->y = u;
            p->integ += p_part * ts / ti;
            p->limited = false;
        }
    }
}

static pid_loop loop[LOOPS];
static float sp[LOOPS], x[LOOPS], gain[LOOPS], tau[LOOPS], kp[LOOPS], ti[LOOPS], td[LOOPS];
static int32_t n;
static bool started;

void scan(void)
{
    if (!started) {
        for (int i = 0; i < LOOPS; i++) {
            sp[i] = 20.0f + (float)(i % 10) * 5.0f;
            x[i] = 0.0f;
            gain[i] = 0.8f + (float)(i % 5) * 0.1f;
            tau[i] = 2.0f + (float)(i % 7);
            kp[i] = 1.0f + (float)(i % 4) * 0.5f;
            ti[i] = 3.0f + (float)(i % 6);
            td[i] = 0.1f + (float)(i % 3) * 0.1f;
        }
        started = true;
    }

    /* a set-point step now and then */
    n = (n + 1) % 12800;
    if (n % 200 == 0) {
        int i = n / 200;
        if (sp[i] > 50.0f)
            sp[i] = 20.0f;
        else
            sp[i] += 35.0f;
    }

    int32_t sum = 0;
    int32_t limits = 0;
    for (int i = 0; i < LOOPS; i++) {
        pid(&loop[i], sp[i], x[i], kp[i], ti[i], td[i], 0.1f, i % 16 == 15 && n < 1000, 40.0f);
        x[i] += (gain[i] * loop[i].y - x[i]) * 0.1f / tau[i];
        sum += (int32_t)(loop[i].y * 10.0f);
        if (loop[i].limited)
            limits++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum * 64 + limits));
}
