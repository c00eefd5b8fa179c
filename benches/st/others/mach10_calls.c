#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

#define AXES 50

typedef struct { int32_t speed; bool atSpeed; } Ramp;
typedef struct { int32_t acc, value; } Filter;
typedef struct { bool trip, warn; int outside; } Monitor;
typedef struct { bool state; int n; } Debounce;

typedef struct { Ramp ramp; Filter filter; Monitor monitor; Debounce endSwitch; } Axis;

static Axis axes[AXES];
static uint32_t seed = 12345;
static int32_t scanNo;

static int32_t clamp(int32_t v, int32_t lo, int32_t hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static int32_t scale(int32_t v, int32_t num, int32_t den)
{
    return den == 0 ? 0 : v * num / den;
}

static bool in_window(int32_t v, int32_t center, int32_t half)
{
    return abs(v - center) <= half;
}

static int count_to(int current, bool enable, int target)
{
    if (!enable) return 0;
    return current < target ? current + 1 : target;
}

static void ramp_step(Ramp *r, int32_t target, int32_t slope)
{
    r->speed += clamp(target - r->speed, -slope, slope);
    r->atSpeed = in_window(r->speed, target, 2);
}

static void filter_step(Filter *f, int32_t raw, int32_t weight)
{
    f->acc += scale(raw * 16 - f->acc, weight, 64);
    f->value = clamp(f->acc / 16, -30000, 30000);
}

static void monitor_step(Monitor *m, int32_t set, int32_t act, int32_t tol, bool reset)
{
    m->warn = !in_window(act, set, tol);
    m->outside = count_to(m->outside, m->warn, 12);
    if (m->outside >= 12) m->trip = true;
    else if (reset) m->trip = false;
}

static void debounce_step(Debounce *d, bool signal, int scans)
{
    d->n = count_to(d->n, signal != d->state, scans);
    if (d->n >= scans) {
        d->state = signal;
        d->n = 0;
    }
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    if (++scanNo >= 600) scanNo = 0;
    int32_t line = scanNo > 200 && scanNo < 450 ? 2400 : 1000;

    int32_t sum = 0, trips = 0;
    for (int i = 0; i < AXES; i++) {
        Axis *a = &axes[i];
        int n = i + 1;
        seed = seed * 1103515245u + 12345u;
        int32_t noise = (int32_t)(seed >> 16) % 128 - 64;
        int32_t target = scale(line, 100 + n, 100);
        if (a->endSwitch.state || a->monitor.trip) target = 0;
        ramp_step(&a->ramp, target, 10 + n % 8);
        filter_step(&a->filter, a->ramp.speed + noise, 9);
        monitor_step(&a->monitor, a->ramp.speed, a->filter.value, 110, scanNo == 0);
        debounce_step(&a->endSwitch, noise > 20, 3);
        sum += a->filter.value;
        if (a->ramp.atSpeed) sum += 5;
        if (a->monitor.trip) trips++;
    }
    add(sum);
    add(trips);
}
