/* 100 stations with five blocks each: TON, TOF, TP, CTU, CTD */
#include <stdbool.h>
#include "st.h"

#define N 100

struct ton { bool running, q; int32_t pt, et; uint32_t start; };
struct tof { bool running, q; int32_t pt, et; uint32_t start; };
struct tp { bool old, running, q; int32_t pt, et; uint32_t start; };
struct ctu { bool old, q; int16_t pv, cv; };
struct ctd { bool old, q; int16_t pv, cv; };

static void ton_run(struct ton *t, bool in, int32_t pt, uint32_t now)
{
    t->pt = pt;
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
    if (!t->q) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= t->pt) {
            t->et = t->pt;
            t->q = true;
        }
    }
}

static void tof_run(struct tof *t, bool in, int32_t pt, uint32_t now)
{
    t->pt = pt;
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
        if (t->et >= t->pt) {
            t->et = t->pt;
            t->q = false;
            t->running = false;
        }
    }
}

static void tp_run(struct tp *t, bool in, int32_t pt, uint32_t now)
{
    t->pt = pt;
    if (t->running) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= t->pt) {
            t->et = t->pt;
            t->q = false;
            t->running = false;
        }
    } else if (in && !t->old) {
        t->running = true;
        t->q = true;
        t->start = now;
        t->et = 0;
    }
    if (!t->running && !in)
        t->et = 0;
    t->old = in;
}

static void ctu_run(struct ctu *c, bool cu, bool r, int16_t pv)
{
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= c->pv;
}

static void ctd_run(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    c->pv = pv;
    if (ld)
        c->cv = c->pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static int32_t tick;
static bool sensor[N];
static int32_t on_delay[N], off_delay[N], pulse[N];
static struct ton ton1[N];
static struct tof tof1[N];
static struct tp tp1[N];
static struct ctu ctu1[N];
static struct ctd ctd1[N];

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    int32_t sum;
    int i;

    if (first) {
        first = false;
        for (i = 0; i < N; i++) {
            on_delay[i] = 20 + 7 * (i % 13);
            off_delay[i] = 30 + 5 * (i % 11);
            pulse[i] = 15 + 9 * (i % 7);
        }
    }

    /* a few sensors change in each scan */
    tick = (tick + 1) % 100000;
    sensor[tick * 7 % N] = !sensor[tick * 7 % N];
    sensor[tick * 13 % N] = tick % 3 != 0;

    sum = 0;
    for (i = 0; i < N; i++) {
        ton_run(&ton1[i], sensor[i], on_delay[i], now);
        tof_run(&tof1[i], ton1[i].q, off_delay[i], now);
        tp_run(&tp1[i], tof1[i].q, pulse[i], now);
        ctu_run(&ctu1[i], tp1[i].q, ctd1[i].q, 4);
        ctd_run(&ctd1[i], ton1[i].q, ctu1[i].q, 6);
        if (tof1[i].q)
            sum += 1;
        if (tp1[i].q)
            sum += 2;
        sum += ctu1[i].cv + ctd1[i].cv + ton1[i].et;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
