#include <stdbool.h>
#include "st.h"

#define LINES 50

typedef struct { bool q, run; uint32_t et, start; } timer;   /* ms */
typedef struct { bool q, old; int16_t cv; } counter;
typedef struct { bool qu, qd, cu_old, cd_old; int16_t cv; } ud_counter;

static uint32_t now_ms;

static void ton(timer *t, bool in, uint32_t pt)
{
    if (!in) {
        t->run = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now_ms;
    }
    if (!t->q) {
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(timer *t, bool in, uint32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->q)
        return;
    if (!t->run) {
        t->run = true;
        t->start = now_ms;
    }
    t->et = now_ms - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = false;
    }
}

static void tp(timer *t, bool in, uint32_t pt)
{
    if (!t->run && in) {
        t->run = t->q = true;
        t->start = now_ms;
    }
    if (t->q) {
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in) {
        t->run = false;
        t->et = 0;
    }
}

static void ctu(counter *c, bool cu, bool r, int16_t pv)
{
    bool edge = cu && !c->old;
    c->old = cu;
    if (r)
        c->cv = 0;
    else if (edge && c->cv < INT16_MAX)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(counter *c, bool cd, bool ld, int16_t pv)
{
    bool edge = cd && !c->old;
    c->old = cd;
    if (ld)
        c->cv = pv;
    else if (edge && c->cv > INT16_MIN)
        c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(ud_counter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu_old, down = cd && !c->cd_old;
    c->cu_old = cu;
    c->cd_old = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

typedef struct {
    uint32_t start_delay, run_on, flush, flow_fail, valve_fail;
    int16_t strokes, batch, stock;
} line_cfg;

typedef struct { bool run_cmd, flow_sw, valve_fb, stroke, refill, ack; } line_in;

typedef struct {
    bool pump, valve, fault, empty, ready;
    bool run_old, pump_off_old;
    timer start_delay, flow_fail, valve_fail, run_on, flush;
    counter stroke, batch;
    ud_counter stock;
} dosing_line;

static void line_update(dosing_line *l, const line_cfg *cfg, const line_in *x)
{
    bool started = x->run_cmd && !l->run_old;
    l->run_old = x->run_cmd;
    ton(&l->start_delay, x->run_cmd && !l->fault, cfg->start_delay);
    tof(&l->run_on, l->start_delay.q, cfg->run_on);
    l->pump = l->run_on.q && !l->fault;

    bool stopped = !l->pump && !l->pump_off_old;
    l->pump_off_old = !l->pump;
    tp(&l->flush, stopped, cfg->flush);
    l->valve = l->pump || l->flush.q;

    ton(&l->flow_fail, l->pump && !x->flow_sw, cfg->flow_fail);
    ton(&l->valve_fail, l->valve != x->valve_fb, cfg->valve_fail);

    ctu(&l->stroke, x->stroke && l->pump, l->stroke.q || started, cfg->strokes);
    ctd(&l->batch, l->stroke.q, started, cfg->batch);
    ctud(&l->stock, x->refill, l->stroke.q, false, x->ack, cfg->stock);
    l->ready = l->batch.q;
    l->empty = l->stock.qd;

    if (l->flow_fail.q || l->valve_fail.q)
        l->fault = true;
    else if (x->ack)
        l->fault = false;
}

static dosing_line lines[LINES];
static line_cfg cfg[LINES];
static line_in inputs[LINES];
static uint32_t seed = 20011;
static bool init_done;

static inline uint32_t mix(uint32_t sum, uint32_t v) { return sum * 31 + v; }

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);

    if (!init_done) {
        for (int i = 0; i < LINES; i++) {
            int k = i + 1;
            cfg[i] = (line_cfg){
                .start_delay = 20 + 3 * k, .run_on = 50 + 5 * k, .flush = 100 + k,
                .flow_fail = 1500, .valve_fail = 2000,
                .strokes = 3 + k % 5, .batch = 2 + k % 3, .stock = 10,
            };
            inputs[i].flow_sw = true;
        }
        init_done = true;
    }

    for (int i = 0; i < 8; i++) {
        seed = seed * 1664525u + 1013904223u;
        int n = (seed >> 16) % LINES;
        line_in *x = &inputs[n];
        switch (seed >> 29) {
        case 0: case 1: x->run_cmd = !x->run_cmd; break;
        case 2: x->flow_sw = !x->flow_sw; break;
        case 3: x->valve_fb = lines[n].valve; break;
        case 4: case 5: x->stroke = !x->stroke; break;
        case 6: x->refill = !x->refill; break;
        default: x->ack = !x->ack; break;
        }
    }

    int running = 0, flushing = 0, faults = 0, strokes = 0, stock = 0;
    uint32_t waiting = 0;
    for (int i = 0; i < LINES; i++) {
        dosing_line *l = &lines[i];
        line_update(l, &cfg[i], &inputs[i]);
        if (l->pump)
            running++;
        else if (l->valve)
            flushing++;
        faults += l->fault;
        if (l->ready && !l->empty)
            strokes += 1000;
        strokes += l->stroke.cv;
        stock += l->stock.cv;
        waiting += l->start_delay.et + l->flow_fail.et;
    }
    uint32_t sum = (uint32_t)check;
    sum = mix(sum, running);
    sum = mix(sum, flushing);
    sum = mix(sum, faults);
    sum = mix(sum, strokes);
    sum = mix(sum, stock);
    check = (int32_t)mix(sum, waiting);
}
