/* 500 timers and counters: 120 TON, 80 TOF, 80 TP, 120 CTU, 100 CTD. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool in; int32_t pt; bool q; int32_t et; bool run; int32_t start; } ton_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; bool run; int32_t start; } tof_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; uint8_t state; int32_t start; } tp_t;
typedef struct { bool cu, r; int16_t pv; bool q; int16_t cv; bool m; } ctu_t;
typedef struct { bool cd, ld; int16_t pv; bool q; int16_t cv; bool m; } ctd_t;

static ton_t ton1[120];
static tof_t tof1[80];
static tp_t tp1[80];
static ctu_t ctu1[120];
static ctd_t ctd1[100];
static int32_t cyc;

static int32_t since(int32_t now, int32_t start)
{
    return (int32_t)((uint32_t)now - (uint32_t)start);
}

static void ton(ton_t *t, bool in, int32_t pt, int32_t now)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->et = 0;
        t->run = false;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    if (!t->q) {
        int32_t e = since(now, t->start);
        if (e >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt, int32_t now)
{
    t->in = in;
    t->pt = pt;
    if (in) {
        t->q = true;
        t->et = 0;
        t->run = false;
        return;
    }
    if (t->q) {
        int32_t e;
        if (!t->run) {
            t->run = true;
            t->start = now;
        }
        e = since(now, t->start);
        if (e >= pt) {
            t->q = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tp(tp_t *t, bool in, int32_t pt, int32_t now)
{
    t->in = in;
    t->pt = pt;
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
    }
    if (t->state == 1) {
        int32_t e = since(now, t->start);
        if (e >= pt) {
            t->state = 2;
            t->q = false;
            t->et = pt;
        } else {
            t->q = true;
            t->et = e;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    bool edge = cu && !c->m;
    c->cu = cu;
    c->r = r;
    c->pv = pv;
    c->m = cu;
    if (r)
        c->cv = 0;
    else if (edge && c->cv < 32767)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    bool edge = cd && !c->m;
    c->cd = cd;
    c->ld = ld;
    c->pv = pv;
    c->m = cd;
    if (ld)
        c->cv = pv;
    else if (edge && c->cv > -32768)
        c->cv--;
    c->q = c->cv <= 0;
}

void scan(void)
{
    int32_t now = (int32_t)(now_us / 1000);
    int32_t i, n = 0, sum = 0;
    bool x;

    cyc++;
    for (i = 0; i < 120; i++) {
        ton(&ton1[i], (cyc + i * 5) % 37 < 29, 20 + i, now);
        if (ton1[i].q) n++;
        sum += ton1[i].et;
    }
    for (i = 0; i < 80; i++) {
        tof(&tof1[i], (cyc + i * 3) % 41 < 9, 30 + i, now);
        if (tof1[i].q) n++;
        sum += tof1[i].et;
    }
    for (i = 0; i < 80; i++) {
        tp(&tp1[i], (cyc + i * 7) % 29 < 11, 15 + i, now);
        if (tp1[i].q) n++;
        sum += tp1[i].et;
    }
    for (i = 0; i < 120; i++) {
        x = ton1[i].q;
        ctu(&ctu1[i], x, ctu1[i].q && cyc % 64 == 0, 3);
        if (ctu1[i].q) n++;
        sum += ctu1[i].cv;
    }
    for (i = 0; i < 100; i++) {
        x = (cyc + i) % 6 < 3;
        ctd(&ctd1[i], x, ctd1[i].q, 10);
        if (ctd1[i].q) n++;
        sum += ctd1[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum * 512u + (uint32_t)n);
}
