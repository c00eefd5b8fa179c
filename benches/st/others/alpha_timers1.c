/* Sequenced spray and rapper system: 100 stations with five timers/counters each */
#include <stdbool.h>
#include "st.h"

typedef struct { uint32_t start; int32_t et; bool run, q; } Ton;
typedef struct { uint32_t start; int32_t et; bool run, q; } Tof;
typedef struct { uint32_t start; int32_t et; uint8_t state; bool q; } Tp;
typedef struct { int16_t cv; bool q, old; } Ctu;
typedef struct { int16_t cv; bool q, old; } Ctd;

static uint32_t now_ms;

static void ton(Ton *t, bool in, int32_t pt)
{
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

static void tof(Tof *t, bool in, int32_t pt)
{
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
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->q = true;
        t->start = now_ms;
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
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static int32_t cycle;
static Ton delay[100];
static Tp pulse[100];
static Tof purge[100];
static Ctu shots[100];
static Ctd service[100];

void scan(void)
{
    int32_t active = 0;
    now_ms = (uint32_t)(now_us / 1000);
    cycle++;
    for (int i = 0; i < 100; i++) {
        int n = i + 1;
        bool call = (cycle + n * 7) % 60 < 25 + n % 9;
        ton(&delay[i], call, 40 + 5 * (n % 11));
        tp(&pulse[i], delay[i].q, 25);
        tof(&purge[i], pulse[i].q, 120);
        ctu(&shots[i], pulse[i].q, shots[i].q, 5 + n % 4);
        ctd(&service[i], shots[i].q, service[i].q, 12);
        if (purge[i].q) active++;
        check = (int32_t)((uint32_t)check * 3u + (uint32_t)(delay[i].et + purge[i].et + shots[i].cv + service[i].cv));
    }
    check = (int32_t)((uint32_t)check + (uint32_t)active);
}
