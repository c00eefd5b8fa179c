/* 100 each of TON, TOF, TP, CTU, CTD */
#include <stdbool.h>
#include "st.h"

typedef struct { bool q, in; int32_t et; uint32_t start; } ton_t;
typedef struct { bool q, in; int32_t et; uint32_t start; } tof_t;
typedef struct { bool q, in, run; int32_t et; uint32_t start; } tp_t;
typedef struct { bool q, old; int16_t cv; } ctu_t;
typedef struct { bool q, old; int16_t cv; } ctd_t;

static void ton(ton_t *t, bool in, int32_t pt, uint32_t now)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in) t->start = now;
        if (!t->q) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= pt) { t->et = pt; t->q = true; }
        }
    }
    t->in = in;
}

static void tof(tof_t *t, bool in, int32_t pt, uint32_t now)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in) t->start = now;
        if (t->q) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= pt) { t->et = pt; t->q = false; }
        }
    }
    t->in = in;
}

static void tp(tp_t *t, bool in, int32_t pt, uint32_t now)
{
    if (t->run) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) { t->et = pt; t->q = false; t->run = false; }
    } else if (in && !t->in) {
        t->start = now;
        t->run = true;
        t->q = true;
        t->et = 0;
    }
    if (!t->run && !in) t->et = 0;
    t->in = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r) c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX) c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld) c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN) c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static int32_t n;
static bool inp[8];
static int32_t pt[100];
static ton_t on[100];
static tof_t off[100];
static tp_t pulse[100];
static ctu_t up[100];
static ctd_t down[100];

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    if (first) {
        first = false;
        for (int i = 0; i < 100; i++) pt[i] = 5 + i * 3;
    }
    n++;
    for (int i = 0; i < 8; i++) inp[i] = ((uint32_t)n >> i & 1) != 0;

    int32_t sum = 0;
    for (int i = 0; i < 100; i++) {
        ton(&on[i], inp[i % 8], pt[i], now);
        tof(&off[i], inp[i % 8], pt[i], now);
        tp(&pulse[i], inp[i % 8], pt[i], now);
        ctu(&up[i], on[i].q, up[i].q, 5);
        ctd(&down[i], inp[i % 8], down[i].q, 7);
        sum += on[i].et + off[i].et + pulse[i].et + up[i].cv + down[i].cv;
        if (off[i].q) sum += 1;
        if (pulse[i].q) sum += 2;
    }
    check = check * 31 + sum;
}
