/* 500 timers and counters: 150 TON, 100 TOF, 50 TP, 100 CTU, 50 CTD, 50 CTUD */
#include <stdbool.h>
#include "st.h"

typedef struct { uint64_t start, et; bool in, q; } Timer;
typedef struct { int16_t cv; bool cu, cd, qu, qd; } Counter;

static inline void ton(Timer *t, bool in, uint64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_us;
        uint64_t et = now_us - t->start;
        t->q = et >= pt;
        t->et = t->q ? pt : et;
    }
    t->in = in;
}

static inline void tof(Timer *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else if (t->q) {
        if (t->in)
            t->start = now_us;
        uint64_t et = now_us - t->start;
        if (et >= pt) {
            et = pt;
            t->q = false;
        }
        t->et = et;
    }
    t->in = in;
}

static inline void tp(Timer *t, bool in, uint64_t pt)
{
    if (!t->q && in && !t->in) {
        t->start = now_us;
        t->q = true;
    }
    if (t->q) {
        uint64_t et = now_us - t->start;
        if (et >= pt) {
            et = pt;
            t->q = false;
        }
        t->et = et;
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static inline void ctu(Counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->qu = c->cv >= pv;
}

static inline void ctd(Counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->qd = c->cv <= 0;
}

static inline void ctud(Counter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
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

static bool init_done;
static int16_t period[64], phase[64];
static bool din[64];
static Timer on_delay[150], off_delay[100], pulse[50];
static Counter up_count[100], dn_count[50], ud_count[50];
static uint64_t on_time[150], off_time[100], pls_time[50];

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < 64; i++)
            period[i] = 3 + i * 7 % 29;
        for (int i = 0; i < 150; i++)
            on_time[i] = 10000 * (1 + i % 17);
        for (int i = 0; i < 100; i++)
            off_time[i] = 10000 * (2 + i % 13);
        for (int i = 0; i < 50; i++)
            pls_time[i] = 30000 + 5000 * i;
        init_done = true;
    }

    for (int i = 0; i < 64; i++)
        if (++phase[i] >= period[i]) {
            phase[i] = 0;
            din[i] = !din[i];
        }

    uint32_t active = 0, late = 0;
    for (int i = 0; i < 150; i++) {
        ton(&on_delay[i], din[i % 64] && !din[(i + 5) % 64], on_time[i]);
        if (on_delay[i].q)
            active++;
        if (on_delay[i].et >= 40000)
            late += i;
    }
    for (int i = 0; i < 100; i++) {
        tof(&off_delay[i], on_delay[i].q || on_delay[i + 50].q, off_time[i]);
        if (off_delay[i].q)
            active += 3;
    }
    for (int i = 0; i < 50; i++) {
        tp(&pulse[i], off_delay[i].q && din[i], pls_time[i]);
        if (pulse[i].q)
            active += 5;
    }

    uint32_t hash = active * 1000 + late;
    for (int i = 0; i < 100; i++) {
        Counter *c = &up_count[i];
        ctu(c, on_delay[i].q, c->qu && din[i % 64], 5 + i % 7);
        hash = hash * 31 + c->cv;
    }
    for (int i = 0; i < 50; i++) {
        Counter *c = &dn_count[i];
        ctd(c, pulse[i].q, c->qd, 6 + i % 5);
        hash = hash * 31 + c->cv;
    }
    for (int i = 0; i < 50; i++) {
        Counter *c = &ud_count[i];
        ctud(c, off_delay[i + 50].q, din[i + 10], c->qu, c->qd && up_count[i].qu, 4 + i % 9);
        hash = hash * 31 + c->cv;
        if (c->qd)
            hash++;
    }
    check = (int32_t)hash;
}
