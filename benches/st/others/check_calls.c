/* 200 calls of function blocks that call functions, and some hundred direct calls of functions. */
#include <stdbool.h>
#include "st.h"

static float scale(float in, float in_min, float in_max, float out_min, float out_max)
{
    return (in - in_min) * (out_max - out_min) / (in_max - in_min) + out_min;
}

static float filter(float old, float new, float factor)
{
    return old + (new - old) * factor;
}

static float dead_band(float in, float band)
{
    if (in > band)
        return in - band;
    if (in < -band)
        return in + band;
    return 0.0f;
}

static bool hysteresis(bool old, float in, float on, float off)
{
    if (in >= on)
        return true;
    if (in <= off)
        return false;
    return old;
}

static float ramp(float old, float target, float step)
{
    if (target > old + step)
        return old + step;
    if (target < old - step)
        return old - step;
    return target;
}

static int32_t clamp(int32_t in, int32_t min, int32_t max)
{
    if (in < min)
        return min;
    if (in > max)
        return max;
    return in;
}

static int32_t hash(int32_t h, int32_t in)
{
    return (h * 31 + in) % 65521;
}

static int32_t next_random(int32_t *seed, int32_t range)
{
    *seed = (*seed * 4005 + 12345) % 65536;
    return *seed / 16 % range;
}

typedef struct { float value; bool high, low; } analog_t;

static void analog_in(analog_t *a, int16_t raw, float min, float max, float factor)
{
    float span = max - min;
    a->value = filter(a->value, scale((float)raw, 0.0f, 27648.0f, min, max), factor);
    a->high = hysteresis(a->high, a->value, min + span * 0.6f, min + span * 0.55f);
    a->low = hysteresis(a->low, -a->value, -(min + span * 0.4f), -(min + span * 0.45f));
}

typedef struct { float speed; bool at_speed; int32_t revs, pulses; } drive_t;

static void drive(drive_t *d, bool enable, float speed_set)
{
    if (enable)
        d->speed = ramp(d->speed, dead_band(speed_set, 2.0f), 1.5f);
    else
        d->speed = ramp(d->speed, 0.0f, 3.0f);
    d->at_speed = enable && dead_band(speed_set - d->speed, 2.5f) == 0.0f;
    d->pulses += clamp((int32_t)d->speed, 0, 60);
    if (d->pulses >= 1024) {
        d->pulses -= 1024;
        d->revs = (d->revs + 1) % 10000;
    }
}

typedef struct { int16_t state; int32_t pos, cycles; bool is_open, is_closed; } valve_t;

static void valve(valve_t *v, bool open, int32_t travel)
{
    switch (v->state) {
    case 0: /* closed */
        if (open)
            v->state = 1;
        break;
    case 1: /* opens */
        v->pos = clamp(v->pos + 1, 0, travel);
        if (!open)
            v->state = 3;
        else if (v->pos == travel)
            v->state = 2;
        break;
    case 2: /* open */
        if (!open)
            v->state = 3;
        break;
    case 3: /* closes */
        v->pos = clamp(v->pos - 1, 0, travel);
        if (open) {
            v->state = 1;
        } else if (v->pos == 0) {
            v->state = 0;
            v->cycles = hash(v->cycles, travel);
        }
        break;
    }
    v->is_open = v->state == 2;
    v->is_closed = v->state == 0;
}

static int32_t seed = 4711;
static int32_t level;
static analog_t analogs[97];
static drive_t drives[61];
static valve_t valves[41];
static analog_t main_pressure, main_flow;
static drive_t main_pump;
static valve_t main_valve;

void scan(void)
{
    int32_t h = 1;

    for (int i = 1; i <= 96; i++) {
        analog_in(&analogs[i], (int16_t)(next_random(&seed, 3000) * 9), 0.0f, 100.0f, 0.2f);
        h = hash(h, (int32_t)(analogs[i].value * 10.0f));
    }

    for (int i = 1; i <= 60; i++) {
        drive(&drives[i], !analogs[i].high, analogs[i + 30].value);
        if (drives[i].at_speed)
            h = hash(h, i);
        h = hash(h, drives[i].revs);
    }

    for (int i = 1; i <= 40; i++) {
        valve(&valves[i], analogs[i + 5].low || drives[i].at_speed, clamp(i, 3, 12));
        h = hash(h, valves[i].cycles);
        if (valves[i].is_open)
            h = hash(h, i);
        else if (valves[i].is_closed)
            h = hash(h, i + 100);
    }

    analog_in(&main_pressure, (int16_t)(next_random(&seed, 3900) * 7), 0.0f, 16.0f, 0.1f);
    analog_in(&main_flow, (int16_t)(next_random(&seed, 3900) * 7), 5.0f, 250.0f, 0.05f);
    drive(&main_pump, !main_pressure.high, main_flow.value);
    valve(&main_valve, main_pump.at_speed || main_pressure.low, 5);
    h = hash(h, (int32_t)(main_pump.speed * 4.0f) + main_valve.cycles + main_valve.is_open);

    float total = 0.0f;
    for (int i = 1; i <= 96; i++) {
        total = filter(total, dead_band(analogs[i].value - 50.0f, 4.0f), 0.1f);
        level = clamp(level + (int32_t)(total * 2.0f), -1000, 1000);
    }

    check = hash(hash(check, h), level);
}
