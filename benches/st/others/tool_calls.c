#include <stdbool.h>
#include "st.h"

static float scale_int(int16_t raw, int16_t raw_min, int16_t raw_max, float eng_min, float eng_max)
{
    return eng_min + (eng_max - eng_min) * (float)(raw - raw_min) / (float)(raw_max - raw_min);
}

static float lowpass(float x, float last, float k)
{
    return last + k * (x - last);
}

static bool in_window(float x, float lo, float hi)
{
    return x >= lo && x <= hi;
}

static int32_t clamp_dint(int32_t x, int32_t lo, int32_t hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static int16_t wrap(int16_t v, int16_t top)
{
    if (v >= top)
        return (int16_t)(v - top);
    return v;
}

static int32_t next_random(int32_t seed)
{
    return (seed * 1109 + 12345) % 65536;
}

struct analog_input {
    int16_t raw;
    float eng_max;
    float value;
    bool ok, high, low;
    int16_t bad_count;
};

static void analog_input(struct analog_input *a)
{
    if (a->raw < -50 || a->raw > 27700) {
        a->bad_count++;
        if (a->bad_count > 3) {
            a->ok = false;
            a->bad_count = 3;
        }
    } else {
        a->bad_count = 0;
        a->ok = true;
        a->value = lowpass(scale_int(a->raw, 0, 27648, 0.0f, a->eng_max), a->value, 0.25f);
    }
    a->high = a->ok && a->value > 0.9f * a->eng_max;
    a->low = a->ok && !in_window(a->value, 0.1f * a->eng_max, a->eng_max);
}

struct valve {
    bool open_cmd, interlock;
    int16_t travel;
    bool is_open, is_closed, moving;
    int16_t position;
    int16_t state;
};

static void valve(struct valve *v)
{
    switch (v->state) {
    case 0:
        v->position = 0;
        if (v->open_cmd && !v->interlock)
            v->state = 1;
        break;
    case 1:
        v->position++;
        if (v->interlock || !v->open_cmd)
            v->state = 3;
        else if (v->position >= v->travel)
            v->state = 2;
        break;
    case 2:
        if (v->interlock || !v->open_cmd)
            v->state = 3;
        break;
    case 3:
        v->position--;
        if (v->position <= 0)
            v->state = 0;
        else if (v->open_cmd && !v->interlock)
            v->state = 1;
        break;
    default:
        v->state = 0;
        break;
    }
    v->is_open = v->state == 2;
    v->is_closed = v->state == 0;
    v->moving = v->state == 1 || v->state == 3;
}

struct totalizer {
    float flow;
    bool enable, reset;
    int32_t total;
    int16_t slot;
    float remainder;
    int32_t history[8];
    int32_t whole;
};

static void totalizer(struct totalizer *t)
{
    if (t->reset) {
        t->total = 0;
        t->remainder = 0.0f;
    } else if (t->enable) {
        t->remainder = t->remainder + t->flow * 0.1f;
        t->whole = (int32_t)t->remainder;
        t->remainder = t->remainder - (float)t->whole;
        t->total = clamp_dint(t->total + t->whole, 0, 999999);
    }
    t->history[t->slot] = t->total;
    t->slot = wrap((int16_t)(t->slot + 1), 8);
}

static int32_t seed = 4711;
static struct analog_input ai[80];
static struct valve valves[60];
static struct totalizer tot[60];

void scan(void)
{
    int16_t n_high = 0, n_open = 0;
    int32_t sum_pos = 0, sum_tot = 0;
    float sum_val = 0.0f;

    for (int i = 0; i < 80; i++) {
        seed = next_random(seed);
        ai[i].raw = (int16_t)(seed % 28000 - 100);
        ai[i].eng_max = 50.0f + (float)i;
        analog_input(&ai[i]);
        if (ai[i].high || ai[i].low)
            n_high++;
        sum_val = sum_val + ai[i].value;
    }
    for (int i = 0; i < 60; i++) {
        valves[i].open_cmd = ai[i].value > 0.4f * (50.0f + (float)i);
        valves[i].interlock = ai[i + 20].high;
        valves[i].travel = (int16_t)(5 + i % 7);
        valve(&valves[i]);
        if (valves[i].is_open)
            n_open++;
        sum_pos += valves[i].position;
    }
    for (int i = 0; i < 60; i++) {
        tot[i].flow = ai[i].value;
        tot[i].enable = !valves[i].is_closed;
        tot[i].reset = tot[i].total > 20000 + 100 * i;
        totalizer(&tot[i]);
        sum_tot += tot[i].total;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)sum_val + n_high * 3 + n_open * 5 + sum_pos * 7 + sum_tot));
}
