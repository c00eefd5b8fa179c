/* 50 stations with ten timers and counters each */
#include <stdbool.h>
#include "st.h"

#define STATIONS 50
#define MS 1000u

typedef struct { bool q, running; uint64_t start, et; } ton_t;
typedef struct { bool q, running; uint64_t start, et; } tof_t;
typedef struct { bool q, in_prev; uint64_t start, et; } tp_t;
typedef struct { bool q, cu_prev; int16_t cv; } ctu_t;
typedef struct { bool q, cd_prev; int16_t cv; } ctd_t;
typedef struct { bool qu, qd, cu_prev, cd_prev; int16_t cv; } ctud_t;

static inline bool ton(ton_t *t, bool in, uint64_t pt)
{
    if (!in) {
        t->running = t->q = false;
        t->et = 0;
    } else if (!t->running && !t->q) {
        t->running = true;
        t->start = now_us;
        t->et = 0;
        if (pt == 0) {
            t->running = false;
            t->q = true;
        }
    } else if (!t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
            t->running = false;
        }
    }
    return t->q;
}

static inline bool tof(tof_t *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->running = false;
        t->et = 0;
    } else if (t->q) {
        if (!t->running) {
            t->running = true;
            t->start = now_us;
        }
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = t->running = false;
        }
    }
    return t->q;
}

static inline bool tp(tp_t *t, bool in, uint64_t pt)
{
    if (!t->q && in && !t->in_prev) {
        t->q = true;
        t->start = now_us;
        t->et = 0;
    }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in)
        t->et = 0;
    t->in_prev = in;
    return t->q;
}

static inline bool ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu_prev && c->cv < INT16_MAX)
        c->cv++;
    c->cu_prev = cu;
    return c->q = c->cv >= pv;
}

static inline bool ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd_prev && c->cv > INT16_MIN)
        c->cv--;
    c->cd_prev = cd;
    return c->q = c->cv <= 0;
}

static inline void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu_prev;
    bool down = cd && !c->cd_prev;
    c->cu_prev = cu;
    c->cd_prev = cd;
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

typedef struct {
    /* inputs */
    bool enable, sensor, take, reset;
    uint64_t start_delay;
    int16_t pack_size;
    /* simulation */
    int16_t phase, period, on, slow;
    /* timers and counters */
    ton_t start, jam, starve;
    tof_t run, lamp;
    tp_t eject, horn;
    ctu_t pieces;
    ctd_t batch;
    ctud_t buffer;
    bool jam_warn;
} station_t;

static station_t station[STATIONS];
static bool initialised;
static int scan_no;

static void station_update(station_t *s)
{
    ton(&s->start, s->enable, s->start_delay);
    bool run = tof(&s->run, s->start.q && !s->buffer.qu, 300 * MS);
    ton(&s->jam, run && s->sensor, 150 * MS);
    ton(&s->starve, run && !s->sensor, 200 * MS);
    s->jam_warn = s->jam.et > 100 * MS;
    tof(&s->lamp, s->jam.q || s->starve.q, 500 * MS);

    ctu(&s->pieces, run && s->sensor, s->reset || s->pieces.q, s->pack_size);
    bool eject = tp(&s->eject, s->pieces.q, 80 * MS);
    ctd(&s->batch, eject, s->reset || s->batch.q, 10);
    ctud(&s->buffer, eject, s->take, s->reset, false, 4);
    tp(&s->horn, s->buffer.qu, 1000 * MS);
}

static void init(void)
{
    static const uint64_t delay[3] = {120 * MS, 400 * MS, 50 * MS};
    for (int i = 1; i <= STATIONS; i++) {
        station_t *s = &station[i - 1];
        s->period = 8 + (i * 7) % 37;
        s->on = 3 + (i * 5) % 19;
        s->slow = i * 37;
        s->pack_size = 3 + i % 4;
        s->start_delay = delay[i % 3];
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        init();
    }
    if (++scan_no >= 3000)
        scan_no = 0;

    uint32_t sum = 0;
    for (int i = 1; i <= STATIONS; i++) {
        station_t *s = &station[i - 1];
        if (++s->phase >= s->period)
            s->phase = 0;
        if (++s->slow >= 1900)
            s->slow = 0;
        s->sensor = s->phase < s->on;
        s->take = s->phase == 5 && s->slow > 400;
        s->enable = s->slow < 1500;
        s->reset = scan_no == i * 60 - 1;

        station_update(s);

        uint32_t w = (uint32_t)(s->pieces.cv + s->batch.cv * 8 + s->buffer.cv * 128);
        w += (uint32_t)s->run.q << 10;
        w += (uint32_t)s->jam.q << 11;
        w += (uint32_t)s->jam_warn << 12;
        w += (uint32_t)s->starve.q << 13;
        w += (uint32_t)s->lamp.q << 14;
        w += (uint32_t)s->eject.q << 15;
        w += (uint32_t)s->horn.q << 16;
        w += (uint32_t)s->batch.q << 17;
        sum = sum * 3 + w;
    }
    check = (int32_t)((uint32_t)check * 31 + sum);
}
