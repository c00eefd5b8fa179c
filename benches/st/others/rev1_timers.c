/* 540 timers and counters of a plant: 150 on-delays, 100 off-delays, 100 pulses, 100 up and 90 down counters. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool q, running; int32_t et; uint32_t start; } ton_t;
typedef struct { bool q, running; int32_t et; uint32_t start; } tof_t;
typedef struct { bool q; uint8_t state; int32_t et; uint32_t start; } tp_t;
typedef struct { bool q, old; int16_t cv; } counter_t;

static void ton(ton_t *t, bool in, int32_t pt, uint32_t now)
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

static void tof(tof_t *t, bool in, int32_t pt, uint32_t now)
{
    if (in) {
        t->q = true;
        t->running = false;
        t->et = 0;
        return;
    }
    if (!t->q) return;
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

static void tp(tp_t *t, bool in, int32_t pt, uint32_t now)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
        t->q = true;
    }
    if (t->state == 1) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->state = 2;
        }
    }
    if (t->state == 2 && !in) {
        t->et = 0;
        t->state = 0;
    }
}

static void ctu(counter_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(counter_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static int32_t seed = 12345;
static ton_t ton1[150];
static tof_t tof1[100];
static tp_t tp1[100];
static counter_t ctu1[100], ctd1[90];
static bool sensor[150];
static int32_t ton_time[150], tof_time[150], tp_time[150], longest[150];
static int32_t long_tof[100], long_tp[100];
static bool ton_old[150], tof_old[150], tp_old[150];
static int32_t switched[150], fell[150], pulses[150];
static bool first = true;

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    if (first) {
        first = false;
        for (int i = 0; i < 150; i++) {
            ton_time[i] = 20 + i * 3;
            tof_time[i] = 15 + i * 2;
            tp_time[i] = 30 + i * 5;
        }
    }

    for (int k = 0; k < 12; k++) {
        seed = (seed * 1103 + 12345) % 65536;
        int i = seed % 150;
        sensor[i] = !sensor[i];
    }

    int16_t active = 0;
    int32_t elapsed = 0;
    for (int i = 0; i < 150; i++) {
        ton(&ton1[i], sensor[i], ton_time[i], now);
        if (ton1[i].q) active++;
        if (ton1[i].q && !ton_old[i]) switched[i]++;
        ton_old[i] = ton1[i].q;
        if (ton1[i].et > longest[i]) longest[i] = ton1[i].et;
        elapsed += ton1[i].et;
    }
    for (int i = 0; i < 100; i++) {
        tof(&tof1[i], ton1[i].q, tof_time[i], now);
        if (tof1[i].q) active++;
        if (tof_old[i] && !tof1[i].q) fell[i]++;
        tof_old[i] = tof1[i].q;
        if (tof1[i].et > long_tof[i]) long_tof[i] = tof1[i].et;
        tp(&tp1[i], tof1[i].q && !sensor[i + 50], tp_time[i], now);
        if (tp1[i].q) active++;
        if (tp1[i].q && !tp_old[i]) pulses[i]++;
        tp_old[i] = tp1[i].q;
        if (tp1[i].et > long_tp[i]) long_tp[i] = tp1[i].et;
        elapsed += tof1[i].et + tp1[i].et;
    }

    int32_t counts = 0;
    for (int i = 0; i < 100; i++) {
        ctu(&ctu1[i], tp1[i].q, ctu1[i].q && !sensor[i], (int16_t)(5 + i % 7));
        counts += ctu1[i].cv + switched[i] % 100 + longest[i];
    }
    for (int i = 0; i < 90; i++) {
        ctd(&ctd1[i], sensor[i + 60], ctd1[i].q && tof1[i].q, (int16_t)(3 + i % 5));
        counts += ctd1[i].cv + (fell[i] + pulses[i]) % 100 + long_tof[i] + long_tp[i];
    }

    check = (check * 31 + elapsed + counts * 7 + active) % 1000003;
}
