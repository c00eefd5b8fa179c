/* 64 PID controllers with modes, anti-windup and deadband, each with a simulated tank */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

enum mode { OFF, MANUAL, AUTO, HOLD };

struct tuning { float kp, ki, kd, lo, hi, band; };
struct pid { float y, integral, last_pv; bool limited; };
struct tank { float level, valve; int16_t overflows; };

struct loop {
    struct tuning tune;
    struct pid pid;
    struct tank tank;
    float sp, draw;
    int16_t mode;
};

static inline float clamp(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static void control(struct pid *p, const struct tuning *t, int16_t mode,
                    float sp, float pv, float manual)
{
    switch (mode) {
    case OFF:
        p->y = 0.0f;
        p->integral = 0.0f;
        p->limited = false;
        break;
    case MANUAL:                /* the integral follows the output */
        p->y = clamp(t->lo, manual, t->hi);
        p->integral = p->y - t->kp * (sp - pv);
        p->limited = p->y != manual;
        break;
    case AUTO: {
        float e = sp - pv;
        if (fabsf(e) < t->band)
            e = 0.0f;
        float d = (pv - p->last_pv) * t->kd;
        float raw = t->kp * e + p->integral - d;
        p->y = clamp(t->lo, raw, t->hi);
        p->limited = p->y != raw;
        if (!p->limited || (raw > t->hi && e < 0.0f) || (raw < t->lo && e > 0.0f))
            p->integral += t->ki * e;
        break;
    }
    default:
        p->y *= 0.9f;
    }
    p->last_pv = pv;
}

static void simulate(struct tank *k, float inflow, float draw)
{
    k->valve += 0.2f * (inflow - k->valve);
    k->level += 0.01f * (k->valve * 2.0f - draw * k->level / (k->level + 5.0f));
    if (k->level < 0.0f) {
        k->level = 0.0f;
    } else if (k->level > 100.0f) {
        k->level = 100.0f;
        k->overflows++;
    }
}

static uint32_t seed = 4711;
static struct loop loops[LOOPS];
static int32_t trips;

static void prepare(void)
{
    for (int i = 0; i < LOOPS; i++) {
        struct loop *l = &loops[i];
        l->tune.kp = 2.0f + (float)(i % 5);
        l->tune.ki = 0.01f * (float)(1 + i % 7);
        l->tune.kd = 0.5f * (float)(i % 3);
        l->tune.lo = 0.0f;
        l->tune.hi = 60.0f + (float)i;
        l->tune.band = 0.05f;
        l->tank.level = 20.0f;
        l->sp = 30.0f;
        l->draw = 25.0f;
        l->mode = AUTO;
    }
}

void scan(void)
{
    static bool ready;

    if (!ready) {
        ready = true;
        prepare();
    }

    float total = 0.0f;
    for (int i = 0; i < LOOPS; i++) {
        struct loop *l = &loops[i];
        seed = seed * 1664525u + 1013904223u;
        int r = (int)(seed / 131072);
        switch (r % 100) {
        case 0:
            l->sp = (float)(r % 90) + 5.0f;
            break;
        case 1: case 2:
            l->draw = (float)(r % 50) + 10.0f;
            break;
        case 3:
            l->mode = (int16_t)(r % 4);
            break;
        case 4: case 5: case 6: case 7: case 8:
            l->mode = AUTO;
            break;
        }
        control(&l->pid, &l->tune, l->mode, l->sp, l->tank.level, l->sp * 0.8f);
        simulate(&l->tank, l->pid.y, l->draw);
        total += l->tank.level;
        if (l->pid.limited)
            trips += l->tank.overflows + 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(total * 10.0f) + trips));
}
