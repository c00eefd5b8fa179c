/* 64 temperature zones of an annealing lehr */
#include "st.h"
#include <stdbool.h>

#define ZONES 64

typedef struct {
    float integral, last_pv, d_filt;
    float out;
    bool saturated;
} pid_ctl;

static pid_ctl pid[ZONES];
static float temp[ZONES], sp[ZONES];
static bool ready;
static int tick;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid_step(pid_ctl *p, float set, float pv, float kp, float ki, float kd, bool manual, float man_out)
{
    float err = set - pv;
    float prop = kp * err;
    p->d_filt += 0.2f * ((p->last_pv - pv) * kd - p->d_filt);
    p->last_pv = pv;
    if (manual) {
        p->out = man_out;
        p->integral = man_out - prop;
        p->saturated = false;
        return;
    }
    float raw = prop + p->integral + p->d_filt;
    p->out = limit(0.0f, raw, 100.0f);
    p->saturated = raw != p->out;
    if (!p->saturated || (raw > p->out && err < 0.0f) || (raw < p->out && err > 0.0f))
        p->integral += ki * err;
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < ZONES; i++) {
            temp[i] = 25.0f;
            sp[i] = 560.0f - 5.0f * (float)i;
        }
        ready = true;
    }

    tick = (tick + 1) % 4096;
    int z = tick % ZONES;
    sp[z] = 560.0f - 5.0f * (float)z + (float)((tick / 64) % 7) * 12.0f;

    int32_t n_sat = 0, sum = 0;
    float left = 600.0f;
    for (int i = 0; i < ZONES; i++) {
        pid_step(&pid[i], sp[i], temp[i], 0.8f, 0.02f, 1.5f, (tick / 256) % 16 == i % 16, 40.0f);
        temp[i] = temp[i] + 0.05f * pid[i].out - 0.004f * (temp[i] - 25.0f) + 0.002f * (left - temp[i]);
        left = temp[i];
        if (pid[i].saturated)
            n_sat++;
        sum += (int32_t)(pid[i].out * 100.0f) + (int32_t)(temp[i] * 10.0f);
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + n_sat));
}
