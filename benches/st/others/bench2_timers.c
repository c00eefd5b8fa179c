/* 500 timers and counters: 100 each of TON, TOF, TP, CTU, CTD. */
#include "st.h"
#include <stdbool.h>

typedef struct { bool running, q; int32_t start, et; } ton_t;
typedef struct { bool prev, q; int32_t start, et; } tof_t;
typedef struct { bool prev, q; int32_t start, et; } tp_t;
typedef struct { bool prev, q; int16_t cv; } ctu_t;
typedef struct { bool prev, q; int16_t cv; } ctd_t;

static int32_t now;

static void ton(ton_t *t, bool in, int32_t pt)
{
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now;
    }
    t->et = now - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = true;
    }
}

static void tof(tof_t *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else if (t->q) {
        if (t->prev)
            t->start = now;
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    t->prev = in;
}

static void tp(tp_t *t, bool in, int32_t pt)
{
    if (t->q) {
        t->et = now - t->start;
        if (t->et >= pt) {
            t->q = false;
            t->et = in ? pt : 0;
        }
    } else if (in && !t->prev) {
        t->q = true;
        t->start = now;
        t->et = 0;
    } else if (!in) {
        t->et = 0;
    }
    t->prev = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->prev && c->cv < 32767)
        c->cv++;
    c->prev = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->prev && c->cv > -32768)
        c->cv--;
    c->prev = cd;
    c->q = c->cv <= 0;
}

static int32_t n;
static bool started;
static int32_t pt[100];
static int16_t limit[100];
static ton_t on_delay[100];
static tof_t off_delay[100];
static tp_t pulse[100];
static ctu_t up[100];
static ctd_t down[100];

void scan(void)
{
    now = (int32_t)(now_us / 1000);

    if (!started) {
        for (int i = 0; i < 100; i++) {
            pt[i] = 5 + 2 * (i % 20);
            limit[i] = 3 + i % 7;
        }
        started = true;
    }

    n = (n + 1) % 6400;
    int32_t active = 0;
    int32_t total = 0;

    for (int i = 0; i < 100; i++) {
        bool x = (n + 3 * i) % 64 < 40;
        ton(&on_delay[i], x, pt[i]);
        tof(&off_delay[i], on_delay[i].q, pt[i]);
        tp(&pulse[i], x, pt[i]);
        ctu(&up[i], on_delay[i].q, up[i].q, limit[i]);
        ctd(&down[i], pulse[i].q, down[i].q, limit[i]);

        if (on_delay[i].q) active += 1;
        if (off_delay[i].q) active += 2;
        if (pulse[i].q) active += 4;
        total += up[i].cv + down[i].cv + on_delay[i].et;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(active * 100 + total));
}
