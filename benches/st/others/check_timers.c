/* 500 timers, counters and edges in arrays, in a chain from the inputs to the counters. */
#include <stdbool.h>
#include "st.h"

static int32_t now; /* ms, of this scan */

typedef struct { int32_t start, et; bool in, q; } timer_t_;

static void ton(timer_t_ *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = now;
        t->et = now - t->start;
        if (t->et >= pt)
            t->et = pt;
        t->q = t->et >= pt;
    }
    t->in = in;
}

static void tof(timer_t_ *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else if (t->q) {
        if (t->in)
            t->start = now;
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    t->in = in;
}

static void tp(timer_t_ *t, bool in, int32_t pt)
{
    if (in && !t->in && !t->q) {
        t->q = true;
        t->start = now;
    }
    if (t->q) {
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

typedef struct { bool m, q; } trig_t;

static void r_trig(trig_t *t, bool clk)
{
    t->q = clk && !t->m;
    t->m = clk;
}

static void f_trig(trig_t *t, bool clk)
{
    t->q = !clk && !t->m;
    t->m = !clk;
}

typedef struct { int16_t cv; bool cu, cd, q, qd; } counter_t;

static void ctu(counter_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static void ctd(counter_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static void ctud(counter_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->cu = cu;
    c->cd = cd;
    c->q = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static int32_t scan_no;
static uint32_t rnd = 0x2545F491;
static bool in[96];
static int32_t pt[80];
static timer_t_ tons[80], tofs[80], tps[80];
static trig_t rise[40], fall[40];
static counter_t up[60], down[60], updown[58];
static timer_t_ ton_blink, tof_blink;
static trig_t trig_blink;
static counter_t ctu_blink;

void scan(void)
{
    now = (int32_t)(now_us / 1000);
    if (scan_no == 0)
        for (int i = 0; i < 80; i++)
            pt[i] = 20 + 10 * (i % 16);

    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;
    int base = (scan_no % 6) * 16;
    for (int i = 0; i < 16; i++)
        in[base + i] = (rnd >> i) & 1;
    scan_no++;
    int32_t sum = 0;

    for (int i = 0; i < 80; i++) {
        ton(&tons[i], in[i], pt[i]);
        if (tons[i].q)
            sum += 1;
        sum += tons[i].et;
    }
    for (int i = 0; i < 80; i++) {
        tof(&tofs[i], in[i + 4] && tons[i].q, pt[i]);
        if (tofs[i].q)
            sum += 2;
        sum += tofs[i].et;
    }
    for (int i = 0; i < 80; i++) {
        tp(&tps[i], in[i + 8], pt[i]);
        if (tps[i].q)
            sum += 3;
        sum += tps[i].et;
    }
    for (int i = 0; i < 40; i++) {
        r_trig(&rise[i], tofs[i].q);
        if (rise[i].q)
            sum += i;
        f_trig(&fall[i], tps[i].q);
        if (fall[i].q)
            sum += 2 * i;
    }
    for (int i = 0; i < 60; i++) {
        ctu(&up[i], tps[i].q, up[i].q && in[i], 12);
        if (up[i].q)
            sum += 5;
        sum += up[i].cv;
    }
    for (int i = 0; i < 60; i++) {
        ctd(&down[i], in[i + 12], down[i].q && in[i + 2], 9);
        if (down[i].q)
            sum += 7;
        sum += down[i].cv;
    }
    for (int i = 0; i < 58; i++) {
        counter_t *c = &updown[i];
        ctud(c, in[i + 5], tps[i].q, c->q && in[i + 20], c->qd && in[i + 22], 6);
        if (c->q)
            sum += 11;
        if (c->qd)
            sum += 13;
        sum += c->cv;
    }

    ton(&ton_blink, !tof_blink.q, 200);
    tof(&tof_blink, ton_blink.q, 300);
    r_trig(&trig_blink, tof_blink.q);
    ctu(&ctu_blink, trig_blink.q, ctu_blink.q, 100);
    sum += ctu_blink.cv;

    check = (check * 31 + sum) % 1000003;
}
