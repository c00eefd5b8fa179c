#include "st.h"
#include <stdbool.h>

typedef struct { bool run, q; int32_t et; uint32_t start; } ton_t;
typedef struct { bool run, q; int32_t et; uint32_t start; } tof_t;
typedef struct { bool run, q, old; int32_t et; uint32_t start; } tp_t;
typedef struct { bool q, old; int16_t cv; } ctu_t;
typedef struct { bool q, old; int16_t cv; } ctd_t;

static void ton(ton_t *t, bool in, int32_t pt, uint32_t now)
{
    if (!in) {
        t->run = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    if (!t->q) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt, uint32_t now)
{
    if (in) {
        t->run = false;
        t->q = true;
        t->et = 0;
        return;
    }
    if (t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now;
        }
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) {
            t->q = false;
            t->run = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tp(tp_t *t, bool in, int32_t pt, uint32_t now)
{
    if (!t->run) {
        if (in && !t->old) {
            t->run = true;
            t->q = true;
            t->start = now;
        } else if (!in) {
            t->et = 0;
        }
    }
    if (t->run) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) {
            t->run = false;
            t->q = false;
            t->et = in ? pt : 0;
        } else {
            t->et = el;
        }
    }
    t->old = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static uint32_t seed = 99;
static bool x[32];
static ton_t on_dly[125];
static tof_t off_dly[75];
static tp_t pulse[75];
static ctu_t up[125];
static ctd_t down[100];
static int32_t pt_on[125], pt_off[75], pt_pulse[75];

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    uint32_t w;
    int32_t n = 0;
    int i;

    if (first) {
        first = false;
        for (i = 0; i < 125; i++)
            pt_on[i] = 5 + i % 40;
        for (i = 0; i < 75; i++) {
            pt_off[i] = 10 + 2 * (i % 25);
            pt_pulse[i] = 20 + 3 * (i % 30);
        }
    }
    seed = seed * 1664525u + 1013904223u;
    w = seed | (seed >> 9);
    for (i = 0; i < 32; i++)
        x[i] = ((w >> i) & 1) == 1;

    for (i = 0; i < 125; i++) {
        ton(&on_dly[i], x[i % 32], pt_on[i], now);
        if (on_dly[i].q)
            n += 1;
    }
    for (i = 0; i < 75; i++) {
        tof(&off_dly[i], x[(i + 5) % 32], pt_off[i], now);
        tp(&pulse[i], x[(i + 11) % 32], pt_pulse[i], now);
        if (off_dly[i].q)
            n += 2;
        if (pulse[i].q)
            n += 3;
        n += off_dly[i].et + pulse[i].et;
    }
    for (i = 0; i < 125; i++) {
        ctu(&up[i], x[(i + 3) % 32], up[i].q, (int16_t)(10 + i));
        n += up[i].cv;
    }
    for (i = 0; i < 100; i++) {
        ctd(&down[i], x[(i + 17) % 32], down[i].q, (int16_t)(5 + i));
        n += down[i].cv;
        if (down[i].q)
            n += 7;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
