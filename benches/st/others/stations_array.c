#include <stdint.h>
#include <stdbool.h>
#include "st.h"

#define MS(x) ((int64_t)(x) * 1000)

typedef struct { bool old, q; int64_t start, et; } timer;
typedef struct { bool old, q; int16_t cv; } counter;

static void ton(timer *t, bool in, int64_t pt)
{
    if (in) {
        if (!t->old)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et > pt)
            t->et = pt;
        t->q = t->et >= pt;
    } else {
        t->et = 0;
        t->q = false;
    }
    t->old = in;
}

static void tof(timer *t, bool in, int64_t pt)
{
    if (in) {
        t->et = 0;
        t->q = true;
    } else if (t->q) {
        if (t->old)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    t->old = in;
}

static void tp(timer *t, bool in, int64_t pt)
{
    if (in && !t->old && !t->q && t->et == 0) {
        t->start = now_us;
        t->q = true;
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
    t->old = in;
}

static void ctu(counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

typedef struct {
    timer on, off, pulse;
    counter up, down;
} station;

static void station_run(station *s, bool start, int64_t delay, int16_t lot)
{
    ton(&s->on, start, delay);
    tof(&s->off, s->on.q, delay);
    tp(&s->pulse, s->off.q, MS(35));
    ctu(&s->up, s->pulse.q, s->up.q, lot);
    ctd(&s->down, s->on.q, s->down.q, lot);
}

static int32_t scans;
static station cell[100];

void scan(void)
{
    scans++;
    int32_t sum = 0;
    int64_t d = MS(15);
    for (int i = 0; i < 100; i++) {
        station *s = &cell[i];
        station_run(s, (scans + i) % 20 < 12, d, 5);
        d += MS(1);
        if (s->off.q)
            sum++;
        if (s->pulse.et > MS(20))
            sum += 3;
        sum += s->up.cv * 2 + s->down.cv;
    }
    check = (check * 7 + sum) % 100003;
}
