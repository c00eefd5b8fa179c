#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

struct pid_param { float kp, ki, kd, filt, lo, hi; };
struct pid { float out, integ, d_filt, pv_old; bool at_lim; };
struct tank { float level, lag; };

static struct pid_param param[LOOPS];
static float setp[LOOPS];
static struct pid pid[LOOPS];
static struct tank tank[LOOPS];
static bool init;
static int tick;

static inline float clampf(float lo, float v, float hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static void pid_run(struct pid *c, const struct pid_param *p, float sp, float pv, bool manual, float man_out)
{
    float err = sp - pv;
    c->d_filt += p->filt * ((c->pv_old - pv) * p->kd - c->d_filt);
    c->pv_old = pv;
    if (manual) {
        c->out = clampf(p->lo, man_out, p->hi);
        c->integ = c->out - p->kp * err;
        c->at_lim = false;
    } else {
        c->integ += p->ki * err;
        float raw = p->kp * err + c->integ + c->d_filt;
        c->out = clampf(p->lo, raw, p->hi);
        c->at_lim = raw != c->out;
        if (c->at_lim)
            c->integ += 0.5f * (c->out - raw);
    }
}

static void tank_run(struct tank *t, float inflow, float outflow)
{
    t->lag += 0.2f * (inflow - t->lag);
    t->level = t->level + 0.05f * (t->lag - outflow - 0.1f * t->level);
    t->level = clampf(0.0f, t->level, 100.0f);
}

static inline void add(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    if (!init) {
        init = true;
        for (int i = 0; i < LOOPS; i++) {
            int n = i + 1;
            param[i] = (struct pid_param){
                .kp = 0.8f + 0.02f * (float)n,
                .ki = 0.01f + 0.0005f * (float)n,
                .kd = 0.3f, .filt = 0.25f, .lo = 0.0f,
                .hi = 20.0f + (float)(n % 8),
            };
            setp[i] = 30.0f + (float)n * 0.5f;
        }
    }

    if (++tick > 400) {
        tick = 0;
        for (int i = 0; i < LOOPS; i++)
            setp[i] = 110.0f - setp[i];
    }

    float total = 0.0f;
    uint32_t limits = 0;
    for (int i = 0; i < LOOPS; i++) {
        int n = i + 1;
        float draw = 2.0f + 0.01f * (float)((tick + n * 5) % 200);
        pid_run(&pid[i], &param[i], setp[i], tank[i].level, tick < 20 && n % 16 == 0, 12.5f);
        tank_run(&tank[i], pid[i].out, draw);
        total += pid[i].out;
        if (pid[i].at_lim)
            limits++;
        add((uint32_t)(int32_t)lrintf(tank[i].level * 100.0f));
    }
    add((uint32_t)(int32_t)lrintf(total * 10.0f) + limits);
}
