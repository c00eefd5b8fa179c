/* Debounce, run-on and pulse timers and piece counters of a cold end */
#include "st.h"
#include <stdbool.h>

#define MS(x) ((int64_t)(x) * 1000)

typedef struct { int64_t start, et; bool in, q; } ton_t;
typedef struct { int64_t start, et; bool in, q, running; } tof_t;
typedef struct { int64_t start, et; bool in, q; } tp_t;
typedef struct { int16_t cv; bool cu, q; } ctu_t;
typedef struct { int16_t cv; bool cd, q; } ctd_t;
typedef struct { int16_t cv; bool cu, cd, qu, qd; } ctud_t;

static void ton(ton_t *t, bool in, int64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = (int64_t)now_us;
        if (!t->q) {
            t->et = (int64_t)now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->in = in;
}

static void tof(tof_t *t, bool in, int64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
        t->running = false;
    } else {
        if (t->in) {
            t->start = (int64_t)now_us;
            t->running = true;
        }
        if (t->running) {
            t->et = (int64_t)now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
                t->running = false;
            }
        }
    }
    t->in = in;
}

static void tp(tp_t *t, bool in, int64_t pt)
{
    if (t->q) {
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->in) {
        t->start = (int64_t)now_us;
        t->et = 0;
        t->q = pt > 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu;
    bool down = cd && !c->cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down) {
        if (c->cv < INT16_MAX)
            c->cv++;
    } else if (down && !up) {
        if (c->cv > INT16_MIN)
            c->cv--;
    }
    c->cu = cu;
    c->cd = cd;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static bool ready;
static int16_t phase[64], period[64];
static bool sens[64];
static ton_t on_dly[160];
static int64_t on_pt[160];
static tof_t off_dly[120];
static int64_t off_pt[120];
static tp_t pulse[100];
static int64_t pulse_pt[100];
static ctu_t pieces[60];
static ctd_t batch[30];
static ctud_t buffer[30];

static void init(void)
{
    for (int i = 0; i < 64; i++) {
        period[i] = 12 + (i * 5) % 37;
        phase[i] = i % 11;
    }
    for (int i = 0; i < 160; i++)
        on_pt[i] = MS(10) * (2 + i % 17);
    for (int i = 0; i < 120; i++)
        off_pt[i] = MS(10) * (3 + i % 13);
    for (int i = 0; i < 100; i++)
        pulse_pt[i] = MS(10) * (1 + i % 9);
    ready = true;
}

void scan(void)
{
    if (!ready)
        init();

    for (int i = 0; i < 64; i++) {
        if (++phase[i] >= period[i])
            phase[i] = 0;
        sens[i] = phase[i] < period[i] / 2;
    }

    int32_t n_on = 0, n_late = 0, n_off = 0, n_pulse = 0, n_full = 0, n_empty = 0;
    for (int i = 0; i < 160; i++) {
        ton(&on_dly[i], sens[i % 64], on_pt[i]);
        if (on_dly[i].q)
            n_on += i;
        if (on_dly[i].et > MS(60))
            n_late++;
    }

    for (int i = 0; i < 120; i++) {
        tof(&off_dly[i], on_dly[i].q || (sens[(i + 5) % 64] && sens[(i + 9) % 64]), off_pt[i]);
        if (off_dly[i].q)
            n_off += i;
    }

    for (int i = 0; i < 100; i++) {
        tp(&pulse[i], off_dly[i].q && !sens[(i + 3) % 64], pulse_pt[i]);
        if (pulse[i].q)
            n_pulse += i;
    }

    bool reset = sens[0] && sens[1] && sens[2] && sens[3] && sens[4];
    for (int i = 0; i < 60; i++) {
        ctu(&pieces[i], pulse[i].q, pieces[i].q && !sens[i], 5 + i % 7);
        n_full += pieces[i].cv;
    }

    for (int i = 0; i < 30; i++) {
        ctd(&batch[i], pulse[i + 60].q, batch[i].q, 4 + i % 5);
        n_empty += batch[i].cv;
        ctud(&buffer[i], on_dly[i + 120].q, pulse[i + 40].q, reset && i < 10,
             buffer[i].qu && sens[i + 20], 3 + i % 6);
        n_empty += 3 * buffer[i].cv;
        if (buffer[i].qd)
            n_empty++;
    }

    int32_t total = n_on + 3 * n_off + 5 * n_pulse + 7 * n_late + 11 * n_full + 13 * n_empty;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)total);
}
