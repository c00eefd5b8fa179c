/* 300 timers and 200 counters driven by square waves of different periods. */
#include <stdbool.h>
#include "st.h"

#define NT 100
#define NC 70
#define NUD 60

typedef struct { bool q, run; uint64_t start, et; } ton_t;
typedef struct { bool q, run, prev; uint64_t start, et; } tof_t;
typedef struct { bool q, prev; uint64_t start, et; } tp_t;
typedef struct { bool q, prev; int16_t cv; } cnt_t;
typedef struct { bool qu, qd, pu, pd; int16_t cv; } ctud_t;

static bool first = true;
static bool inp[NT];
static int32_t per[NT], ph[NT];
static uint64_t pt[NT];
static int16_t pv[NC];
static ton_t ton[NT];
static tof_t tof[NT];
static tp_t tp[NT];
static cnt_t ctu[NC], ctd[NC];
static ctud_t ctud[NUD];

static void ton_run(ton_t *t, bool in, uint64_t p)
{
    if (!in) {
        t->run = false;
        t->et = 0;
        t->q = false;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now_us;
    }
    t->et = now_us - t->start;
    if (t->et >= p)
        t->et = p;
    t->q = t->et >= p;
}

static void tof_run(tof_t *t, bool in, uint64_t p)
{
    if (in) {
        t->q = true;
        t->et = 0;
        t->run = false;
    } else {
        if (t->prev) {
            t->run = true;
            t->start = now_us;
        }
        if (t->run) {
            t->et = now_us - t->start;
            if (t->et >= p) {
                t->et = p;
                t->q = false;
                t->run = false;
            }
        }
    }
    t->prev = in;
}

static void tp_run(tp_t *t, bool in, uint64_t p)
{
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= p) {
            t->et = p;
            t->q = false;
        }
    } else if (in && !t->prev) {
        t->q = true;
        t->start = now_us;
        t->et = 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->prev = in;
}

static void ctu_run(cnt_t *c, bool cu, bool r, int16_t p)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->prev && c->cv < INT16_MAX)
        c->cv++;
    c->prev = cu;
    c->q = c->cv >= p;
}

static void ctd_run(cnt_t *c, bool cd, bool ld, int16_t p)
{
    if (ld)
        c->cv = p;
    else if (cd && !c->prev && c->cv > INT16_MIN)
        c->cv--;
    c->prev = cd;
    c->q = c->cv <= 0;
}

static void ctud_run(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t p)
{
    bool u = cu && !c->pu, d = cd && !c->pd;

    c->pu = cu;
    c->pd = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = p;
    else if (u && !d && c->cv < INT16_MAX)
        c->cv++;
    else if (d && !u && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= p;
    c->qd = c->cv <= 0;
}

void scan(void)
{
    int32_t i, sum = 0;

    if (first) {
        first = false;
        for (i = 0; i < NT; i++) {
            per[i] = 3 + (i * 7) % 41;
            pt[i] = 5000u * (uint64_t)(i % 17 + 1);
        }
        for (i = 0; i < NC; i++)
            pv[i] = (int16_t)(3 + i % 5);
    }

    /* square waves */
    for (i = 0; i < NT; i++) {
        ph[i] = ph[i] + 1;
        if (ph[i] >= per[i]) {
            ph[i] = 0;
            inp[i] = !inp[i];
        }
    }

    for (i = 0; i < NT; i++) {
        ton_run(&ton[i], inp[i], pt[i]);
        tof_run(&tof[i], inp[i], pt[i]);
        tp_run(&tp[i], inp[i], pt[i]);
        if (ton[i].q)
            sum = sum + i;
        if (tof[i].q)
            sum = sum + 3 * i;
        if (tp[i].q)
            sum = sum + 5 * i;
        sum = sum + (int32_t)(ton[i].et / 1000);
    }
    for (i = 0; i < NC; i++) {
        ctu_run(&ctu[i], inp[i], ctu[i].q, pv[i]);
        ctd_run(&ctd[i], ton[i].q, ctd[i].q, pv[i]);
        if (ctu[i].q)
            sum = sum + 1000;
        sum = sum + ctu[i].cv + 2 * ctd[i].cv;
    }
    for (i = 0; i < NUD; i++) {
        ctud_run(&ctud[i], inp[i], tp[i + 40].q, ctu[i].q && ctud[i].qu, ctd[i].q && inp[i + 1], pv[i]);
        if (ctud[i].qu)
            sum = sum + 300;
        if (ctud[i].qd)
            sum = sum + 500;
        sum = sum + ctud[i].cv * i;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
