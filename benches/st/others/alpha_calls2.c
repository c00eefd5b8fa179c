/* Batch dosing: 6 stations in a chain, each with 4 dosing lines and a mixer */
#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t setpoint, actual, preact;
    int16_t tolerance, doses, faults;
} DoseRecord;

typedef struct { bool q; int16_t count; } Debounce;

static void debounce(Debounce *d, bool in, int16_t n)
{
    if (in == d->q) {
        d->count = 0;
    } else {
        d->count++;
        if (d->count >= n) {
            d->q = in;
            d->count = 0;
        }
    }
}

static int32_t absi(int32_t x) { return x < 0 ? -x : x; }
static int16_t min16(int16_t a, int16_t b) { return a < b ? a : b; }
static int16_t max16(int16_t a, int16_t b) { return a > b ? a : b; }

typedef struct { int32_t net; bool stable; int32_t tare, last; int16_t quiet; } Scale;

static void scale(Scale *s, int32_t gross, bool tare_now)
{
    if (absi(gross - s->last) <= 3) {
        if (s->quiet < 100) s->quiet++;
    } else {
        s->quiet = 0;
    }
    s->last = gross;
    s->stable = s->quiet >= 4;
    if (tare_now) s->tare = gross;
    s->net = gross - s->tare;
}

typedef struct { int16_t speed; int32_t flow; } Feeder;

static void feeder(Feeder *f, bool run, bool coarse, int16_t ramp)
{
    int16_t target;
    if (!run)
        target = 0;
    else if (coarse)
        target = 1000;
    else
        target = 150;
    if (f->speed < target)
        f->speed = min16(f->speed + ramp, target);
    else if (f->speed > target)
        f->speed = max16(f->speed - 2 * ramp, target);
    f->flow = (int32_t)f->speed * 3 / 20;
}

static bool in_tolerance(int32_t sp, int32_t act, int16_t permille)
{
    return absi(act - sp) * 1000 <= sp * permille;
}

static int32_t next_preact(int32_t old, int32_t overshoot)
{
    int32_t p = old + overshoot / 4;
    if (p < 0)
        p = 0;
    else if (p > 400)
        p = 400;
    return p;
}

typedef struct {
    bool busy, done;
    int16_t state;
    Debounce start_db, done_db;
    Scale cell;
    Feeder screw;
    int32_t hopper;
} DosingLine;

static void dosing_line(DosingLine *l, bool start, bool reset, DoseRecord *rec)
{
    int32_t remain;
    debounce(&l->start_db, start, 2);
    scale(&l->cell, l->hopper, l->state == 1);
    remain = rec->setpoint - rec->preact - l->cell.net;
    feeder(&l->screw, l->state == 2 || l->state == 3, l->state == 2, 120);
    l->hopper += l->screw.flow;
    switch (l->state) {
    case 0: if (l->start_db.q) l->state = 1; break;
    case 1: l->state = 2; break;
    case 2: if (remain < 600) l->state = 3; break;
    case 3: if (remain <= 0) l->state = 4; break;
    case 4:
        if (l->cell.stable) {
            rec->actual = l->cell.net;
            rec->doses = (rec->doses + 1) % 10000;
            if (!in_tolerance(rec->setpoint, l->cell.net, rec->tolerance))
                rec->faults = (rec->faults + 1) % 1000;
            rec->preact = next_preact(rec->preact, l->cell.net - rec->setpoint);
            l->state = 5;
        }
        break;
    case 5:
        if (reset) {
            l->hopper = 0;
            l->state = 0;
        }
        break;
    }
    l->busy = l->state > 0 && l->state < 5;
    debounce(&l->done_db, l->state == 5, 2);
    l->done = l->done_db.q;
}

typedef struct { bool running, finished; int32_t batches; int16_t t; } Mixer;

static void mixer(Mixer *m, bool go, int16_t time)
{
    m->finished = false;
    if (go && !m->running) {
        m->running = true;
        m->t = 0;
    }
    if (m->running) {
        m->t++;
        if (m->t >= time) {
            m->running = false;
            m->finished = true;
            m->batches++;
        }
    }
}

typedef struct {
    bool ready;
    int32_t total, batches;
    DosingLine cement, sand, gravel, water;
    DoseRecord rec_cement, rec_sand, rec_gravel, rec_water;
    Mixer drum;
    Debounce db;
    bool dump;
} Station;

static void station(Station *s, bool enable, int16_t mix_time)
{
    dosing_line(&s->cement, enable && !s->drum.running, s->dump, &s->rec_cement);
    dosing_line(&s->sand, s->cement.busy || s->cement.done, s->dump, &s->rec_sand);
    dosing_line(&s->gravel, s->sand.done, s->dump, &s->rec_gravel);
    dosing_line(&s->water, enable && s->sand.busy, s->dump, &s->rec_water);
    debounce(&s->db, s->cement.done && s->sand.done && s->gravel.done && s->water.done, 3);
    mixer(&s->drum, s->db.q, mix_time);
    s->dump = s->drum.finished;
    s->ready = s->db.q || s->drum.running;
    s->total = s->rec_cement.actual + s->rec_sand.actual + s->rec_gravel.actual + s->rec_water.actual;
    s->batches = s->drum.batches;
}

#define STATION_INIT { \
    .rec_cement = { .setpoint = 3200, .preact = 60, .tolerance = 15 }, \
    .rec_sand = { .setpoint = 7400, .preact = 100, .tolerance = 10 }, \
    .rec_gravel = { .setpoint = 9100, .preact = 120, .tolerance = 12 }, \
    .rec_water = { .setpoint = 1900, .preact = 20, .tolerance = 20 } }

static int32_t cycle;
static Station st1 = STATION_INIT, st2 = STATION_INIT, st3 = STATION_INIT;
static Station st4 = STATION_INIT, st5 = STATION_INIT, st6 = STATION_INIT;

void scan(void)
{
    cycle++;
    station(&st1, cycle % 400 < 350, 40);
    station(&st2, st1.ready || cycle % 7 > 1, 35);
    station(&st3, !st2.ready, 50);
    station(&st4, st3.ready || st1.ready || cycle % 300 > 100, 20);
    station(&st5, !st4.ready || st2.ready, 60);
    station(&st6, true, 30);
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)(st1.total + st2.total + st3.total));
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)(st4.total + st5.total + st6.total));
    check = (int32_t)((uint32_t)check + (uint32_t)(st1.batches + st2.batches * 3 + st3.batches * 5 + st4.batches * 7 + st5.batches * 11 + st6.batches * 13));
}
