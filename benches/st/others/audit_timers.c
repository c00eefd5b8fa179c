/* 500 timers and counters */
#include <stdbool.h>
#include "st.h"

typedef struct { bool in, q, running; int32_t pt, et; uint32_t start; } Ton;
typedef struct { bool in, q, running; int32_t pt, et; uint32_t start; } Tof;
typedef struct { bool in, q; uint8_t state; int32_t pt, et; uint32_t start; } Tp;
typedef struct { bool cu, r, q, old; int16_t pv, cv; } Ctu;
typedef struct { bool cd, ld, q, old; int16_t pv, cv; } Ctd;

static uint32_t now_ms;

static void ton(Ton *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
    } else {
        if (!t->running) {
            t->running = true;
            t->start = now_ms;
        }
        if (!t->q) {
            int32_t el = (int32_t)(now_ms - t->start);
            if (el >= pt) {
                t->q = true;
                t->et = pt;
            } else {
                t->et = el;
            }
        }
    }
}

static void tof(Tof *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (in) {
        t->q = true;
        t->et = 0;
        t->running = false;
    } else if (t->q) {
        int32_t el;
        if (!t->running) {
            t->running = true;
            t->start = now_ms;
        }
        el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->q = false;
            t->running = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now_ms;
        t->q = true;
    }
    if (t->state == 1) {
        int32_t el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->state = 2;
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
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

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
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

static bool started;
static int32_t scans;
static Ton on_delay[150];
static Tof off_delay[100];
static Tp pulse[100];
static Ctu up[100];
static Ctd down[50];
static int32_t on_time[150], off_time[100], pulse_time[100];
static int16_t preset[100];

void scan(void)
{
    int i;
    int32_t acc = 0;

    now_ms = (uint32_t)(now_us / 1000);
    if (!started) {
        started = true;
        for (i = 0; i < 150; i++)
            on_time[i] = 10 + i * 7;
        for (i = 0; i < 100; i++) {
            off_time[i] = 20 + i * 5;
            pulse_time[i] = 15 + i * 3;
            preset[i] = (int16_t)(3 + i % 20);
        }
    }

    scans++;

    /* machine inputs: each timer follows a slow square wave of its own */
    for (i = 0; i < 150; i++) {
        bool x = (scans + i * 3) % 200 < 150;
        ton(&on_delay[i], x, on_time[i]);
        if (on_delay[i].q)
            acc += 1;
    }

    for (i = 0; i < 100; i++) {
        tof(&off_delay[i], on_delay[i].q, off_time[i]);
        if (off_delay[i].q)
            acc += 3;
        tp(&pulse[i], on_delay[i + 50].q, pulse_time[i]);
        if (pulse[i].q)
            acc += 5;
    }

    for (i = 0; i < 100; i++) {
        ctu(&up[i], pulse[i].q, up[i].q, preset[i]);
        acc += up[i].cv;
    }

    for (i = 0; i < 50; i++) {
        ctd(&down[i], off_delay[i].q, down[i].q, preset[i + 50]);
        acc += down[i].cv * 2;
    }

    acc += on_delay[7].et + off_delay[8].et + pulse[9].et;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)acc);
}
