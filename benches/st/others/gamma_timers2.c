/* 84 pneumatic stations with 6 timers and counters each */
#include <stdbool.h>
#include "st.h"

static uint32_t now_ms;

typedef struct { bool q, run; uint32_t start; int32_t et; } Ton;
typedef struct { bool q, run; uint32_t start; int32_t et; } Tof;
typedef struct { bool q, run, old; uint32_t start; int32_t et; } Tp;
typedef struct { bool q, old; int16_t cv; } Ctu;
typedef struct { bool q, old; int16_t cv; } Ctd;

static void ton(Ton *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now_ms;
    }
    if (!t->q) {
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(Tof *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->run = false;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (!t->run && in && !t->old) {
        t->run = true;
        t->q = true;
        t->start = now_ms;
    }
    t->old = in;
    if (t->run) {
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->run = false;
        }
    }
    if (!t->run && !in)
        t->et = 0;
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

typedef struct {
    bool extend, fault, service;
    int16_t step;
    Ton ton_move, ton_watch;
    Tof tof_part;
    Tp tp_horn;
    Ctu ctu_cycle;
    Ctd ctd_mag;
} Station;

static void station(Station *s, bool start, bool part, int32_t move, int32_t dwell)
{
    tof(&s->tof_part, part, 35);
    switch (s->step) {
    case 0:
        s->extend = false;
        if (start && s->tof_part.q)
            s->step = 1;
        break;
    case 1:
        s->extend = true;
        if (s->ton_move.q)
            s->step = 2;
        break;
    case 2:
        if (!s->tof_part.q || s->ton_watch.q)
            s->step = 3;
        break;
    case 3:
        s->extend = false;
        if (!s->ton_move.q)
            s->step = 0;
        break;
    }
    ton(&s->ton_move, s->extend, move);
    ton(&s->ton_watch, s->step == 2, dwell);
    tp(&s->tp_horn, s->ton_watch.q || s->ctd_mag.q, 150);
    ctu(&s->ctu_cycle, s->extend, s->service && !start, 50);
    ctd(&s->ctd_mag, s->step == 1, s->tp_horn.q && start, 20);
    s->service = s->ctu_cycle.q;
    s->fault = s->tp_horn.q;
}

static Station stations[84];
static int32_t scan_no;

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);
    scan_no++;
    int32_t sum = 0;
    for (int i = 1; i <= 84; i++) {
        Station *s = &stations[i - 1];
        bool start = ((scan_no + i) % 50) < 45;
        bool part = ((scan_no + i * 11) % 64) < 20;
        station(s, start, part, 30 + i, 80);
        sum += s->step;
        if (s->extend)
            sum += 10;
        if (s->fault)
            sum += 100;
        if (s->service)
            sum += 1000 + i;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
