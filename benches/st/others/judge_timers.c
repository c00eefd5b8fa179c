/* 500 standard blocks: 150 TON, 100 TOF, 100 TP, 75 CTU, 75 CTD. */
#include "st.h"
#include <stdbool.h>

typedef struct { bool q, running; int32_t et; uint32_t start; } Ton;
typedef struct { bool q, running; int32_t et; uint32_t start; } Tof;
typedef struct { bool q, old; int32_t et; uint32_t start; } Tp;
typedef struct { bool q, old; int16_t cv; } Ctu;
typedef struct { bool q, old; int16_t cv; } Ctd;

static uint32_t now;    /* ms, one value for the scan */

static void ton(Ton *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->running = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now;
    }
    if (!t->q) {
        t->et = (int32_t)(now - t->start);
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
        t->running = false;
        t->et = 0;
        return;
    }
    if (t->q) {
        if (!t->running) {
            t->running = true;
            t->start = now;
        }
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (t->q) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->old) {
        t->start = now;
        t->et = 0;
        t->q = pt > 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->old = in;
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < 32767)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > -32768)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static int32_t tick;
static int32_t pt_on[150], pt_off[100], pt_pulse[100];
static int16_t pv_up[75], pv_down[75];
static Ton on_delay[150];
static Tof off_delay[100];
static Tp pulse[100];
static Ctu up[75];
static Ctd down[75];

void scan(void)
{
    int32_t i, sum;

    now = (uint32_t)(now_us / 1000);
    if (first) {
        first = false;
        for (i = 0; i < 150; i++)
            pt_on[i] = 20 + i * 7;
        for (i = 0; i < 100; i++) {
            pt_off[i] = 15 + i * 5;
            pt_pulse[i] = 30 + i * 3;
        }
        for (i = 0; i < 75; i++) {
            pv_up[i] = (int16_t)(3 + i % 20);
            pv_down[i] = (int16_t)(5 + i % 13);
        }
    }

    tick++;
    if (tick >= 100000)
        tick = 0;
    sum = 0;

    for (i = 0; i < 150; i++) {
        ton(&on_delay[i], (tick + i * 3) % 200 > 40, pt_on[i]);
        if (on_delay[i].q)
            sum += 1;
        sum += on_delay[i].et;
    }
    for (i = 0; i < 100; i++) {
        tof(&off_delay[i], (tick + i) % 120 < 30, pt_off[i]);
        if (off_delay[i].q)
            sum += 3;
        sum += off_delay[i].et;
    }
    for (i = 0; i < 100; i++) {
        tp(&pulse[i], (tick + i) % 50 < 5, pt_pulse[i]);
        if (pulse[i].q)
            sum += 5;
        sum += pulse[i].et;
    }
    for (i = 0; i < 75; i++) {
        ctu(&up[i], pulse[i].q, up[i].q, pv_up[i]);
        if (up[i].q)
            sum += 7;
        sum += up[i].cv;
    }
    for (i = 0; i < 75; i++) {
        ctd(&down[i], on_delay[i].q, down[i].q, pv_down[i]);
        if (down[i].q)
            sum += 11;
        sum += down[i].cv;
    }
    check = (check % 1000003) * 31 + sum;
}
