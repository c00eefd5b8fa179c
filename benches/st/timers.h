/* Timers, counters and edges of IEC 61131-3, as somebody writes them in C who has read the standard. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool run, q; uint32_t start, et; } Timer;
typedef struct { bool in, run, q; uint32_t start, et; } Pulse;
typedef struct { bool up, down, qu, qd; int16_t cv; } Counter;

static uint32_t now_ms;

static inline bool ton(Timer *t, bool in, uint32_t pt)
{
    if (!in) {
        t->run = t->q = false;
        t->et = 0;
    } else if (!t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
    return t->q;
}

static inline bool tof(Timer *t, bool in, uint32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
    } else if (t->q) {
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
    return t->q;
}

static inline bool tp(Pulse *t, bool in, uint32_t pt)
{
    if (in && !t->in && !t->run) {
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
    t->in = in;
    return t->q;
}

static inline bool ctu(Counter *c, bool cu, bool r, int pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->up && c->cv < INT16_MAX)
        c->cv++;
    c->up = cu;
    return c->qu = c->cv >= pv;
}

static inline bool ctd(Counter *c, bool cd, bool ld, int pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->down && c->cv > INT16_MIN)
        c->cv--;
    c->down = cd;
    return c->qd = c->cv <= 0;
}

static inline void ctud(Counter *c, bool cu, bool cd, bool r, bool ld, int pv)
{
    bool up = cu && !c->up, down = cd && !c->down;
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
    c->up = cu;
    c->down = cd;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static inline bool rising(bool *old, bool clk)
{
    bool q = clk && !*old;
    *old = clk;
    return q;
}
