/* Timer and counter bank: 100 each of TON, TOF, TP, CTU, CTD */
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

#define N 100

static bool init;
static Ton tons[N];
static Tof tofs[N];
static Tp tps[N];
static Ctu ctus[N];
static Ctd ctds[N];
static int32_t pt[N];
static int32_t scan_no;

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);
    if (!init) {
        for (int i = 0; i < N; i++)
            pt[i] = 20 + 7 * i;
        init = true;
    }
    scan_no++;
    int32_t sum = 0;
    int16_t on = 0;
    for (int i = 0; i < N; i++) {
        bool pulse = ((scan_no + i * 3) % (40 + i)) < 20 + i / 2;
        ton(&tons[i], pulse, pt[i]);
        tof(&tofs[i], pulse, pt[i]);
        tp(&tps[i], tons[i].q || !tofs[i].q, pt[i]);
        ctu(&ctus[i], pulse, ctus[i].q, 5 + i);
        ctd(&ctds[i], tps[i].q, ctds[i].q, 3 + i % 10);
        if (tons[i].q)
            on++;
        if (tofs[i].q)
            on += 2;
        if (tps[i].q)
            on += 3;
        sum += tons[i].et + tofs[i].et + ctus[i].cv + ctds[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)on);
}
