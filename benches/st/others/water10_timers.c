#include <stdbool.h>
#include "st.h"

typedef struct { uint32_t start, et; bool in, q; } ton_t;
typedef struct { uint32_t start; bool in, q; } tof_t;
typedef struct { uint32_t start; bool in, q; } tp_t;
typedef struct { int16_t cv; bool clk, q; } ctu_t;
typedef struct { int16_t cv; bool clk, q; } ctd_t;
typedef struct { int16_t cv; bool cu, cd, qu, qd; } ctud_t;

static uint32_t now_ms;

static inline void ton(ton_t *t, bool in, uint32_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_ms;
        uint32_t e = now_ms - t->start;
        t->et = e < pt ? e : pt;
        t->q = e >= pt;
    }
    t->in = in;
}

static inline void tof(tof_t *t, bool in, uint32_t pt)
{
    if (in) {
        t->q = true;
    } else {
        if (t->in)
            t->start = now_ms;
        if (t->q && now_ms - t->start >= pt)
            t->q = false;
    }
    t->in = in;
}

static inline void tp(tp_t *t, bool in, uint32_t pt)
{
    if (t->q) {
        if (now_ms - t->start >= pt)
            t->q = false;
    } else if (in && !t->in) {
        t->q = true;
        t->start = now_ms;
    }
    t->in = in;
}

static inline void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->clk && c->cv < INT16_MAX)
        c->cv++;
    c->clk = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->clk && c->cv > INT16_MIN)
        c->cv--;
    c->clk = cd;
    c->q = c->cv <= 0;
}

static inline void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
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

struct valve { ton_t t_open, t_close; ctu_t c_stroke; bool fault; };
struct pump {
    ton_t t_start, t_dry;
    tof_t t_stop;
    tp_t t_flush;
    bool start_clk, stop_m;
    ctu_t c_starts;
    ctd_t c_rest;
    bool run, locked;
    int16_t starts;
};

static uint32_t rnd = 99;
static bool di[256];
static struct valve valve[60];
static struct pump pump[24];
static ton_t deb_on[40];
static tof_t deb_off[40];
static ctud_t batch[30];
static tp_t blink[20];
static bool reset_old;

static void valve_run(struct valve *v, bool open_cmd, bool open_fb, bool closed_fb, bool reset, uint32_t rt)
{
    ton(&v->t_open, open_cmd && !open_fb, rt);
    ton(&v->t_close, !open_cmd && !closed_fb, rt);
    ctu(&v->c_stroke, open_fb, reset, 25);
    v->fault = (v->fault || v->t_open.q || v->t_close.q) && !reset;
}

static void pump_run(struct pump *p, bool request, bool flow, bool reset)
{
    ton(&p->t_start, request && !p->locked, 150);
    tof(&p->t_stop, p->t_start.q, 400);
    p->run = p->t_stop.q;
    bool started = p->run && !p->start_clk;
    p->start_clk = p->run;
    bool stopped = !p->run && !p->stop_m;
    p->stop_m = !p->run;
    tp(&p->t_flush, stopped, 250);
    ton(&p->t_dry, p->run && !flow, 700);
    ctu(&p->c_starts, started, reset, 1000);
    ctd(&p->c_rest, started, reset, 12);
    p->starts = (int16_t)(p->c_starts.cv - p->c_rest.cv);
    p->locked = p->c_rest.q && p->starts > 0;
}

static inline uint32_t next_rnd(void) { return rnd = rnd * 1664525u + 1013904223u; }
static inline void add(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);
    for (int i = 0; i < 6; i++) {
        uint32_t k = next_rnd() >> 24;
        di[k] = !di[k];
    }
    bool reset_pb = (next_rnd() >> 22) == 7;
    bool reset = reset_pb && !reset_old;
    reset_old = reset_pb;

    uint32_t sum = 0;
    for (int i = 0; i < 60; i++) {
        struct valve *v = &valve[i];
        valve_run(v, di[i], di[i + 60], !di[i + 60] && di[i + 120], reset, 900);
        if (v->fault)
            sum += 1;
        if (v->c_stroke.q)
            sum += 100;
        sum += (uint32_t)(v->c_stroke.cv * 3) + v->t_open.et + v->t_close.et;
    }
    add(sum);

    sum = 0;
    for (int i = 0; i < 24; i++) {
        struct pump *p = &pump[i];
        pump_run(p, di[i + 180], di[i + 210], reset);
        if (p->run)
            sum += 1;
        if (p->t_flush.q)
            sum += 50;
        if (p->t_dry.q)
            sum += 2500;
        sum = sum * 3 + (uint32_t)p->starts;
    }
    add(sum);

    sum = 0;
    for (int i = 0; i < 40; i++) {
        ton(&deb_on[i], di[i], 300);
        tof(&deb_off[i], deb_on[i].q, 500);
        if (deb_off[i].q)
            sum += (uint32_t)i;
    }
    for (int i = 0; i < 30; i++) {
        ctud(&batch[i], deb_off[i].q, di[i + 200], reset, false, 5);
        sum += (uint32_t)batch[i].cv;
        if (batch[i].qu)
            sum += 7;
        else if (batch[i].qd)
            sum += 11;
    }
    for (int i = 0; i < 20; i++) {
        tp(&blink[i], valve[i].fault && !blink[i].q, 200);
        if (blink[i].q)
            sum = sum * 2 + 1;
    }
    add(sum);
}
