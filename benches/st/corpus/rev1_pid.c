/* 64 control loops: setpoint ramp, linearised measurement, PID with filtered derivative and anti-windup, simulated process. */
#include <stdbool.h>
#include "st.h"

#define DTS 0.1f
#define YMIN 0.0f
#define YMAX 100.0f

struct pid { float y; bool limited; float integral, deriv, pv_old; };
struct process { float pv, x1; };

static float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static float absf(float x)
{
    return x < 0.0f ? -x : x;
}

static void pid(struct pid *c, float sp, float pv, float kp, float ti, float td, float ffwd, bool manual, float man_y)
{
    float e = sp - pv;
    float p = kp * e;
    c->deriv = c->deriv + (kp * td * (c->pv_old - pv) / DTS - c->deriv) * 0.2f;
    c->pv_old = pv;
    if (manual) {
        c->y = limit(YMIN, man_y, YMAX);
        c->integral = c->y - p - ffwd;
        c->limited = false;
        return;
    }
    float u = p + c->integral + c->deriv + ffwd;
    c->limited = u > YMAX || u < YMIN;
    c->y = limit(YMIN, u, YMAX);
    if (!c->limited || (u > YMAX && e < 0.0f) || (u < YMIN && e > 0.0f))
        c->integral = c->integral + p * DTS / ti;
}

static void process(struct process *s, float y, float gain, float t1, float t2, float load)
{
    for (int step = 1; step <= 10; step++) {
        s->x1 = s->x1 + (gain * y - s->x1) * 0.01f / t1;
        s->pv = s->pv + (s->x1 - load - s->pv) * 0.01f / t2;
    }
}

static float ramp(float act, float target, float rate)
{
    if (absf(target - act) <= rate)
        return target;
    if (target > act)
        return act + rate;
    return act - rate;
}

static const float px[8] = { 0.0f, 12.0f, 25.0f, 40.0f, 55.0f, 70.0f, 85.0f, 100.0f };
static const float py[8] = { 0.0f, 11.0f, 24.0f, 40.5f, 56.0f, 70.5f, 86.0f, 100.0f };

static float sensor(float raw)
{
    int i = 0;
    while (i < 6 && raw > px[i + 1])
        i++;
    return py[i] + (raw - px[i]) * (py[i + 1] - py[i]) / (px[i + 1] - px[i]);
}

static int32_t seed = 99;
static struct pid pids[64];
static struct process plant[64];
static float setpoint[64], target[64], kp[64], ti[64], t1[64];
static bool first = true;
static int16_t scans;

void scan(void)
{
    if (first) {
        first = false;
        for (int i = 0; i < 64; i++) {
            target[i] = 30.0f + (float)i * 0.5f;
            kp[i] = 1.0f + (float)(i % 8) * 0.25f;
            ti[i] = 4.0f + (float)(i % 5);
            t1[i] = 2.0f + (float)(i % 7) * 0.5f;
        }
    }
    scans = (int16_t)((scans + 1) % 1000);
    seed = (seed * 1103 + 12345) % 65536;
    int n = seed % 64;
    target[n] = (float)(seed / 64 % 100);
    float load = (float)scans * 0.01f;

    float sum = 0.0f;
    int16_t limits = 0;
    for (int i = 0; i < 64; i++) {
        setpoint[i] = ramp(setpoint[i], target[i], 0.25f);
        pid(&pids[i], setpoint[i], sensor(plant[i].pv), kp[i], ti[i], 0.5f,
            setpoint[i] * 0.2f, (scans + i) % 200 < 10, 40.0f);
        process(&plant[i], pids[i].y, 1.2f, t1[i], 1.5f, load);
        sum += absf(setpoint[i] - plant[i].pv);
        if (pids[i].limited) limits++;
    }
    check = (check * 31 + (int32_t)(sum * 10.0f) + limits) % 1000003;
}
