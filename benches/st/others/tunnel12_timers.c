/* Delays and counters of a tunnel: 60 fans, 50 doors, 30 pumps, 510 timers and
   counters in all. */
#include <stdbool.h>
#include "st.h"

#define FANS 60
#define DOORS 50
#define PUMPS 30
#define MS(x) ((uint64_t)(x) * 1000u)

/* ---- timers and counters ---- */

typedef struct {
    uint64_t start, et;
    bool in, q;
} ton_t;

typedef struct {
    uint64_t start, et;
    bool in, q;
} tof_t;

typedef struct {
    uint64_t start, et;
    bool in, running, q;
} tp_t;

typedef struct {
    int16_t cv;
    bool cu, q;
} ctu_t;

typedef struct {
    int16_t cv;
    bool cd, q;
} ctd_t;

typedef struct {
    int16_t cv;
    bool cu, cd, qu, qd;
} ctud_t;

static inline bool ton(ton_t *t, bool in, uint64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_us;
        if (!t->q) {
            t->et = now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->in = in;
    return t->q;
}

static inline bool tof(tof_t *t, bool in, uint64_t pt)
{
    if (in) {
        t->et = 0;
        t->q = true;
    } else {
        if (t->in)
            t->start = now_us;
        if (t->q) {
            t->et = now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->in = in;
    return t->q;
}

static inline bool tp(tp_t *t, bool in, uint64_t pt)
{
    if (!t->running && in && !t->in) {
        t->running = true;
        t->start = now_us;
        t->et = 0;
        t->q = true;
    }
    if (t->running) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->running = false;
        }
    }
    if (!t->running && !in)
        t->et = 0;
    t->in = in;
    return t->q;
}

static inline bool ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
    return c->q;
}

static inline bool ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
    return c->q;
}

static inline void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu;
    bool down = cd && !c->cd;

    c->cu = cu;
    c->cd = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

/* ---- devices ---- */

typedef struct {
    ton_t start_delay;
    tof_t stop_delay;
    tp_t horn_pulse;
    ctu_t starts;
    bool request;
    uint64_t delay, run_on;
} fan_t;

typedef struct {
    ton_t held;
    tof_t light_off;
    ctud_t people;
    bool open;
    uint64_t held_time;
} door_t;

typedef struct {
    ton_t dry_delay;
    tof_t after_run;
    tp_t flush_pulse;
    ctd_t starts;
    bool request, flow;
    bool run, dry, flush;
    uint64_t dry_time;
} pump_t;

static bool init_done;
static uint32_t seed = 0x1234ABCDu;
static fan_t fans[FANS];
static door_t doors[DOORS];
static pump_t pumps[PUMPS];

static inline uint32_t next_random(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x;
}

static void fan_update(fan_t *f, bool serviced)
{
    ton(&f->start_delay, f->request, f->delay);
    tof(&f->stop_delay, f->start_delay.q, f->run_on);
    tp(&f->horn_pulse, f->request && !f->stop_delay.q, MS(60));
    ctu(&f->starts, f->stop_delay.q, serviced, 25);
}

static void door_update(door_t *d, bool person_in, bool person_out, bool reset)
{
    ton(&d->held, d->open, d->held_time);
    ctud(&d->people, person_in, person_out, reset, false, 12);
    tof(&d->light_off, d->open || d->people.qu, d->held_time + MS(100));
}

static void pump_update(pump_t *p, bool reload)
{
    p->dry = ton(&p->dry_delay, p->run && !p->flow, p->dry_time);
    p->run = tof(&p->after_run, p->request && !p->dry, MS(80));
    ctd(&p->starts, p->run, reload, 40);
    tp(&p->flush_pulse, p->run && p->flow, p->dry_time);
    p->flush = p->flush_pulse.q && !p->starts.q;
}

static void init(void)
{
    for (int i = 0; i < FANS; i++) {
        fans[i].delay = MS(20) + MS(10) * ((i + 1) % 9);
        fans[i].run_on = MS(50) + MS(20) * ((i + 1) % 5);
    }
    for (int i = 0; i < DOORS; i++)
        doors[i].held_time = MS(30) + MS(10) * ((i + 1) % 12);
    for (int i = 0; i < PUMPS; i++)
        pumps[i].dry_time = MS(40) + MS(10) * ((i + 1) % 7);
}

void scan(void)
{
    uint32_t sum = 17;
    uint32_t late = 0;

    if (!init_done) {
        init();
        init_done = true;
    }

    for (int i = 0; i < FANS; i++) {
        fan_t *f = &fans[i];
        seed = next_random(seed);
        if ((seed & 0xF) == 0)
            f->request = !f->request;
        fan_update(f, (seed & 0x3FF0) == 0);
        sum = sum * 31u + (uint32_t)f->starts.cv;
        if (f->stop_delay.q) sum += 1;
        if (f->horn_pulse.q) sum += 2;
        if (f->starts.q) sum += 4;
    }

    for (int i = 0; i < DOORS; i++) {
        door_t *d = &doors[i];
        seed = next_random(seed);
        if ((seed & 0x7) == 0)
            d->open = !d->open;
        door_update(d, (seed & 0x30) == 0, (seed & 0x1C0) == 0, (seed & 0xFF000) == 0);
        sum = sum * 31u + (uint32_t)d->people.cv;
        if (d->held.q) {
            sum += 1;
            late++;
        }
        if (d->light_off.q) sum += 2;
        if (!d->people.qd) sum += 4;
        if (d->people.qu) sum += 8;
    }

    for (int i = 0; i < PUMPS; i++) {
        pump_t *p = &pumps[i];
        seed = next_random(seed);
        if ((seed & 0xF) == 0)
            p->request = !p->request;
        if ((seed & 0x70) == 0)
            p->flow = !p->flow;
        pump_update(p, (seed & 0x1FF00) == 0);
        sum = sum * 31u + (uint32_t)p->starts.cv;
        if (p->run) sum += 1;
        if (p->dry) {
            sum += 2;
            late++;
        }
        if (p->flush) sum += 4;
        if (p->starts.q) sum += 8;
    }

    check = (int32_t)(sum * 31u + late);
}
