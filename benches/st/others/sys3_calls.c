#include "st.h"
#include <stdbool.h>

struct analog { int16_t raw; float lo, hi; float val; int16_t alarm; bool fault; };
struct valve { bool cmd, fb_open, fb_closed; int16_t state; bool err; int16_t cnt; };
struct ramp { float target, rate; bool enable; float y; bool done; };

static struct analog ai[80];
static struct valve vlv[60];
static struct ramp rmp[60];
static int32_t seed = 4711;

static float scale_raw(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static float clamp(float x, float lo, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static int16_t alarm_code(float x, float ll, float l, float h, float hh)
{
    if (x >= hh)
        return 4;
    if (x >= h)
        return 3;
    if (x <= ll)
        return 2;
    if (x <= l)
        return 1;
    return 0;
}

static int32_t next_rand(int32_t s)
{
    return (s * 1103 + 12345) % 65536;
}

static void analog_call(struct analog *a, int16_t raw, float lo, float hi)
{
    a->raw = raw;
    a->lo = lo;
    a->hi = hi;
    a->fault = raw < -500 || raw > 28000;
    if (!a->fault)
        a->val = a->val + 0.2f * (clamp(scale_raw(raw, lo, hi), lo, hi) - a->val);
    a->alarm = alarm_code(a->val, lo + 5.0f, lo + 10.0f, hi - 10.0f, hi - 5.0f);
}

static void valve_call(struct valve *v, bool cmd, bool fb_open, bool fb_closed)
{
    v->cmd = cmd;
    v->fb_open = fb_open;
    v->fb_closed = fb_closed;
    switch (v->state) {
    case 0: /* closed */
        if (cmd) {
            v->state = 1;
            v->cnt = 0;
        }
        break;
    case 1: /* opening */
        v->cnt++;
        if (fb_open)
            v->state = 2;
        else if (v->cnt > 20)
            v->state = 4;
        break;
    case 2: /* open */
        if (!cmd) {
            v->state = 3;
            v->cnt = 0;
        }
        break;
    case 3: /* closing */
        v->cnt++;
        if (fb_closed)
            v->state = 0;
        else if (v->cnt > 20)
            v->state = 4;
        break;
    default:
        if (!cmd)
            v->state = 0;
        break;
    }
    v->err = v->state == 4;
}

static void ramp_call(struct ramp *r, float target, float rate, bool enable)
{
    float d;

    r->target = target;
    r->rate = rate;
    r->enable = enable;
    if (enable)
        r->y = r->y + clamp(target - r->y, -rate, rate);
    d = target - r->y;
    if (d < 0)
        d = -d;
    r->done = d < 0.01f;
}

void scan(void)
{
    int32_t sum = 0;

    for (int i = 0; i < 80; i++) {
        seed = next_rand(seed);
        analog_call(&ai[i], (int16_t)(seed % 30000 - 1000), 0.0f, 120.0f);
        sum += ai[i].alarm;
        if (ai[i].fault)
            sum += 10;
    }
    for (int i = 0; i < 60; i++) {
        seed = next_rand(seed);
        valve_call(&vlv[i], seed % 3 != 0, seed % 7 == 0, seed % 11 == 0);
        sum += vlv[i].state;
        if (vlv[i].err)
            sum += 100;
    }
    for (int i = 0; i < 60; i++) {
        ramp_call(&rmp[i], ai[i].val, 1.5f, !vlv[i].err);
        if (rmp[i].done)
            sum += 7;
        sum += (int32_t)(rmp[i].y * 10.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
