/* 460 calls of function blocks of four kinds, which use common functions */
#include <stdbool.h>
#include "st.h"

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static float clamp(float in, float min, float max)
{
    if (in < min)
        return min;
    if (in > max)
        return max;
    return in;
}

static bool hyst(float in, float on, float off, bool old)
{
    if (in >= on)
        return true;
    if (in < off)
        return false;
    return old;
}

static uint32_t next_random(uint32_t seed)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    return seed ^ (seed << 5);
}

static int16_t bucket(int32_t val)
{
    if (val < 100)
        return 0;
    if (val < 1000)
        return 1;
    if (val < 10000)
        return 2;
    return 3;
}

/* analog input: scaling, wire break, filter, limits */
typedef struct {
    float value;
    bool hi, lo, brk;
    int16_t nbreak;
} Analog;

static void analog(Analog *s, int16_t raw, float lo, float hi, float alpha)
{
    if (raw < -1000) {
        if (s->nbreak < 10)
            s->nbreak++;
    } else {
        s->nbreak = 0;
    }
    s->brk = s->nbreak >= 3;
    if (!s->brk) {
        float v = clamp(scale(raw, lo, hi), lo, hi);
        s->value += (v - s->value) * alpha;
    }
    s->hi = hyst(s->value, hi * 0.75f, hi * 0.7f, s->hi);
    s->lo = !hyst(s->value, hi * 0.3f, hi * 0.25f, !s->lo);
}

/* valve with end switches, run time supervision and fault */
typedef struct {
    int16_t state; /* 0 closed, 1 opening, 2 open, 3 closing, 9 fault */
    bool fault;
    float pos;
    int16_t timer;
    int32_t strokes;
} Valve;

static void valve(Valve *s, bool open_cmd, bool locked, bool reset, int16_t run_time)
{
    switch (s->state) {
    case 0:
        if (open_cmd && !locked) {
            s->state = 1;
            s->timer = 0;
        }
        break;
    case 1:
        s->timer++;
        s->pos = clamp(s->pos + 7.5f, 0.0f, 100.0f);
        if (s->pos >= 100.0f) {
            s->state = 2;
            s->strokes++;
        } else if (s->timer > run_time) {
            s->state = 9;
        } else if (!open_cmd) {
            s->state = 3;
            s->timer = 0;
        }
        break;
    case 2:
        if (!open_cmd || locked) {
            s->state = 3;
            s->timer = 0;
        }
        break;
    case 3:
        s->timer++;
        s->pos = clamp(s->pos - 6.0f, 0.0f, 100.0f);
        if (s->pos <= 0.0f)
            s->state = 0;
        else if (s->timer > run_time)
            s->state = 9;
        break;
    case 9:
        if (reset) {
            s->state = 3;
            s->timer = 0;
        }
        break;
    }
    s->fault = s->state == 9;
}

/* totalizer with whole units and remainder */
typedef struct {
    int32_t units;
    int16_t bucket;
    int16_t rest;
} Totalizer;

static void totalizer(Totalizer *s, int16_t pulses, int16_t per_unit, bool reset)
{
    if (reset) {
        s->units = 0;
        s->rest = 0;
    }
    s->rest += pulses;
    while (s->rest >= per_unit) {
        s->rest -= per_unit;
        s->units++;
    }
    s->bucket = bucket(s->units);
}

/* drive: ramped speed, direction change only at stand-still */
typedef struct {
    float speed;
    bool at_speed, stand_still;
} Drive;

static float absf(float x)
{
    return x < 0.0f ? -x : x;
}

static void drive(Drive *s, float speed_sp, float acc, bool enable)
{
    float target = 0.0f;

    if (enable) {
        target = clamp(speed_sp, -1500.0f, 1500.0f);
        if (target * s->speed < 0.0f)
            target = 0.0f;
    }
    s->speed = clamp(target, s->speed - acc, s->speed + acc);
    s->stand_still = absf(s->speed) < 1.0f;
    s->at_speed = enable && absf(speed_sp - s->speed) < 5.0f;
}

static Analog analogs[184];
static Valve valves[140];
static Totalizer totals[84];
static Drive drives[48];
static Drive main_drive, feed_pump;
static Valve inlet_valve, outlet_valve;
static uint32_t seed = 0x12345678u;
static int16_t nscan;

void scan(void)
{
    int i;
    int32_t alarms = 0, sum = 0;
    bool reset;

    nscan++;
    if (nscan >= 2000)
        nscan = 0;
    seed = next_random(seed);
    reset = nscan % 250 == 0;

    for (i = 1; i <= 184; i++) {
        Analog *a = &analogs[i - 1];
        int16_t raw = (nscan * 13 + i * 33) % 27648;
        if (nscan > 1900 && i % 16 == 0)
            raw = -5000;
        analog(a, raw, 0.0f, 150.0f, 0.125f);
        if (a->hi || a->lo || a->brk)
            alarms++;
    }

    valve(&inlet_valve, analogs[0].value < 75.0f, false, reset, 20);
    valve(&outlet_valve, analogs[0].value > 70.0f, inlet_valve.state != 0, reset, 20);

    for (i = 1; i <= 140; i++) {
        Valve *v = &valves[i - 1];
        valve(v, (nscan + i * 5) % 64 < 30, analogs[i - 1].brk, reset, 14 + i % 5);
        sum += v->state;
        if (v->fault)
            alarms++;
    }

    for (i = 1; i <= 84; i++) {
        Totalizer *t = &totals[i - 1];
        totalizer(t, (int16_t)((seed >> (i % 16)) & 0x1Fu), 10 + i % 3, nscan == i);
        sum += t->units * 3 + t->bucket;
    }

    drive(&main_drive, analogs[1].value * 10.0f, 4.0f, inlet_valve.state == 2);
    drive(&feed_pump, main_drive.speed * 0.8f, 6.0f, !inlet_valve.fault);
    for (i = 1; i <= 48; i++) {
        Drive *d = &drives[i - 1];
        drive(d, (analogs[i - 1].value - 75.0f) * 20.0f, 25.0f, valves[i - 1].state == 2);
        sum += (int32_t)d->speed;
        if (d->at_speed)
            sum += i;
    }

    check = (int32_t)((uint32_t)check * 31u + sum + alarms * 1009 + (int32_t)(feed_pump.speed * 10.0f) + outlet_valve.state);
}
