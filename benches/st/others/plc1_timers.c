#include <stdbool.h>
#include "st.h"

typedef struct { bool in, q, run; int32_t pt, et; uint32_t start; } Ton;
typedef struct { bool in, q, run; int32_t pt, et; uint32_t start; } Tof;
typedef struct { bool in, q; uint8_t state; int32_t pt, et; uint32_t start; } Tp;
typedef struct { bool cu, r, q, old; int16_t pv, cv; } Ctu;
typedef struct { bool cd, ld, q, old; int16_t pv, cv; } Ctd;

static void ton_call(Ton *t, bool in, int32_t pt, uint32_t now)
{
    t->in = in;
    t->pt = pt;
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
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tof_call(Tof *t, bool in, int32_t pt, uint32_t now)
{
    t->in = in;
    t->pt = pt;
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now;
        }
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->q = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tp_call(Tp *t, bool in, int32_t pt, uint32_t now)
{
    t->in = in;
    t->pt = pt;
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
        t->q = true;
    }
    if (t->state == 1) {
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->state = 2;
            t->q = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void ctu_call(Ctu *c, bool cu, bool r, int16_t pv)
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

static void ctd_call(Ctd *c, bool cd, bool ld, int16_t pv)
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

static int32_t scanNo;
static bool first = true;
static bool inp[100];
static int32_t ptOn[100], ptOff[100], ptPulse[100];
static int16_t pvUp[100], pvDown[100];
static Ton ton1[100];
static Tof tof1[100];
static Tp tp1[100];
static Ctu ctu1[100];
static Ctd ctd1[100];

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    int32_t pass, qs, sum;

    if (first) {
        for (int32_t i = 0; i < 100; i++) {
            ptOn[i] = 5 + i % 40;
            ptOff[i] = 10 + i % 25;
            ptPulse[i] = 8 + i % 30;
            pvUp[i] = (int16_t)(3 + i % 10);
            pvDown[i] = (int16_t)(4 + i % 7);
        }
        first = false;
    }
    for (pass = 1; pass <= 6; pass++) {
        scanNo++;
        qs = 0;
        sum = 0;
        for (int32_t i = 0; i < 100; i++) {
            inp[i] = (scanNo + i * 7) % 400 < 240;
            ton_call(&ton1[i], inp[i], ptOn[i], now);
            tof_call(&tof1[i], ton1[i].q, ptOff[i], now);
            tp_call(&tp1[i], tof1[i].q, ptPulse[i], now);
            ctu_call(&ctu1[i], tp1[i].q, ctu1[i].q, pvUp[i]);
            ctd_call(&ctd1[i], inp[i], ctd1[i].q, pvDown[i]);
            if (ton1[i].q) qs += 1;
            if (tof1[i].q) qs += 3;
            if (tp1[i].q) qs += 5;
            sum += ton1[i].et + ctu1[i].cv + ctd1[i].cv * 2;
        }
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(qs * 7 + sum));
    }
}
