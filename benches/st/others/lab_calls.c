/* 50 measuring points, each with scaling, alarm, ramp and totalizer: 200 block calls, with functions */
#include <stdbool.h>
#include "st.h"

#define POINTS 50

static float interpolate(float x, float x0, float x1, float y0, float y1)
{
    if (x1 == x0)
        return y0;
    return y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

static float clamp(float v, float lo, float hi)
{
    if (v < lo)
        return lo;
    if (v > hi)
        return hi;
    return v;
}

static int16_t severity(bool hh, bool h, bool l, bool ll)
{
    if (hh || ll)
        return 3;
    if (h)
        return 2;
    if (l)
        return 1;
    return 0;
}

static int32_t add_wrap(int32_t a, int32_t b, int32_t modulus)
{
    int32_t s = a + b;
    if (s >= modulus)
        s -= modulus;
    return s;
}

typedef struct { int16_t raw; float lo, hi; float value; bool broken; float filt; } scale_t;

static void scale_run(scale_t *s, int16_t raw, float lo, float hi)
{
    s->raw = raw;
    s->lo = lo;
    s->hi = hi;
    s->broken = raw < 100 || raw > 27500;
    s->filt = s->filt + 0.25f * (interpolate((float)raw, 0.0f, 27648.0f, lo, hi) - s->filt);
    s->value = clamp(s->filt, lo, hi);
}

typedef struct {
    float value, lim_hh, lim_h, lim_l, lim_ll, hyst;
    bool inhibit;
    bool hh, h, l, ll;
    int16_t level;
    int32_t changes;
    int16_t old;
} alarm_t;

static void alarm_run(alarm_t *a, float value, float lim_hh, float lim_h, float lim_l, float lim_ll,
                      float hyst, bool inhibit)
{
    a->value = value;
    a->lim_hh = lim_hh;
    a->lim_h = lim_h;
    a->lim_l = lim_l;
    a->lim_ll = lim_ll;
    a->hyst = hyst;
    a->inhibit = inhibit;
    a->hh = !inhibit && (value > lim_hh || (a->hh && value > lim_hh - hyst));
    a->h = !inhibit && (value > lim_h || (a->h && value > lim_h - hyst));
    a->l = !inhibit && (value < lim_l || (a->l && value < lim_l + hyst));
    a->ll = !inhibit && (value < lim_ll || (a->ll && value < lim_ll + hyst));
    a->level = severity(a->hh, a->h, a->l, a->ll);
    if (a->level != a->old) {
        a->changes++;
        a->old = a->level;
    }
}

typedef struct { float target, step; float out; bool busy; } ramp_t;

static void ramp_run(ramp_t *r, float target, float step)
{
    r->target = target;
    r->step = step;
    r->out = r->out + clamp(target - r->out, -step, step);
    r->busy = r->out != target;
}

typedef struct { float flow; bool reset; int32_t total; bool pulse; int32_t rest; } total_t;

static void total_run(total_t *t, float flow, bool reset)
{
    int32_t part;

    t->flow = flow;
    t->reset = reset;
    if (reset) {
        t->total = 0;
        t->rest = 0;
    }
    part = (int32_t)clamp(flow, 0.0f, 900.0f);
    t->rest += part;
    t->pulse = t->rest >= 1000;
    if (t->pulse) {
        t->rest -= 1000;
        t->total = add_wrap(t->total, 1, 100000);
    }
}

static int16_t ai[POINTS];
static scale_t scale[POINTS];
static alarm_t alarms[POINTS];
static ramp_t ramp[POINTS];
static total_t total[POINTS];
static int32_t n;

void scan(void)
{
    int i;
    int32_t sum = 0;

    n++;
    for (i = 0; i < POINTS; i++) {
        /* simulated analog input */
        ai[i] = ai[i] + 37 + i * 11;
        if (ai[i] > 27648)
            ai[i] -= 27648;

        scale_run(&scale[i], ai[i], 0.0f, 500.0f);
        alarm_run(&alarms[i], scale[i].value, 450.0f, 400.0f, 100.0f, 50.0f, 5.0f, scale[i].broken);
        ramp_run(&ramp[i], scale[i].value, 2.5f);
        total_run(&total[i], ramp[i].out, n % 1000 == 0);

        sum += alarms[i].level + alarms[i].changes * 3 + total[i].total * 7 + (int32_t)ramp[i].out;
        if (ramp[i].busy)
            sum += 100;
        if (total[i].pulse)
            sum += 50;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
