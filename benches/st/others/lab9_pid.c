/* 64 PID loops on flat arrays, each with a first order plant. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 64
#define TS 0.01f
#define UMIN 0.0f
#define UMAX 100.0f
#define DUMAX 8.0f

static int32_t seed = 74755;
static bool first = true;
static int32_t turn;
static float kp[N], ki[N], kd[N];
static float sp[N], pv[N], pvold[N], dfilt[N], integ[N], u[N];

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

void scan(void)
{
    int32_t i, nsat = 0;
    float err, d, v, du, sum = 0.0f;
    bool high, low;

    if (first) {
        first = false;
        for (i = 0; i < N; i++) {
            kp[i] = 1.0f + (float)i * 0.05f;
            ki[i] = 0.5f + (float)(i % 8) * 0.25f;
            kd[i] = 0.001f * (float)(i % 5);
            sp[i] = (float)(Rand() % 80);
        }
    }
    sp[turn] = (float)(Rand() % 80);
    turn = (turn + 1) % N;

    for (i = 0; i < N; i++) {
        err = sp[i] - pv[i];
        /* dead band */
        if (fabsf(err) < 0.02f)
            err = 0.0f;
        /* derivative on the measurement, filtered */
        d = (pvold[i] - pv[i]) / TS;
        dfilt[i] = dfilt[i] + 0.2f * (d - dfilt[i]);
        pvold[i] = pv[i];
        v = kp[i] * err + integ[i] + kd[i] * dfilt[i];
        /* limits */
        high = v > UMAX;
        low = v < UMIN;
        if (high)
            v = UMAX;
        else if (low)
            v = UMIN;
        /* anti-windup: integrate only when it leads out of the limit */
        if (!(high && err > 0.0f) && !(low && err < 0.0f))
            integ[i] = integ[i] + ki[i] * err * TS;
        if (high || low)
            nsat = nsat + 1;
        /* rate limit */
        du = v - u[i];
        if (du > DUMAX)
            du = DUMAX;
        if (du < -DUMAX)
            du = -DUMAX;
        u[i] = u[i] + du;
        /* plant */
        pv[i] = pv[i] + (u[i] * 0.9f - pv[i]) * 0.05f;
        sum = sum + u[i] + pv[i] * 0.5f;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(sum * 100.0f) + (uint32_t)nsat);
}
