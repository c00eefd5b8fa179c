#include <math.h>
#include <stdbool.h>
#include "st.h"

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static float lag(float x, float old, float alpha)
{
    return old + alpha * (x - old);
}

static bool hysteresis(float x, float lim, float hyst, bool old)
{
    if (x > lim)
        return true;
    if (x < lim - hyst)
        return false;
    return old;
}

static int16_t permille(float x, float lo, float hi)
{
    float f = (x - lo) / (hi - lo);
    f = f < 0.0f ? 0.0f : f > 1.0f ? 1.0f : f;
    return (int16_t)lrintf(f * 1000.0f);
}

static int16_t approach(int16_t pos, int16_t goal, int16_t incr)
{
    int next;
    if (pos < goal) {
        next = pos + incr;
        return (int16_t)(next < goal ? next : goal);
    }
    next = pos - incr;
    return (int16_t)(next > goal ? next : goal);
}

typedef struct { float pv; int16_t bar; bool high, fault; } analog_in;
typedef struct { float rest; int32_t litres; } totaliser;
typedef struct { int16_t pos; bool moving; } valve;

static void analog_update(analog_in *a, int16_t raw, float lo, float hi, float alm_h)
{
    a->fault = raw < -200 || raw > 27648;
    if (!a->fault)
        a->pv = lag(scale(raw, lo, hi), a->pv, 0.25f);
    a->high = hysteresis(a->pv, alm_h, 2.0f, a->high);
    a->bar = permille(a->pv, lo, hi);
}

static void totaliser_update(totaliser *t, float flow, bool clear)
{
    float rest = lag(flow, t->rest, 0.5f) + 0.125f;
    int32_t whole = (int32_t)rest;
    t->rest = rest - (float)whole;
    if (clear)
        t->litres = 0;
    else
        t->litres += whole;
}

static void valve_update(valve *v, int16_t goal, bool block)
{
    int16_t old = v->pos;
    v->pos = block ? approach(old, 0, 50) : approach(old, goal, 7);
    v->moving = v->pos != old;
}

static analog_in analog[120];
static totaliser totals[40];
static valve valves[40];
static uint32_t seed = 777;
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    uint32_t n_high = 0, n_fault = 0, bar_sum = 0;
    for (int i = 0; i < 120; i++) {
        analog_in *a = &analog[i];
        seed = seed * 1664525u + 1013904223u;
        int16_t raw = (int16_t)((seed >> 17) % 28000);
        analog_update(a, raw, -10.0f, 90.0f + (float)i, 55.0f);
        n_high += a->high;
        n_fault += a->fault;
        bar_sum += (uint32_t)a->bar;
    }

    uint32_t litres = 0, pos_sum = 0, n_moving = 0;
    for (int i = 0; i < 40; i++) {
        totaliser_update(&totals[i], analog[3 * i].pv, (scan_no + i) % 256 == 0);
        litres += (uint32_t)totals[i].litres;
        valve_update(&valves[i], analog[3 * i + 1].bar, analog[3 * i + 2].high);
        pos_sum += (uint32_t)valves[i].pos;
        n_moving += valves[i].moving;
    }

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + n_high;
    sum = sum * 31 + n_fault;
    sum = sum * 31 + bar_sum;
    sum = sum * 31 + litres;
    sum = sum * 31 + pos_sum;
    sum = sum * 31 + n_moving;
    check = (int32_t)sum;
}
