#include "st.h"
#include <stdbool.h>

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static int16_t band(int16_t v, int16_t center, int16_t width)
{
    if (v > center + width)
        return 1;
    if (v < center - width)
        return -1;
    return 0;
}

static int32_t min32(int32_t a, int32_t b) { return a < b ? a : b; }
static int32_t max32(int32_t a, int32_t b) { return a > b ? a : b; }

static int32_t ramp(int32_t act, int32_t target, int32_t step)
{
    if (act < target)
        return min32(act + step, target);
    return max32(act - step, target);
}

static uint32_t mix(uint32_t a, uint32_t v)
{
    return ((a << 5) | (a >> 27)) ^ v;
}

typedef struct { float value; int16_t band; float filt; } analog_t;
typedef struct { int32_t speed; bool reached; int32_t target; } drive_t;
typedef struct { int16_t position; bool is_open, is_closed; int32_t moves; bool cmd, old_cmd; } valve_t;
typedef struct { int32_t minimum, maximum; uint32_t hash; int16_t alarms; int32_t last; } monitor_t;

static void analog_run(analog_t *a, int16_t raw, float lo, float hi)
{
    a->filt = a->filt + 0.125f * (scale(raw, lo, hi) - a->filt);
    a->value = a->filt;
    a->band = band(raw, 13824, 5000);
}

static void drive_run(drive_t *d, bool enable, int32_t setpoint, int32_t step)
{
    if (enable)
        d->target = min32(max32(setpoint, -3000), 3000);
    else
        d->target = 0;
    d->speed = ramp(d->speed, d->target, step);
    d->reached = d->speed == d->target;
}

static void valve_run(valve_t *v, bool open, bool close, int16_t travel)
{
    v->cmd = (open || v->cmd) && !close;
    if (v->cmd != v->old_cmd)
        v->moves++;
    v->old_cmd = v->cmd;
    if (v->cmd)
        v->position = (int16_t)min32(v->position + travel, 1000);
    else
        v->position = (int16_t)max32(v->position - travel, 0);
    v->is_open = band(v->position, 500, 480) == 1;
    v->is_closed = band(v->position, 500, 480) == -1;
}

static void monitor_run(monitor_t *m, int32_t sample)
{
    int32_t d = sample - m->last;

    m->minimum = min32(m->minimum, sample);
    m->maximum = max32(m->maximum, sample);
    if ((d < 0 ? -d : d) > 500 && m->alarms < 30000)
        m->alarms++;
    m->last = sample;
    m->hash = mix(m->hash, (uint32_t)sample);
}

static bool first = true;
static uint32_t seed = 4711;
static analog_t analog[50];
static drive_t drive[50];
static valve_t valve[50];
static monitor_t mon[50];

void scan(void)
{
    int i;
    int32_t r, n = 0;

    if (first) {
        first = false;
        for (i = 0; i < 50; i++) {
            mon[i].minimum = 2147483647;
            mon[i].maximum = -2147483647;
        }
    }
    for (i = 0; i < 50; i++) {
        seed = seed * 1664525u + 1013904223u;
        r = (int32_t)(seed / 65536u) % 27648;
        analog_run(&analog[i], (int16_t)r, 0.0f, 150.0f);
        drive_run(&drive[i], analog[i].band != 1, r / 4 - 3000, 20 + i);
        valve_run(&valve[i], analog[i].band == 1, analog[i].band == -1, 15);
        monitor_run(&mon[i], drive[i].speed + valve[i].position);
        n += (int32_t)analog[i].value + valve[i].moves % 100 + mon[i].alarms;
        if (drive[i].reached)
            n += 1;
        if (valve[i].is_open)
            n += 3;
        if (valve[i].is_closed)
            n += 5;
        check = (int32_t)((uint32_t)check * 31u + mon[i].hash
                          + (uint32_t)mon[i].minimum + (uint32_t)mon[i].maximum);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
