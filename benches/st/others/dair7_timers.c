#include "st.h"
#include <stdbool.h>

#define MS(x) ((uint64_t)(x) * 1000)

struct timer { uint64_t start, et; bool in, run, q; };
struct counter { int16_t cv; bool cu, cd, qu, qd; };

static void ton(struct timer *t, bool in, uint64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt)
            t->et = pt;
        t->q = t->et >= pt;
    }
    t->in = in;
}

static void tof(struct timer *t, bool in, uint64_t pt)
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
}

static void tp(struct timer *t, bool in, uint64_t pt)
{
    if (!t->run && in && !t->in) {
        t->run = true;
        t->start = now_us;
    }
    if (t->run) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->run = false;
        }
    }
    t->q = t->run;
    if (!t->run && !in)
        t->et = 0;
    t->in = in;
}

static void ctu(struct counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->qu = c->cv >= pv;
}

static void ctd(struct counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->qd = c->cv <= 0;
}

static void ctud(struct counter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->cu = cu;
    c->cd = cd;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

struct valve { struct timer open, close, hold; struct counter strokes; };
struct head { struct timer fill, drip; struct counter bottles, crate, buffer; };
struct pump { struct timer run, dry; struct counter starts; };

static struct valve valves[60];
static struct head heads[40];
static struct pump pumps[20];
static const uint64_t fill_time[4] = { MS(10), MS(18), MS(30), MS(55) };
static int32_t scans;

void scan(void)
{
    int32_t sum = 0;
    scans++;

    for (int i = 0; i < 60; i++) {
        struct valve *v = &valves[i];
        int32_t phase = (scans + i * 7) % 97;
        bool cmd = phase < 48, fbk = phase > i % 30 && phase < 60 + i % 20;
        ton(&v->open, cmd && !fbk, MS(40));
        ton(&v->close, !cmd && fbk, MS(60));
        tof(&v->hold, cmd && fbk, MS(25));
        ctu(&v->strokes, v->hold.q, scans % 4001 == 0, 20);
        if (v->open.q) sum += 1;
        if (v->close.q) sum += 3;
        if (v->hold.q) sum += 5;
        if (v->strokes.qu) sum += 7;
        sum += v->strokes.cv;
    }

    for (int i = 0; i < 40; i++) {
        struct head *h = &heads[i];
        int32_t phase = (scans + i * 3) % 73;
        bool bottle = phase < 60, taken = phase % 36 == 5, crate = (scans + i) % 1501 == 0;
        tp(&h->fill, bottle, fill_time[i % 4]);
        ton(&h->drip, bottle && !h->fill.q, MS(12));
        ctu(&h->bottles, h->drip.q, false, 1000);
        ctd(&h->crate, h->drip.q, crate, 20);
        ctud(&h->buffer, h->drip.q, taken, false, crate, 8);
        if (h->fill.q) sum += 11;
        if (h->drip.q) sum += 13;
        if (h->fill.et > MS(15)) sum += 17;
        if (h->crate.qd || h->buffer.qu) sum += 19;
        sum += h->bottles.cv + h->crate.cv * 2 + h->buffer.cv * 3;
    }

    for (int i = 0; i < 20; i++) {
        struct pump *p = &pumps[i];
        int32_t phase = (scans + i * 11) % 301;
        bool flow = phase > 30 && phase < 100 + i * 8;
        tof(&p->run, phase < 120, MS(100));
        ton(&p->dry, p->run.q && !flow, MS(80));
        ctud(&p->starts, p->run.q, p->dry.q, scans % 3001 == 0, false, 50);
        if (p->run.q && !p->dry.q) sum += 23;
        if (p->dry.q) sum += 29;
        sum += p->starts.cv;
    }

    check = (int32_t)((uint32_t)check * 17u + (uint32_t)sum);
}
