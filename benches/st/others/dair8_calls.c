/* Filler line: 200 calls of blocks per scan, each of which calls functions */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

#define STATIONS 50
#define TARGET 500

typedef enum { PUMP_STOPPED, PUMP_STARTING, PUMP_RUNNING, PUMP_TRIPPED } pump_state;

typedef struct {
    int16_t raw;
    float flow;
    int32_t volume;
    pump_state pump;
    int16_t speed;
    int32_t bottles, rejects;
} station_t;

typedef struct { float filtered; } flow_meter_t;
typedef struct { int16_t trips; } pump_t;

static uint32_t noise = 4711;
static int32_t tick;
static station_t stations[STATIONS];
static flow_meter_t meters[STATIONS];
static pump_t pumps[STATIONS];

static float scale(int16_t raw, float low, float high)
{
    return low + (high - low) * (float)raw / 27648.0f;
}

static float filter(float old, float new, float share)
{
    return old + (new - old) * share;
}

static int16_t limit_int(int16_t value, int16_t low, int16_t high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}

static int16_t ramp(int16_t actual, int16_t target, int16_t step)
{
    return actual + limit_int(target - actual, -step, step);
}

static bool in_window(int32_t value, int32_t centre, int32_t width)
{
    return abs(value - centre) <= width;
}

static void flow_meter(flow_meter_t *m, station_t *s)
{
    m->filtered = filter(m->filtered, scale(s->raw, 0.0f, 3600.0f), 0.25f);
    s->flow = m->filtered;
}

static void pump(pump_t *p, bool run, int16_t speed, station_t *s)
{
    switch (s->pump) {
    case PUMP_STOPPED:
        s->speed = ramp(s->speed, 0, 50);
        if (run)
            s->pump = PUMP_STARTING;
        break;
    case PUMP_STARTING:
        s->speed = ramp(s->speed, 300, 40);
        if (s->speed >= 300)
            s->pump = PUMP_RUNNING;
        break;
    case PUMP_RUNNING:
        s->speed = ramp(s->speed, limit_int(speed, 200, 1000), 25);
        if (!run) {
            s->pump = PUMP_STOPPED;
        } else if (s->flow > 3400.0f) {
            s->pump = PUMP_TRIPPED;
            p->trips++;
        }
        break;
    case PUMP_TRIPPED:
        s->speed = 0;
        if (!run)
            s->pump = PUMP_STOPPED;
        break;
    }
}

static bool filler(int32_t target, station_t *s)
{
    s->volume += (int32_t)filter(0.0f, s->flow, 0.02f) * limit_int(s->speed, 0, 1000) / 1000;
    return s->volume >= target;
}

static bool weigher(bool bottle, int32_t target, station_t *s)
{
    bool good = in_window(s->volume, target + 12, 12);

    if (bottle) {
        if (good)
            s->bottles++;
        else
            s->rejects++;
        s->volume = 0;
    }
    return good;
}

void scan(void)
{
    uint32_t sum = 0;

    tick = (int32_t)((uint32_t)tick + 1u);
    for (int i = 1; i <= STATIONS; i++) {
        station_t *s = &stations[i - 1];

        noise = noise * 1664525u + 1013904223u;
        s->raw = (int16_t)(noise / 131072 % 27649);
        flow_meter(&meters[i - 1], s);
        pump(&pumps[i - 1], (tick + i) % 200 > 20, (int16_t)(150 + i * 20), s);
        bool done = filler(TARGET, s);
        weigher(done, TARGET, s);
        sum += (uint32_t)s->volume + (uint32_t)s->speed * 3u + (uint32_t)s->bottles * 7u + (uint32_t)s->rejects * 13u;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
