/* 500 timers and counters: 150 TON, 100 TOF, 100 TP, 75 CTU, 75 CTD */
#include <stdbool.h>
#include "st.h"

#define N_TON 150
#define N_TOF 100
#define N_TP  100
#define N_COUNTERS 75

typedef struct {
    uint32_t start;
    int32_t et;
    bool running;
    bool q;
} ton_t;

typedef struct {
    uint32_t start;
    int32_t et;
    bool last;
    bool running;
    bool q;
} tof_t;

typedef struct {
    uint32_t start;
    int32_t et;
    uint8_t state;      /* 0 idle, 1 running, 2 over and waiting for in to go off */
    bool q;
} tp_t;

typedef struct {
    int16_t cv;
    bool last;
    bool q;
} ctr_t;

static ton_t on_t[N_TON];
static tof_t off_t[N_TOF];
static tp_t pulse[N_TP];
static ctr_t up[N_COUNTERS];
static ctr_t down[N_COUNTERS] ;
static int32_t delay[N_TON];
static bool sig[N_TON];
static int32_t tick;
static bool first = true;

static void ton(ton_t *t, bool in, int32_t pt, uint32_t now)
{
    if (!in) {
        t->q = false;
        t->et = 0;
        t->running = false;
        return;
    }
    if (!t->running && !t->q) {
        t->running = true;
        t->start = now;
        t->et = 0;
    }
    if (t->running) {
        int32_t d = (int32_t)(now - t->start);
        if (d >= pt) {
            t->et = pt;
            t->q = true;
            t->running = false;
        } else {
            t->et = d;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt, uint32_t now)
{
    if (in) {
        t->q = true;
        t->et = 0;
        t->running = false;
    } else {
        if (t->last) {
            t->running = true;
            t->start = now;
        }
        if (t->running) {
            int32_t d = (int32_t)(now - t->start);
            if (d >= pt) {
                t->et = pt;
                t->q = false;
                t->running = false;
            } else {
                t->et = d;
            }
        }
    }
    t->last = in;
}

static void tp(tp_t *t, bool in, int32_t pt, uint32_t now)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
        t->q = true;
    }
    if (t->state == 1) {
        int32_t d = (int32_t)(now - t->start);
        if (d >= pt) {
            t->et = pt;
            t->q = false;
            t->state = 2;
        } else {
            t->et = d;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void ctu(ctr_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->last && c->cv < INT16_MAX)
        c->cv++;
    c->last = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctr_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->last && c->cv > INT16_MIN)
        c->cv--;
    c->last = cd;
    c->q = c->cv <= 0;
}

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    int32_t n_on = 0, n_off = 0, n_pulse = 0, n_cnt = 0;
    int16_t i;

    if (first) {
        for (i = 0; i < N_TON; i++)
            delay[i] = 20 + i * 7;
        first = false;
    }

    tick++;

    for (i = 0; i < N_TON; i++)
        sig[i] = (tick / (i + 3)) % 3 != 0;

    for (i = 0; i < N_TON; i++) {
        ton(&on_t[i], sig[i], delay[i], now);
        if (on_t[i].q)
            n_on++;
    }

    for (i = 0; i < N_TOF; i++) {
        tof(&off_t[i], sig[i] && !on_t[i].q, 150, now);
        if (off_t[i].q)
            n_off++;
    }

    for (i = 0; i < N_TP; i++) {
        tp(&pulse[i], off_t[i].q, delay[i], now);
        if (pulse[i].q)
            n_pulse += pulse[i].et;
    }

    for (i = 0; i < N_COUNTERS; i++) {
        ctu(&up[i], sig[i], up[i].q, 10);
        ctd(&down[i], pulse[i].q, up[i].q, 25);
        n_cnt += up[i].cv + down[i].cv;
        if (down[i].q)
            n_cnt += 1000;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n_on + (uint32_t)n_off * 3u
                      + (uint32_t)n_pulse * 5u + (uint32_t)n_cnt);
}
