#include <stdbool.h>
#include <xmmintrin.h>
#include "st.h"

#define COUNT 50

typedef enum { VALVE_CLOSED, VALVE_OPENING, VALVE_OPEN, VALVE_CLOSING, VALVE_FAULT } valve_state_t;
typedef enum { ALARM_NONE, ALARM_LOW, ALARM_HIGH } alarm_t;

/* Rounds to the nearest, halves to even (no libm here, so no lrintf). */
static int32_t real_to_dint(float x)
{
    return _mm_cvtss_si32(_mm_set_ss(x));
}

static int32_t clamp(int32_t low, int32_t value, int32_t high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}

static int32_t ramp(int32_t actual, int32_t target, int32_t step)
{
    return actual + clamp(-step, target - actual, step);
}

static float scale(int16_t raw, float low, float high)
{
    return low + (float)raw * (high - low) / 27648.0f;
}

static int16_t wrap(int16_t value, int16_t limit)
{
    if (value >= limit)
        return (int16_t)(value - limit);
    return value;
}

static alarm_t alarm_of(float value, float low, float high)
{
    if (value < low)
        return ALARM_LOW;
    if (value > high)
        return ALARM_HIGH;
    return ALARM_NONE;
}

typedef struct {
    bool open, reset;
    int16_t travel;
    valve_state_t state;
    bool coil;
    int16_t count, faults;
} valve_t;

static void valve(valve_t *v)
{
    switch (v->state) {
    case VALVE_CLOSED:
        if (v->open) {
            v->state = VALVE_OPENING;
            v->count = 0;
        }
        break;
    case VALVE_OPENING:
        v->count++;
        if (!v->open)
            v->state = VALVE_CLOSING;
        else if (v->count >= v->travel)
            v->state = VALVE_OPEN;
        break;
    case VALVE_OPEN:
        if (!v->open) {
            v->state = VALVE_CLOSING;
            v->count = v->travel;
        }
        break;
    case VALVE_CLOSING:
        v->count--;
        if (v->count <= 0) {
            v->state = VALVE_CLOSED;
        } else if (v->open) {
            v->state = VALVE_FAULT;
            v->faults = wrap((int16_t)(v->faults + 1), 100);
        }
        break;
    case VALVE_FAULT:
        if (v->reset)
            v->state = VALVE_CLOSED;
        break;
    }
    v->coil = v->state == VALVE_OPENING || v->state == VALVE_OPEN;
}

typedef struct {
    bool run, reverse;
    int32_t speed;
    int32_t actual, position;
    bool at_speed;
    int32_t target;
} drive_t;

static void drive(drive_t *d)
{
    d->target = 0;
    if (d->run) {
        d->target = clamp(0, d->speed, 3000);
        if (d->reverse)
            d->target = -d->target;
    }
    d->actual = ramp(d->actual, d->target, 75);
    d->position += d->actual;
    d->at_speed = d->actual == d->target;
}

typedef struct {
    int16_t raw;
    float low, high;
    float value;
    alarm_t alarm;
    int16_t alarms;
    alarm_t alarm_old;
} analog_t;

static void analog(analog_t *a)
{
    a->value = a->value + 0.25f * (scale(a->raw, a->low, a->high) - a->value);
    a->alarm = alarm_of(a->value, a->low + 10.0f, a->high - 10.0f);
    if (a->alarm != a->alarm_old && a->alarm != ALARM_NONE)
        a->alarms = wrap((int16_t)(a->alarms + 1), 1000);
    a->alarm_old = a->alarm;
}

typedef struct {
    bool sensor;
    int16_t package;
    int16_t parts;
    int32_t packages;
    bool old;
} counter_t;

static void counter(counter_t *c)
{
    if (c->sensor && !c->old) {
        c->parts = wrap((int16_t)(c->parts + 1), c->package);
        if (c->parts == 0)
            c->packages++;
    }
    c->old = c->sensor;
}

static valve_t valves[COUNT];
static drive_t drives[COUNT];
static analog_t analogs[COUNT];
static counter_t counters[COUNT];
static bool init_done;
static int16_t scans;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < COUNT; i++)
            analogs[i].high = 100.0f;
        init_done = true;
    }

    scans = wrap((int16_t)(scans + 1), 12000);
    for (int i = 0; i < COUNT; i++) {
        int16_t phase = (int16_t)((scans + i * 7) % 97);

        valves[i].open = phase < 40 + i % 30;
        valves[i].reset = phase == 90;
        valves[i].travel = (int16_t)(10 + i % 8);
        valve(&valves[i]);

        drives[i].run = valves[i].coil;
        drives[i].reverse = phase > 60;
        drives[i].speed = (int32_t)phase * 50;
        drive(&drives[i]);

        analogs[i].raw = (int16_t)(phase * 280);
        analogs[i].low = 0.0f;
        analog(&analogs[i]);

        counters[i].sensor = drives[i].at_speed && phase % 2 == 0;
        counters[i].package = 12;
        counter(&counters[i]);
    }

    for (int i = 0; i < COUNT; i++) {
        switch (valves[i].state) {
        case VALVE_OPEN:
            check += 1;
            break;
        case VALVE_FAULT:
            check += 50;
            break;
        default:
            break;
        }
        check += drives[i].position + analogs[i].alarms + counters[i].parts + counters[i].packages
               + real_to_dint(analogs[i].value);
    }
}
