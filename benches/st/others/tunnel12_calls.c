/* 40 sections with five blocks each: sensor, fan, light, door and alarm. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define SECTIONS 40

typedef enum { NORMAL, ACTIVE, ACKED, GONE } alarm_state_t;

typedef struct {
    float value;
    bool high, wire_break;
} sensor_t;

typedef struct {
    int16_t speed;
    bool running;
    int32_t hours;
} fan_t;

typedef struct {
    int16_t level, stage;
} light_t;

typedef struct {
    bool forced, contact_mem;
    int16_t openings;
    int32_t open_scans;
} door_t;

typedef struct {
    alarm_state_t state;
    bool horn;
    int32_t count;
} alarm_t;

typedef struct {
    sensor_t sensor;
    fan_t fan;
    light_t light;
    door_t door;
    alarm_t alarm;
} section_t;

static uint32_t seed = 4711;
static section_t section[SECTIONS];

static inline uint32_t next_random(uint32_t s)
{
    return s * 1664525u + 1013904223u;
}

/* 0..27648 of the input card to lo..hi */
static inline float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw / 27648.0f * (hi - lo);
}

static inline bool hysteresis(float value, float on_limit, float off_limit, bool state)
{
    if (value >= on_limit)
        return true;
    if (value <= off_limit)
        return false;
    return state;
}

static inline int16_t ramp(int16_t actual, int16_t target, int16_t step)
{
    int v;
    if (actual < target) {
        v = actual + step;
        return (int16_t)(v < target ? v : target);
    }
    v = actual - step;
    return (int16_t)(v > target ? v : target);
}

static inline uint32_t mix(uint32_t sum, int32_t value)
{
    return sum * 31u + (uint32_t)value;
}

static void sensor_update(sensor_t *s, int16_t raw, float lo, float hi,
                          float alarm_on, float alarm_off)
{
    s->wire_break = raw < 200;
    if (!s->wire_break)
        s->value += (scale(raw, lo, hi) - s->value) * 0.125f;
    s->high = hysteresis(s->value, alarm_on, alarm_off, s->high);
}

static void fan_update(fan_t *f, bool request, bool boost, bool release)
{
    int16_t target = 0;
    if (release) {
        if (boost)
            target = 1000;
        else if (request)
            target = 600;
    }
    f->speed = ramp(f->speed, target, 35);
    f->running = f->speed > 100;
    if (f->running)
        f->hours++;
}

static void light_update(light_t *l, int16_t outside, bool emergency)
{
    if (emergency)
        l->stage = 4;
    else if (outside >= 0 && outside < 100)
        l->stage = 0;
    else if (outside >= 100 && outside < 400)
        l->stage = 1;
    else if (outside >= 400 && outside < 700)
        l->stage = 2;
    else
        l->stage = 3;
    l->level = ramp(l->level, (int16_t)(l->stage * 250), 20);
}

static void door_update(door_t *d, bool contact, bool lock)
{
    if (contact && !d->contact_mem) {
        d->openings++;
        if (lock)
            d->forced = true;
    }
    d->contact_mem = contact;
    if (contact) {
        d->open_scans++;
    } else {
        d->open_scans = 0;
        d->forced = d->forced && lock;
    }
}

static void alarm_update(alarm_t *a, bool signal, bool ack)
{
    switch (a->state) {
    case NORMAL:
        if (signal) {
            a->state = ACTIVE;
            a->count++;
        }
        break;
    case ACTIVE:
        if (ack)
            a->state = ACKED;
        else if (!signal)
            a->state = GONE;
        break;
    case ACKED:
        if (!signal)
            a->state = NORMAL;
        break;
    case GONE:
        if (signal)
            a->state = ACTIVE;
        else if (ack)
            a->state = NORMAL;
        break;
    }
    a->horn = a->state == ACTIVE;
}

void scan(void)
{
    seed = next_random(seed);
    bool ack_button = (seed >> 16) % 16 == 0;
    int16_t outside = (int16_t)((seed >> 20) % 1000);
    bool any_horn = false;
    uint32_t sum = 17;

    for (int i = 0; i < SECTIONS; i++) {
        section_t *s = &section[i];
        seed = next_random(seed);
        uint32_t bits = seed >> 16;

        sensor_update(&s->sensor, (int16_t)(bits % 27648), 0.0f, 300.0f, 165.0f, 140.0f);
        door_update(&s->door, bits % 8 < 3, bits % 64 >= 32);
        alarm_update(&s->alarm, s->sensor.high || s->door.forced, ack_button);
        fan_update(&s->fan, s->sensor.value > 130.0f, s->alarm.horn, !s->sensor.wire_break);
        light_update(&s->light, outside, s->alarm.horn || s->door.open_scans > 3);

        any_horn = any_horn || s->alarm.horn;
        sum = mix(sum, (int32_t)lrintf(s->sensor.value * 10.0f));
        sum = mix(sum, s->fan.speed + s->fan.hours);
        sum = mix(sum, s->light.level);
        sum = mix(sum, s->door.openings);
        sum = mix(sum, s->alarm.count);
    }

    if (any_horn)
        sum += 1;
    check = (int32_t)sum;
}
