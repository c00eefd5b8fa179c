#include "st.h"
#include <stdbool.h>

typedef struct { bool q, running; uint64_t start; } ton_t;
typedef struct { bool q, running; uint64_t start; } tof_t;
typedef struct { bool q, running, old; uint64_t start; } tp_t;
typedef struct { bool q, old; int16_t cv; } ctr_t;

static void ton(ton_t *t, bool in, uint64_t pt)
{
    if (!in) {
        t->running = false;
        t->q = false;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now_us;
    }
    t->q = now_us - t->start >= pt;
}

static void tof(tof_t *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->running = false;
    } else if (t->q) {
        if (!t->running) {
            t->running = true;
            t->start = now_us;
        }
        if (now_us - t->start >= pt)
            t->q = false;
    }
}

static void tp(tp_t *t, bool in, uint64_t pt)
{
    if (t->q) {
        if (now_us - t->start >= pt)
            t->q = false;
    } else if (in && !t->old) {
        t->q = true;
        t->start = now_us;
    }
    t->old = in;
}

static void ctu(ctr_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctr_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

typedef struct {
    bool active, alarm;
    int16_t pieces, rest;
    ton_t on_delay;
    tof_t off_delay;
    tp_t pulse;
    ctr_t parts, batch;
} station_t;

static void station(station_t *s, bool sensor, bool ack, uint64_t delay)
{
    ton(&s->on_delay, sensor, delay);
    tof(&s->off_delay, s->on_delay.q, 60000);
    tp(&s->pulse, sensor && !s->on_delay.q, 45000);
    ctu(&s->parts, sensor, ack && s->parts.q, 10);
    ctd(&s->batch, s->pulse.q, s->batch.q, 25);
    s->active = s->off_delay.q;
    s->alarm = s->parts.q || (s->pulse.q && s->off_delay.q);
    s->pieces = s->parts.cv;
    s->rest = s->batch.cv;
}

static station_t stations[100];
static uint64_t delays[100];
static bool sensors[100];
static bool init_done;
static int32_t scans;

void scan(void)
{
    scans++;
    if (!init_done) {
        for (int i = 1; i <= 100; i++)
            delays[i - 1] = 10000 * (i % 9 + 1);
        init_done = true;
    }
    bool ack = scans % 32 < 3;
    for (int i = 1; i <= 100; i++) {
        sensors[i - 1] = (scans + i * 7) % 23 < 14;
        station(&stations[i - 1], sensors[i - 1], ack, delays[i - 1]);
    }
    int32_t n = 0;
    for (int i = 1; i <= 100; i++) {
        station_t *s = &stations[i - 1];
        if (s->active)
            n++;
        if (s->alarm)
            n += i;
        n += s->pieces + s->rest * 2;
    }
    check += n;
}
