/* Chapter 5: timers and counters. 100 stations with five blocks each. */
#include <stdbool.h>
#include "st.h"

#define STATIONS 100

typedef struct {
    bool q;
    bool running;
    int32_t et;
    uint32_t start;
} Ton;

typedef struct {
    bool q;
    bool in_old;
    bool running;
    int32_t et;
    uint32_t start;
} Tof;

typedef struct {
    bool q;
    bool in_old;
    bool running;
    int32_t et;
    uint32_t start;
} Tp;

typedef struct {
    bool q;
    bool cu_old;
    int16_t cv;
} Ctu;

typedef struct {
    bool q;
    bool cd_old;
    int16_t cv;
} Ctd;

static uint32_t now;

static void ton(Ton *t, bool in, int32_t pt)
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
        t->et = 0;
        t->running = false;
    } else {
        if (t->in_old) {
            t->running = true;
            t->start = now;
        }
        if (t->running) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
                t->running = false;
            }
        }
    }
    t->in_old = in;
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (in && !t->in_old && !t->running && t->et == 0) {
        t->running = true;
        t->q = true;
        t->start = now;
    }
    if (t->running) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->running = false;
        }
    }
    if (!t->running && !in)
        t->et = 0;
    t->in_old = in;
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu_old && c->cv < INT16_MAX)
        c->cv++;
    c->cu_old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd_old && c->cv > INT16_MIN)
        c->cv--;
    c->cd_old = cd;
    c->q = c->cv <= 0;
}

static bool first = true;
static int16_t phase[STATIONS];
static int16_t period[STATIONS];
static int16_t on_len[STATIONS];
static bool eye[STATIONS];
static int32_t run_on[STATIONS];
static int32_t pulse_len[STATIONS];
static Ton debounce[STATIONS];
static Tof motor[STATIONS];
static Tp pusher[STATIONS];
static Ctu good[STATIONS];
static Ctd left[STATIONS];

void scan(void)
{
    int32_t motors_on = 0, pushers_on = 0, batches = 0, cases = 0, elapsed = 0;

    now = (uint32_t)(now_us / 1000);

    if (first) {
        first = false;
        for (int i = 0; i < STATIONS; i++) {
            period[i] = 20 + (i * 7) % 41;
            on_len[i] = 8 + i % 9;
            phase[i] = (i * 13) % 20;
            run_on[i] = 10 + (i * 3) % 50;
            pulse_len[i] = 5 + i % 30;
        }
    }

    for (int i = 0; i < STATIONS; i++) {
        /* products pass the photo eye */
        phase[i]++;
        if (phase[i] >= period[i])
            phase[i] = 0;
        eye[i] = phase[i] < on_len[i];

        ton(&debounce[i], eye[i], 3);
        tof(&motor[i], debounce[i].q, run_on[i]);
        ctu(&good[i], debounce[i].q, good[i].q, 24);
        ctd(&left[i], debounce[i].q, left[i].q, 6);
        tp(&pusher[i], left[i].q, pulse_len[i]);

        if (motor[i].q)
            motors_on++;
        if (pusher[i].q)
            pushers_on++;
        if (good[i].q)
            batches++;
        if (left[i].q)
            cases++;
        elapsed += debounce[i].et + motor[i].et + pusher[i].et + good[i].cv + left[i].cv;
    }

    check = (int32_t)((uint32_t)check * 31u
            + (uint32_t)(elapsed + motors_on * 3 + pushers_on * 5 + batches * 7 + cases * 11));
}
