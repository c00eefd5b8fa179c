/* 64 PID loops, each on a plant of first order. */
#include <stdbool.h>
#include "st.h"

typedef struct {
    float y;
    bool saturated;
    float last_err, integ, deriv;
} pid_loop_t;

typedef struct {
    float x;
} plant_t;

static pid_loop_t pid[64];
static plant_t process[64];
static float target[64];
static float kp[64], ki[64], kd[64], gain[64], tau[64];
static bool started;
static int32_t scans;
static int32_t seed = 17;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid_step(pid_loop_t *p, float sp, float pv, float kp, float ki, float kd)
{
    float err = sp - pv;
    p->integ = limit(-60.0f, p->integ + ki * err * 0.01f, 60.0f);
    p->deriv = p->deriv + 0.2f * ((err - p->last_err) / 0.01f - p->deriv);
    float raw = kp * err + p->integ + kd * p->deriv;
    p->y = limit(0.0f, raw, 100.0f);
    p->saturated = p->y != raw;
    p->last_err = err;
}

static void plant_step(plant_t *p, float u, float gain, float tau)
{
    p->x = p->x + (gain * u - p->x) * 0.01f / tau;
}

void scan(void)
{
    if (!started) {
        started = true;
        for (int i = 0; i < 64; i++) {
            kp[i] = 0.5f + 0.05f * (float)i;
            ki[i] = 0.2f + 0.01f * (float)(i % 16);
            kd[i] = 0.001f * (float)(i % 8);
            gain[i] = 0.8f + 0.02f * (float)(i % 20);
            tau[i] = 0.3f + 0.1f * (float)(i % 11);
        }
    }

    if (scans % 40 == 0) {
        for (int i = 0; i < 64; i++) {
            seed = (seed * 75 + 74) % 65537;
            target[i] = (float)(seed % 900) / 10.0f;
        }
    }
    scans++;

    int32_t full = 0;
    for (int i = 0; i < 64; i++) {
        pid_step(&pid[i], target[i], process[i].x, kp[i], ki[i], kd[i]);
        plant_step(&process[i], pid[i].y, gain[i], tau[i]);
        full += pid[i].saturated;
        float x = process[i].x;
        check = (check * 31 + (int32_t)(pid[i].y * 100.0f)
            + (int32_t)((x > 0.0f ? x : 0.0f) * 50.0f)) % 1000003;
    }
    check = (check * 31 + full) % 1000003;
}
