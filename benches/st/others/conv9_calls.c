#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

#define ZONES 50

struct analog { int32_t filt, value; };
struct monitor { bool too_low, too_high, old; uint32_t events; };
struct speed { int32_t speed; };
struct tracking { int32_t position; uint32_t pulses; };

static uint32_t seed = 99;
static struct analog analogs[ZONES];
static struct monitor monitors[ZONES];
static struct speed speeds[ZONES];
static struct tracking tracks[ZONES];

static int32_t clamp(int32_t lo, int32_t x, int32_t hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static int32_t scale(int32_t raw, int32_t raw_max, int32_t eng_min, int32_t eng_max)
{
    return eng_min + clamp(0, raw, raw_max) * (eng_max - eng_min) / raw_max;
}

static int32_t deadband(int32_t old, int32_t new, int32_t band)
{
    return abs(new - old) < band ? old : new;
}

static int32_t ramp(int32_t act, int32_t target, int32_t step)
{
    return act + clamp(-step, target - act, step);
}

static void analog_step(struct analog *a, int32_t raw, int32_t eng_max)
{
    a->filt += (scale(raw, 27648, -500, eng_max) - a->filt) / 4;
    a->value = deadband(a->value, a->filt, 3);
}

static void monitor_step(struct monitor *m, int32_t value, int32_t low, int32_t high, int32_t hyst)
{
    m->too_high = value > high || (m->too_high && value > high - hyst);
    m->too_low = value < low || (m->too_low && value < low + hyst);
    bool any = m->too_high || m->too_low;
    if (any && !m->old)
        m->events++;
    m->old = any;
}

static void speed_step(struct speed *s, bool enable, bool slow, int32_t target)
{
    int32_t wanted = enable ? target : 0;
    if (slow)
        wanted = scale(wanted, 2000, 50, 600);
    s->speed = ramp(s->speed, wanted, 15);
}

static void tracking_step(struct tracking *t, int32_t speed, int32_t pitch)
{
    t->position += clamp(0, speed, 2000);
    while (t->position >= pitch) {
        t->position -= pitch;
        t->pulses++;
    }
}

static void add(uint32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + v);
}

void scan(void)
{
    uint32_t sum_val = 0, sum_speed = 0, sum_pos = 0, events = 0, pulses = 0;
    for (int i = 0; i < ZONES; i++) {
        seed = seed * 1664525u + 1013904223u;
        int32_t raw = (int32_t)(seed >> 16) - 16000;
        analog_step(&analogs[i], raw, 1500 + 10 * (i + 1));
        monitor_step(&monitors[i], analogs[i].value, -200, 900, 60);
        speed_step(&speeds[i], !monitors[i].too_high, monitors[i].too_low,
                   800 + analogs[i].value);
        tracking_step(&tracks[i], speeds[i].speed, 1200 + 7 * (i + 1));
        sum_val += (uint32_t)analogs[i].value;
        sum_speed += (uint32_t)speeds[i].speed;
        sum_pos += (uint32_t)tracks[i].position;
        events += monitors[i].events;
        pulses += tracks[i].pulses;
    }
    add(sum_val);
    add(sum_speed);
    add(sum_pos);
    add(events);
    add(pulses);
}
