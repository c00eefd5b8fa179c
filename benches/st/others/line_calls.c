/* Chapter 4: functions and function blocks. 80 conveyors, 60 valves, 60 check weighers. */
#include <stdbool.h>
#include "st.h"

#define BIT(w, n) (((w) >> (n)) & 1u)

#define CONVEYORS 80
#define VALVES 60
#define SCALES 60

static float scale_analog(int16_t raw, float low, float high)
{
    return low + (float)raw * (high - low) / 27648.0f;
}

static bool in_band(float value, float center, float tolerance)
{
    float d = value - center;
    if (d < 0.0f)
        d = -d;
    return d <= tolerance;
}

static int16_t approach(int16_t value, int16_t goal, int16_t step)
{
    if (value + step < goal)
        return value + step;
    if (value - step > goal)
        return value - step;
    return goal;
}

static uint32_t next_random(uint32_t seed)
{
    return seed * 1664525u + 1013904223u;
}

typedef struct {
    bool rise, fall;
    bool old;
} Edge;

static void edge(Edge *e, bool signal)
{
    e->rise = signal && !e->old;
    e->fall = !signal && e->old;
    e->old = signal;
}

typedef struct {
    int16_t speed;
    bool running;
    int32_t count;
    int32_t distance;
    Edge eye_edge;
} Conveyor;

static void conveyor(Conveyor *c, bool enable, bool eye, int16_t speed_set)
{
    if (enable)
        c->speed = approach(c->speed, speed_set, 25);
    else
        c->speed = approach(c->speed, 0, 60);
    c->running = c->speed > 0;
    edge(&c->eye_edge, eye);
    if (c->eye_edge.rise && c->running)
        c->count++;
    c->distance += c->speed;
    if (c->distance > 1000000)
        c->distance -= 1000000;
}

typedef struct {
    int16_t state;
    int32_t cycles;
    bool fault;
    int16_t waiting;
} Valve;

static void valve(Valve *v, bool open, bool close, bool feedback)
{
    switch (v->state) {
    case 0: /* closed */
        if (open && !close) {
            v->state = 1;
            v->waiting = 0;
        }
        break;
    case 1: /* opening */
        v->waiting++;
        if (feedback)
            v->state = 2;
        else if (v->waiting > 6)
            v->state = 4;
        break;
    case 2: /* open */
        if (close) {
            v->state = 3;
            v->waiting = 0;
        }
        break;
    case 3: /* closing */
        v->waiting++;
        if (!feedback) {
            v->state = 0;
            v->cycles++;
        } else if (v->waiting > 6) {
            v->state = 4;
        }
        break;
    default:
        if (close && !feedback)
            v->state = 0;
        break;
    }
    v->fault = v->state == 4;
}

typedef struct {
    float weight;
    float average;
    int32_t good;
    int32_t bad;
} CheckWeigher;

static void check_weigher(CheckWeigher *w, int16_t raw, float nominal)
{
    w->weight = scale_analog(raw, 0.0f, 500.0f);
    w->average = w->average + (w->weight - w->average) * 0.125f;
    if (in_band(w->weight, nominal, 75.0f))
        w->good++;
    else
        w->bad++;
}

static Conveyor conv[CONVEYORS];
static Valve valves[VALVES];
static CheckWeigher scales[SCALES];
static uint32_t seed = 12345;

void scan(void)
{
    int i;
    int16_t raw;
    int32_t sum = 0;
    float avg = 0.0f;

    for (i = 0; i < CONVEYORS; i++) {
        seed = next_random(seed);
        conveyor(&conv[i], BIT(seed, 31) || BIT(seed, 30), BIT(seed, 29), 300 + i * 5);
        sum += conv[i].speed + conv[i].count + conv[i].distance;
        if (conv[i].running)
            sum++;
    }

    for (i = 0; i < VALVES; i++) {
        seed = next_random(seed);
        valve(&valves[i], BIT(seed, 31), BIT(seed, 30), BIT(seed, 29) && BIT(seed, 28));
        sum += valves[i].state * 3 + valves[i].cycles;
        if (valves[i].fault)
            sum += 7;
    }

    for (i = 0; i < SCALES; i++) {
        seed = next_random(seed);
        raw = (int16_t)(seed / 65536u % 27649u);
        check_weigher(&scales[i], raw, 250.0f);
        avg += scales[i].average;
        sum += scales[i].good - scales[i].bad;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(int32_t)avg);
}
