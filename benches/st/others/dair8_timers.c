/* Supervision timers and counters of valves, tanks and motors: 500 in all */
#include <stdbool.h>
#include "st.h"

#define VALVES 32
#define TANKS 40
#define MOTORS 50
#define MS(x) ((uint64_t)(x) * 1000)

typedef struct { uint64_t start, et; bool running, q; } ton_t;
typedef struct { uint64_t start; bool prev, timing, q; } tof_t;
typedef struct { uint64_t start; bool prev, q; } tp_t;
typedef struct { int16_t cv; bool prev, q; } ctu_t;
typedef struct { int16_t cv; bool prev, q; } ctd_t;
typedef struct { int16_t cv; bool prev_up, prev_down, qu, qd; } ctud_t;

static bool ton(ton_t *t, bool in, uint64_t pt)
{
    if (!in) {
        t->running = t->q = false;
        t->et = 0;
    } else {
        if (!t->running) {
            t->running = true;
            t->start = now_us;
        }
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
    return t->q;
}

static bool tof(tof_t *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->timing = false;
    } else {
        if (t->prev) {
            t->timing = true;
            t->start = now_us;
        }
        if (t->timing && now_us - t->start >= pt)
            t->q = t->timing = false;
    }
    t->prev = in;
    return t->q;
}

static bool tp(tp_t *t, bool in, uint64_t pt)
{
    if (t->q) {
        if (now_us - t->start >= pt)
            t->q = false;
    } else if (in && !t->prev) {
        t->q = pt > 0;
        t->start = now_us;
    }
    t->prev = in;
    return t->q;
}

static bool ctu(ctu_t *c, bool cu, bool reset, int16_t pv)
{
    if (reset)
        c->cv = 0;
    else if (cu && !c->prev && c->cv < INT16_MAX)
        c->cv++;
    c->prev = cu;
    c->q = c->cv >= pv;
    return c->q;
}

static bool ctd(ctd_t *c, bool cd, bool load, int16_t pv)
{
    if (load)
        c->cv = pv;
    else if (cd && !c->prev && c->cv > INT16_MIN)
        c->cv--;
    c->prev = cd;
    c->q = c->cv <= 0;
    return c->q;
}

static void ctud(ctud_t *c, bool cu, bool cd, bool reset, bool load, int16_t pv)
{
    bool up = cu && !c->prev_up;
    bool down = cd && !c->prev_down;

    c->prev_up = cu;
    c->prev_down = cd;
    if (reset)
        c->cv = 0;
    else if (load)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

typedef struct {
    bool cmd, fb_open, fault, blink, worn;
    ton_t open, close;
    tp_t blinker;
    tof_t hold;
    ctu_t moves;
} valve_t;

typedef struct {
    bool inflow, outflow, stir, dose, overrun, full, empty;
    ton_t ton_stir;
    tof_t tof_stir;
    tp_t tp_dose;
    ctud_t fill;
    ctd_t doses;
    ctu_t batch;
} tank_t;

typedef struct {
    bool run;
    ton_t delay;
    ctu_t starts;
} motor_t;

static uint32_t noise = 777;
static valve_t valves[VALVES];
static tank_t tanks[TANKS];
static motor_t motors[MOTORS];

static uint32_t next_bits(void)
{
    noise = noise * 1664525u + 1013904223u;
    return noise >> 24;
}

static void valve_monitor(valve_t *v, uint64_t open_time, int16_t service)
{
    ton(&v->open, v->cmd && !v->fb_open, open_time);
    ton(&v->close, !v->cmd && v->fb_open, open_time + MS(10));
    v->fault = tof(&v->hold, v->open.q || v->close.q, MS(100));
    v->blink = tp(&v->blinker, v->fault, MS(30));
    v->worn = ctu(&v->moves, v->cmd, v->worn, service);
}

static void tank_monitor(tank_t *t, uint64_t stir_time, int16_t batch_size)
{
    ctud(&t->fill, t->inflow, t->outflow, false, false, batch_size);
    t->full = t->fill.qu;
    t->empty = t->fill.qd;
    ton(&t->ton_stir, !t->empty, stir_time);
    t->stir = tof(&t->tof_stir, t->ton_stir.q && t->inflow, MS(60));
    t->dose = tp(&t->tp_dose, t->stir, stir_time / 2);
    t->overrun = ctd(&t->doses, t->dose, t->batch.q, batch_size);
    ctu(&t->batch, t->full, t->batch.q, batch_size);
}

void scan(void)
{
    int32_t faults = 0, levels = 0, late = 0;

    for (int i = 0; i < VALVES; i++) {
        valve_t *v = &valves[i];
        uint32_t bits = next_bits();

        if (bits < 24)
            v->cmd = !v->cmd;
        if (bits > 200)
            v->fb_open = v->cmd;
        valve_monitor(v, MS(40), 10 + i);
        if (v->fault)
            faults += 1;
        if (v->blink)
            faults += 100;
        if (v->worn)
            faults += 10000;
    }

    for (int i = 0; i < TANKS; i++) {
        tank_t *t = &tanks[i];
        uint32_t bits = next_bits();

        t->inflow = bits < 130;
        t->outflow = bits % 4 == 1;
        tank_monitor(t, MS(80), 5 + i % 8);
        levels += t->fill.cv + 7 * t->batch.cv;
        if (t->stir)
            levels += 3;
        if (t->dose && !t->overrun)
            levels += 5;
    }

    for (int i = 0; i < MOTORS; i++) {
        motor_t *m = &motors[i];

        if (next_bits() < 16)
            m->run = !m->run;
        ton(&m->delay, m->run, MS(50));
        ctu(&m->starts, m->delay.q, m->starts.q, 9);
        late += m->starts.cv;
        if (m->delay.et > MS(25))
            late += 11;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)faults + (uint32_t)levels * 17u + (uint32_t)late * 257u);
}
