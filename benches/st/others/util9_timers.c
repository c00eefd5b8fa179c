/* Debounce, delay and counting of the telemetry inputs of a pumping station */
#include <stdbool.h>
#include "st.h"

typedef struct { int64_t start, et; bool q, on; } ton_t;
typedef struct { int64_t start, et; bool q, on; } tof_t;
typedef struct { int64_t start, et; bool q, old; } tp_t;
typedef struct { int16_t cv; bool q, old; } ctu_t;
typedef struct { int16_t cv; bool q, old; } ctd_t;
typedef struct { int16_t cv; bool qu, qd, old_u, old_d; } ctud_t;

#define N_TON 150
#define N_TOF 100
#define N_TP 50
#define N_CTU 80
#define N_CTD 60
#define N_CTUD 60

static ton_t on_delay[N_TON];
static tof_t off_delay[N_TOF];
static tp_t pulse[N_TP];
static ctu_t starts[N_CTU];
static ctd_t batch[N_CTD];
static ctud_t balance[N_CTUD];
static int64_t delay_time[N_TON];
static bool dig_in[N_TON];
static bool init;
static int32_t scans;
static uint32_t seed = 99;

static void ton(ton_t *t, bool in, int64_t pt)
{
    if (!in) {
        t->on = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->on) {
        t->on = true;
        t->start = (int64_t)now_us;
    }
    t->et = (int64_t)now_us - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = true;
    } else
        t->q = false;
}

static void tof(tof_t *t, bool in, int64_t pt)
{
    if (in) {
        t->q = true;
        t->on = false;
        t->et = 0;
    } else if (t->q) {
        if (!t->on) {
            t->on = true;
            t->start = (int64_t)now_us;
        }
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
}

static void tp(tp_t *t, bool in, int64_t pt)
{
    if (t->q) {
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->old) {
        t->start = (int64_t)now_us;
        t->et = 0;
        t->q = pt > 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->old = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->old_u, down = cd && !c->old_d;
    c->old_u = cu;
    c->old_d = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N_TON; i++)
            delay_time[i] = 3000LL * (i + 1);
        init = true;
    }
    scans++;
    for (int i = 0; i < 3; i++) {
        seed = seed * 1664525u + 1013904223u;
        int k = (seed / 65536) % 150;
        dig_in[k] = !dig_in[k];
    }

    int32_t active = 0, sum = 0;
    for (int i = 0; i < N_TON; i++) {
        ton(&on_delay[i], dig_in[i], delay_time[i]);
        if (on_delay[i].q)
            active++;
        else if (on_delay[i].et > 20000)
            sum += i + 1;
    }
    for (int i = 0; i < N_TOF; i++) {
        tof(&off_delay[i], on_delay[i].q, delay_time[i]);
        if (off_delay[i].q) {
            active += 3;
            sum += (i + 1) * 2;
        }
    }
    for (int i = 0; i < N_TP; i++) {
        tp(&pulse[i], off_delay[i].q && dig_in[i + 50], delay_time[i + 20]);
        if (pulse[i].q) {
            active += 7;
            sum -= i + 1;
        }
    }
    for (int i = 0; i < N_CTU; i++) {
        ctu(&starts[i], on_delay[i].q, starts[i].q && dig_in[i + 70], 5 + (i + 1) % 7);
        if (starts[i].q)
            sum += 100;
        sum += starts[i].cv;
    }
    for (int i = 0; i < N_CTD; i++) {
        ctd(&batch[i], dig_in[i + 10], batch[i].q, 10 + (i + 1) % 5);
        if (batch[i].q)
            sum += 1000;
        sum += batch[i].cv;
    }
    for (int i = 0; i < N_CTUD; i++) {
        ctud(&balance[i], dig_in[i], dig_in[i + 60], balance[i].qu && dig_in[i + 90], scans % 1000 == 0, 8);
        if (balance[i].qu)
            active += 11;
        else if (balance[i].qd)
            active += 13;
        sum += balance[i].cv;
    }
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)sum * 3u + (uint32_t)active);
}
