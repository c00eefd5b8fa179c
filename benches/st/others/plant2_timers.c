#include <stdbool.h>
#include "st.h"

#define MS 1000u

typedef struct { uint64_t start, et; bool run, q; } Ton;
typedef struct { uint64_t start, et; bool run, q; } Tof;
typedef struct { uint64_t start, et; bool run, q; } Tp;
typedef struct { bool m, q; int16_t cv; } Ctu;
typedef struct { bool m, q; int16_t cv; } Ctd;
typedef struct { bool mu, md, qu, qd; int16_t cv; } Ctud;

typedef struct {
    Ton debounce, jam, cycle;
    Tof motor, lamp;
    Tp pusher;
    Ctu box, total;
    Ctd labels;
    Ctud buffer;
    bool alarm, push, mot;
    int16_t boxes;
} Station;

static Station st[50];
static int32_t nscan;

static void ton(Ton *t, bool in, uint64_t pt)
{
    if (!in) {
        t->run = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now_us;
    }
    t->et = now_us - t->start;
    t->q = t->et >= pt;
    if (t->q) t->et = pt;
}

static void tof(Tof *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->q) return;
    if (!t->run) {
        t->run = true;
        t->start = now_us;
    }
    t->et = now_us - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = false;
        t->run = false;
    }
}

/* run: a pulse was started and not yet ended with IN low */
static void tp(Tp *t, bool in, uint64_t pt)
{
    if (!t->run && in) {
        t->run = true;
        t->q = true;
        t->start = now_us;
    }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (t->run && !t->q && !in) {
        t->run = false;
        t->et = 0;
    }
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    bool e = cu && !c->m;
    c->m = cu;
    if (r) c->cv = 0;
    else if (e && c->cv < INT16_MAX) c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    bool e = cd && !c->m;
    c->m = cd;
    if (ld) c->cv = pv;
    else if (e && c->cv > INT16_MIN) c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(Ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool u = cu && !c->mu, d = cd && !c->md;
    c->mu = cu;
    c->md = cd;
    if (r) c->cv = 0;
    else if (ld) c->cv = pv;
    else if (u != d) {
        if (u && c->cv < INT16_MAX) c->cv++;
        else if (d && c->cv > INT16_MIN) c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static void station(Station *s, bool infeed, bool outfeed, bool enable, bool reset, uint64_t cycle, int16_t box)
{
    ton(&s->debounce, infeed, 30 * MS);
    ton(&s->jam, infeed && !outfeed, 200 * MS);
    ton(&s->cycle, enable && !s->cycle.q, cycle);
    tof(&s->motor, enable && !s->jam.q, 500 * MS);
    tof(&s->lamp, s->debounce.q, 1000 * MS);
    ctu(&s->box, s->debounce.q, reset || s->box.q, box);
    tp(&s->pusher, s->box.q || s->cycle.q, 120 * MS);
    ctu(&s->total, s->pusher.q, reset, 1000);
    ctd(&s->labels, s->pusher.q, reset || s->labels.q, 25);
    ctud(&s->buffer, s->debounce.q, s->pusher.q, reset, s->buffer.qu, 40);
    s->push = s->pusher.q;
    s->mot = s->motor.q && !s->buffer.qu;
    s->alarm = s->jam.q || s->labels.q || (s->lamp.q && s->lamp.et > 800 * MS);
    s->boxes = (int16_t)(s->total.cv + s->buffer.cv + s->box.cv + s->labels.cv);
}

void scan(void)
{
    uint32_t sum = 0;
    nscan++;
    for (int i = 1; i <= 50; i++) {
        Station *s = &st[i - 1];
        int32_t ph = nscan + i * 7;
        station(s, ph % 37 < 9 + i / 4, ph % 53 > 20, ph % 211 > i, ph % 997 == 5, 250 * MS, (int16_t)(3 + i / 10));
        sum = sum * 3 + (uint32_t)s->boxes;
        if (s->alarm) sum += 1;
        if (s->push) sum += 10;
        if (s->mot) sum += 100;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
