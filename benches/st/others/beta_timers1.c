#include "st.h"
#include <stdbool.h>

typedef struct { bool q, running; int32_t et; uint32_t start; } Ton;
typedef struct { bool q, running; int32_t et; uint32_t start; } Tof;
typedef struct { bool q, running, prev; int32_t et; uint32_t start; } Tp;
typedef struct { bool q, prev; int16_t cv; } Ctu;
typedef struct { bool q, prev; int16_t cv; } Ctd;

static void ton(Ton *t, bool in, int32_t pt, uint32_t now)
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

static void tof(Tof *t, bool in, int32_t pt, uint32_t now)
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
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->q = false;
            t->running = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt, uint32_t now)
{
    if (t->running) {
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->running = false;
            t->q = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    } else if (in && !t->prev) {
        t->running = true;
        t->q = true;
        t->start = now;
        t->et = 0;
    }
    if (!t->running && !in)
        t->et = 0;
    t->prev = in;
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->prev && c->cv < INT16_MAX)
        c->cv++;
    c->prev = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->prev && c->cv > INT16_MIN)
        c->cv--;
    c->prev = cd;
    c->q = c->cv <= 0;
}

static bool ready;
static int32_t tick;
static Ton delays[150];
static Tof holds[100];
static Tp pulses[100];
static Ctu ups[75];
static Ctd downs[75];
static int32_t delay_time[150];

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    if (!ready) {
        ready = true;
        for (int i = 0; i < 150; i++)
            delay_time[i] = 10 * (i % 20 + 1);
    }
    tick++;
    if (tick >= 1000000)
        tick = 0;
    int32_t on_count = 0, et_sum = 0, cv_sum = 0;
    for (int i = 0; i < 150; i++) {
        ton(&delays[i], (tick + i * 3) % 64 < 48, delay_time[i], now);
        if (delays[i].q)
            on_count++;
        et_sum += delays[i].et;
    }
    for (int i = 0; i < 100; i++) {
        tof(&holds[i], delays[i].q, 150, now);
        if (holds[i].q)
            on_count++;
        et_sum += holds[i].et;
    }
    for (int i = 0; i < 100; i++) {
        tp(&pulses[i], holds[i].q && delays[i + 50].q, 70, now);
        if (pulses[i].q)
            on_count++;
        et_sum += pulses[i].et;
    }
    for (int i = 0; i < 75; i++) {
        ctu(&ups[i], pulses[i].q, ups[i].q, 5 + i % 7);
        cv_sum += ups[i].cv;
    }
    for (int i = 0; i < 75; i++) {
        ctd(&downs[i], delays[i].q, downs[i].q, 3 + i % 11);
        cv_sum += downs[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)on_count * 7u + (uint32_t)et_sum + (uint32_t)cv_sum);
}
