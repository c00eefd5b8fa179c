#include <stdbool.h>
#include "st.h"

#define LANES 100

typedef struct { bool in; int32_t pt; bool q; int32_t et; uint32_t start; bool old; } ton_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; uint32_t start; bool old; } tof_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; uint32_t start; bool old; } tp_t;
typedef struct { bool cu, r; int16_t pv; bool q; int16_t cv; bool old; } ctu_t;
typedef struct { bool cd, ld; int16_t pv; bool q; int16_t cv; bool old; } ctd_t;

static void ton(ton_t *t, uint32_t now)
{
    if (!t->in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->old)
            t->start = now;
        if (!t->q) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= t->pt) {
                t->et = t->pt;
                t->q = true;
            }
        }
    }
    t->old = t->in;
}

static void tof(tof_t *t, uint32_t now)
{
    if (t->in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->old)
            t->start = now;
        if (t->q) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= t->pt) {
                t->et = t->pt;
                t->q = false;
            }
        }
    }
    t->old = t->in;
}

static void tp(tp_t *t, uint32_t now)
{
    if (t->q) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= t->pt) {
            t->q = false;
            t->et = t->in ? t->pt : 0;
        }
    } else if (t->in && !t->old) {
        t->start = now;
        t->et = 0;
        t->q = t->pt > 0;
    } else if (!t->in) {
        t->et = 0;
    }
    t->old = t->in;
}

static void ctu(ctu_t *c)
{
    if (c->r)
        c->cv = 0;
    else if (c->cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = c->cu;
    c->q = c->cv >= c->pv;
}

static void ctd(ctd_t *c)
{
    if (c->ld)
        c->cv = c->pv;
    else if (c->cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = c->cd;
    c->q = c->cv <= 0;
}

typedef struct {
    int32_t delay, run_on, pulse;
    int16_t batch;
} setup_t;

typedef struct {
    bool sensor, reset;
    setup_t setup;
    bool motor, signal, batch_done;
    int16_t pieces, left;
    int32_t remaining;
    ton_t t_delay;
    tof_t t_run_on;
    tp_t t_pulse;
    ctu_t c_pieces;
    ctd_t c_batch;
} lane_t;

static void lane(lane_t *l, uint32_t now)
{
    l->t_delay.in = l->sensor;
    l->t_delay.pt = l->setup.delay;
    ton(&l->t_delay, now);

    l->t_run_on.in = l->t_delay.q;
    l->t_run_on.pt = l->setup.run_on;
    tof(&l->t_run_on, now);

    l->t_pulse.in = l->t_delay.q && !l->reset;
    l->t_pulse.pt = l->setup.pulse;
    tp(&l->t_pulse, now);

    l->c_pieces.cu = l->t_pulse.q;
    l->c_pieces.r = l->reset || (l->c_pieces.q && l->sensor);
    l->c_pieces.pv = l->setup.batch;
    ctu(&l->c_pieces);

    l->c_batch.cd = l->t_run_on.q;
    l->c_batch.ld = l->reset || (l->c_batch.q && l->t_delay.q);
    l->c_batch.pv = l->setup.batch;
    ctd(&l->c_batch);

    l->motor = l->t_run_on.q;
    l->signal = l->t_pulse.q;
    l->batch_done = l->c_pieces.q || l->c_batch.q;
    l->pieces = l->c_pieces.cv;
    l->left = l->c_batch.cv;
    l->remaining = l->setup.run_on - l->t_run_on.et;
}

static lane_t lanes[LANES];
static setup_t setups[LANES];
static bool init_done;
static int32_t scans;

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);

    if (!init_done) {
        for (int i = 0; i < LANES; i++) {
            setups[i].delay = 2 + i % 7;
            setups[i].run_on = 5 + i % 11;
            setups[i].pulse = 3 + i % 5;
            setups[i].batch = (int16_t)(4 + i % 13);
        }
    }

    scans++;
    if (scans >= 100000)
        scans = 0;
    for (int i = 0; i < LANES; i++) {
        lanes[i].sensor = (scans + 5 * i) % (40 + i) < 25;
        lanes[i].reset = !init_done || scans % 500 == i;
        lanes[i].setup = setups[i];
        lane(&lanes[i], now);
    }
    init_done = true;

    for (int i = 0; i < LANES; i++) {
        check += lanes[i].pieces - lanes[i].left + lanes[i].remaining;
        if (lanes[i].motor)
            check += 3;
        if (lanes[i].signal && !lanes[i].batch_done)
            check += 17;
    }
}
