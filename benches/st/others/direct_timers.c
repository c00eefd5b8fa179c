/* 500 standard blocks: 100 TON, 100 TOF, 100 TP, 60 CTU, 40 CTD, 40 CTUD, 30 R_TRIG, 30 F_TRIG. */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

typedef struct { bool q, running; int32_t et, start; } ton_t;
typedef struct { bool q, running; int32_t et, start; } tof_t;
typedef struct { bool q, last; int32_t et, start; } tp_t;
typedef struct { bool q, last; int16_t cv; } ctu_t;
typedef struct { bool q, last; int16_t cv; } ctd_t;
typedef struct { bool qu, qd, last_u, last_d; int16_t cv; } ctud_t;
typedef struct { bool q, m; } trig_t;

static bool started;
static bool level[64];
static ton_t on_delay[100];
static tof_t off_delay[100];
static tp_t pulse[100];
static ctu_t up[60];
static ctd_t down[40];
static ctud_t up_down[40];
static trig_t rising[30];
static trig_t falling[30];
static int32_t preset[100];
static uint32_t first = 0x0BADCAFE;
static uint32_t second = 0x0BADCAFE;

static bool random_bit(uint32_t *state)
{
    bool bit = *state & 1;
    *state >>= 1;
    if (bit)
        *state ^= 0xA3000000;
    return bit;
}

static void ton(ton_t *t, bool in, int32_t pt, int32_t now)
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
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt, int32_t now)
{
    if (in) {
        t->q = true;
        t->running = false;
        t->et = 0;
        return;
    }
    if (!t->q)
        return;
    if (!t->running) {
        t->running = true;
        t->start = now;
    }
    t->et = now - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = false;
        t->running = false;
    }
}

static void tp(tp_t *t, bool in, int32_t pt, int32_t now)
{
    if (!t->q && in && !t->last) {
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
    t->last = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->last && c->cv < 32767)
        c->cv++;
    c->last = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->last && c->cv > -32768)
        c->cv--;
    c->last = cd;
    c->q = c->cv <= 0;
}

static void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool u = cu && !c->last_u, d = cd && !c->last_d;
    c->last_u = cu;
    c->last_d = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (u && !d && c->cv < 32767)
        c->cv++;
    else if (d && !u && c->cv > -32768)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

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

void scan(void)
{
    int32_t now = (int32_t)(now_us / 1000);

    if (!started) {
        started = true;
        for (int i = 0; i < 100; i++)
            preset[i] = 10 + 10 * (i % 9);
        for (int i = 0; i <= 40; i++)
            random_bit(&first);
    }

    for (int i = 0; i < 64; i++) {
        bool a = random_bit(&first);
        bool b = random_bit(&second);
        level[i] ^= a & b;
    }

    for (int i = 0; i < 100; i++) {
        ton(&on_delay[i], level[(i * 7) % 64], preset[i], now);
        tof(&off_delay[i], level[(i * 5 + 3) % 64], preset[i], now);
        tp(&pulse[i], level[(i * 11 + 9) % 64], preset[i], now);
        check = (check * 31 + on_delay[i].q + 2 * off_delay[i].q + 4 * pulse[i].q
            + on_delay[i].et + 3 * off_delay[i].et + 5 * pulse[i].et) % 1000003;
    }

    for (int i = 0; i < 60; i++) {
        ctu(&up[i], level[i], on_delay[i].q && pulse[i].q && level[i + 4], 5 + i % 4);
        check = (check * 31 + 7 * up[i].q + up[i].cv) % 1000003;
    }

    for (int i = 0; i < 40; i++) {
        ctd(&down[i], level[i + 20], off_delay[i].q && !level[i] && up[i].q, 3 + i % 6);
        ctud(&up_down[i], level[i + 10], level[63 - i], up[i].q && level[i + 1],
            down[i].q && pulse[i + 40].q && level[i + 2], 4 + i % 3);
        check = (check * 31 + down[i].q + 2 * up_down[i].qu + 4 * up_down[i].qd
            + abs(down[i].cv) + 3 * abs(up_down[i].cv)) % 1000003;
    }

    for (int i = 0; i < 30; i++) {
        r_trig(&rising[i], on_delay[i * 3].q);
        f_trig(&falling[i], off_delay[i * 3].q);
        check = (check * 31 + rising[i].q + 2 * falling[i].q) % 1000003;
    }
}
