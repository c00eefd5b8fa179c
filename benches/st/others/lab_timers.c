/* 100 stations with on delay, off delay, pulse, part counter and batch counter: 500 blocks */
#include <stdbool.h>
#include "st.h"

#define STATIONS 100

typedef struct { bool in, q; int32_t pt, et; uint32_t start; bool run; } ton_t;
typedef struct { bool in, q; int32_t pt, et; uint32_t start; bool run; } tof_t;
typedef struct { bool in, q; int32_t pt, et; uint32_t start; bool run, done; } tp_t;
typedef struct { bool cu, r; int16_t pv; bool q; int16_t cv; bool old; } ctu_t;
typedef struct { bool cd, ld; int16_t pv; bool q; int16_t cv; bool old; } ctd_t;

static uint32_t now_ms;

static void ton(ton_t *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->run = false;
        t->et = 0;
    } else if (!t->q) {
        int32_t el;
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt)
{
    t->pt = pt;
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
    } else if (t->q) {
        int32_t el;
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
    t->in = in;
}

static void tp(tp_t *t, bool in, int32_t pt)
{
    t->pt = pt;
    if (!t->run && !t->done && in && !t->in) {
        t->run = true;
        t->start = now_ms;
        t->q = true;
    }
    if (t->run) {
        int32_t el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->run = false;
            t->done = true;
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
    if (t->done && !in) {
        t->done = false;
        t->et = 0;
    }
    t->in = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    c->cu = cu;
    c->r = r;
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    c->cd = cd;
    c->ld = ld;
    c->pv = pv;
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static uint32_t rnd = 4711;
static bool sensor[STATIONS];
static int32_t pt_on[STATIONS], pt_off[STATIONS], pt_pulse[STATIONS];
static ton_t on_delay[STATIONS];
static tof_t off_delay[STATIONS];
static tp_t pulse[STATIONS];
static ctu_t parts[STATIONS];
static ctd_t batch[STATIONS];

void scan(void)
{
    int i;
    int32_t sum;

    now_ms = (uint32_t)(now_us / 1000);

    if (first) {
        first = false;
        for (i = 0; i < STATIONS; i++) {
            pt_on[i] = 3 + i % 17;
            pt_off[i] = 10 + (i % 23) * 2;
            pt_pulse[i] = 2 + i % 11;
        }
    }

    for (i = 0; i < STATIONS; i++) {
        rnd = rnd * 1664525u + 1013904223u;
        if ((rnd / 65536) % 16 == 0)
            sensor[i] = !sensor[i];
    }

    sum = 0;
    for (i = 0; i < STATIONS; i++) {
        ton(&on_delay[i], sensor[i], pt_on[i]);
        tof(&off_delay[i], on_delay[i].q, pt_off[i]);
        tp(&pulse[i], off_delay[i].q, pt_pulse[i]);
        ctu(&parts[i], pulse[i].q, parts[i].q, 5);
        ctd(&batch[i], sensor[i], batch[i].q, 8);

        sum += on_delay[i].et + off_delay[i].et * 3 + pulse[i].et * 5;
        sum += parts[i].cv * 7 + batch[i].cv * 11;
        if (pulse[i].q)
            sum += 1000;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
