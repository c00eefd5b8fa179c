/* 200 function block calls: 80 analog inputs, 60 motors, 40 valves, 20 totalizers */
#include <stdbool.h>
#include "st.h"

static int32_t clamp_d(int32_t lo, int32_t x, int32_t hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static int32_t scale_d(int16_t raw, int32_t out_lo, int32_t out_hi)
{
    return out_lo + (int32_t)raw * (out_hi - out_lo) / 27648;
}

static int32_t deadband(int32_t old, int32_t new, int32_t band)
{
    int32_t d = new - old;
    if (d < 0)
        d = -d;
    return d > band ? new : old;
}

static bool between(int32_t x, int32_t lo, int32_t hi)
{
    return x >= lo && x <= hi;
}

typedef struct {
    int16_t raw;
    int32_t lo, hi;
    int32_t value;
    bool alarm_hi, alarm_lo, ok;
    int32_t filt;
} AnalogIn;

static void analog_run(AnalogIn *a, int16_t raw, int32_t lo, int32_t hi)
{
    int32_t x;

    a->raw = raw;
    a->lo = lo;
    a->hi = hi;
    x = clamp_d(lo, scale_d(raw, lo, hi), hi);
    a->filt = a->filt + (x - a->filt) / 4;
    a->value = deadband(a->value, a->filt, 5);
    a->alarm_hi = a->value > hi - (hi - lo) / 10;
    a->alarm_lo = a->value < lo + (hi - lo) / 10;
    a->ok = between(raw, 0, 27648);
}

typedef struct {
    bool start, stop, trip;
    int32_t target;
    bool run, fault;
    int32_t speed;
    int16_t starts;
    bool start_old;
} Motor;

static void motor_run(Motor *m, bool start, bool stop, bool trip, int32_t target)
{
    m->start = start;
    m->stop = stop;
    m->trip = trip;
    m->target = target;
    if (trip)
        m->fault = true;
    else if (stop)
        m->fault = false;
    if (start && !m->start_old && !m->fault && !stop) {
        m->run = true;
        m->starts++;
    }
    m->start_old = start;
    if (stop || m->fault)
        m->run = false;
    if (m->run)
        m->speed += clamp_d(-20, target - m->speed, 20);
    else
        m->speed += clamp_d(-50, 0 - m->speed, 50);
}

typedef struct {
    bool open;
    int16_t travel;
    int16_t state;      /* 0 closed, 1 opening, 2 open, 3 closing */
    int16_t moves;
    int16_t pos;
} Valve;

static void valve_run(Valve *v, bool open, int16_t travel)
{
    v->open = open;
    v->travel = travel;
    switch (v->state) {
    case 0:
        if (open) {
            v->state = 1;
            v->moves++;
        }
        break;
    case 1:
        v->pos++;
        if (!open)
            v->state = 3;
        else if (v->pos >= travel)
            v->state = 2;
        break;
    case 2:
        if (!open)
            v->state = 3;
        break;
    case 3:
        v->pos--;
        if (open) {
            v->state = 1;
        } else if (v->pos <= 0) {
            v->pos = 0;
            v->state = 0;
        }
        break;
    }
}

typedef struct {
    int32_t flow;
    bool reset;
    int32_t total;
    int32_t rest;
} Totalizer;

static void totalizer_run(Totalizer *t, int32_t flow, bool reset)
{
    t->flow = flow;
    t->reset = reset;
    if (reset) {
        t->total = 0;
        t->rest = 0;
    } else {
        t->rest += flow;
        t->total += t->rest / 100;
        t->rest %= 100;
    }
}

static uint32_t scans;
static AnalogIn analog[80];
static Motor motors[60];
static Valve valves[40];
static Totalizer totals[20];

void scan(void)
{
    int32_t i, s;
    uint32_t acc = 0;

    scans++;
    s = (int32_t)scans;

    for (i = 0; i < 80; i++) {
        int16_t raw = (int16_t)((int32_t)(scans * 13u + (uint32_t)i * 331u) % 28000);
        analog_run(&analog[i], raw, 0, 1000 + i * 10);
        if (analog[i].alarm_hi || analog[i].alarm_lo)
            acc += 1;
        if (!analog[i].ok)
            acc += 100;
    }

    for (i = 0; i < 60; i++) {
        motor_run(&motors[i], (s + i) % 64 < 8, (s + i * 5) % 300 == 0,
                  (s + i * 7) % 500 == 0, analog[i].value);
        acc += (uint32_t)(motors[i].speed + motors[i].starts);
    }

    for (i = 0; i < 40; i++) {
        valve_run(&valves[i], motors[i].run, (int16_t)(10 + i));
        acc += (uint32_t)(valves[i].state * 3 + valves[i].moves);
    }

    for (i = 0; i < 20; i++) {
        totalizer_run(&totals[i], motors[i + 20].speed, (s + i) % 1000 == 0);
        acc += (uint32_t)(totals[i].total + totals[i].rest);
    }

    check = (int32_t)((uint32_t)check * 31u + acc);
}
