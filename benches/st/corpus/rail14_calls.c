#include <stdbool.h>
#include "st.h"

enum door_state { CLOSED, OPENING, OPENED, CLOSING, BLOCKED };

struct door { int32_t position, cycles; enum door_state state; };
struct brush { int32_t filtered, speed; bool overload; };
struct valve { int32_t lift, flow; };

static struct door door[100];
static struct brush brush[60];
static struct valve valve[40];
static int32_t energy, tick;

static inline int32_t min32(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t max32(int32_t a, int32_t b) { return a > b ? a : b; }

static inline int32_t ramp(int32_t actual, int32_t target, int32_t step)
{
    return actual < target ? min32(actual + step, target) : max32(actual - step, target);
}

static inline int32_t scale(int32_t raw, int32_t in_max, int32_t out_max)
{
    return min32(max32(raw, 0), in_max) * out_max / in_max;
}

static inline int32_t mix(int32_t hash, int32_t value)
{
    return (int32_t)((uint32_t)hash * 31u + (uint32_t)value);
}

static void door_run(struct door *d, bool open, bool obstacle)
{
    switch (d->state) {
    case CLOSED:
        if (open)
            d->state = OPENING;
        break;
    case OPENING:
        d->position = ramp(d->position, 1000, 45);
        if (d->position == 1000) {
            d->state = OPENED;
            d->cycles++;
        }
        break;
    case OPENED:
        if (!open)
            d->state = CLOSING;
        break;
    case CLOSING:
        d->position = ramp(d->position, 0, 30);
        if (obstacle)
            d->state = BLOCKED;
        else if (d->position == 0)
            d->state = CLOSED;
        break;
    case BLOCKED:
        d->position = ramp(d->position, 1000, 10);
        if (!obstacle)
            d->state = OPENING;
        break;
    }
}

static void brush_run(struct brush *b, bool run, int32_t load, int32_t *e)
{
    b->filtered += (load - b->filtered) / 4;
    b->overload = b->filtered > 700;
    b->speed = ramp(b->speed, run && !b->overload ? 1500 : 0, 60);
    *e = (int32_t)((uint32_t)*e + (uint32_t)scale(b->filtered, 1000, b->speed));
}

static void valve_run(struct valve *v, int32_t demand)
{
    v->lift = ramp(v->lift, scale(demand, 4095, 1000), 25);
    v->flow = scale(v->lift * v->lift / 100, 10000, 640);
}

void scan(void)
{
    int32_t h = 0;

    tick++;
    for (int32_t i = 0; i < 100; i++) {
        struct door *d = &door[i];
        door_run(d, (tick + i * 11) % 150 < 70, (tick + i * 3) % 37 == 0);
        h = mix(h, d->position + d->cycles);
        if (d->state == BLOCKED)
            h = (int32_t)((uint32_t)h + 1u);
    }
    for (int32_t i = 0; i < 60; i++) {
        struct brush *b = &brush[i];
        brush_run(b, (tick + i * 5) % 90 < 60, (int32_t)((uint32_t)tick * 13u + (uint32_t)i * 29u) % 1100, &energy);
        h = mix(h, b->speed);
        if (b->overload)
            h = (int32_t)((uint32_t)h + 7u);
    }
    for (int32_t i = 0; i < 40; i++) {
        valve_run(&valve[i], (int32_t)((uint32_t)tick * 3u + (uint32_t)i * 101u) % 5000);
        h = mix(h, valve[i].flow);
    }
    check = mix(mix(check, h), energy);
}
