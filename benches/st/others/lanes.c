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

enum state { IDLE, FILLING, SETTLING, EMPTYING };

#define LANES 100

static int scans;
static enum state state[LANES];
static bool call[LANES];
static uint32_t fill_time[LANES];
static Timer filling[LANES], settling[LANES], lamp[LANES];
static Counter batches[LANES], level[80];
static Pulse horn[20];

void scan(void)
{
    now_ms = now_us / 1000;
    if (scans == 0)
        for (int i = 0; i < LANES; i++)
            fill_time[i] = 20 + 10 * ((i + 1) % 7);
    scans++;

    for (int i = 0; i < LANES; i++) {
        call[i] = (scans + i + 1) % 17 < 6;
        ton(&filling[i], state[i] == FILLING, fill_time[i]);
        ton(&settling[i], state[i] == SETTLING, 30);
        switch (state[i]) {
        case IDLE:
            if (call[i])
                state[i] = FILLING;
            break;
        case FILLING:
            if (filling[i].q)
                state[i] = SETTLING;
            else if (filling[i].et >= 40 && !call[i])
                state[i] = IDLE;
            break;
        case SETTLING:
            if (settling[i].q)
                state[i] = EMPTYING;
            break;
        case EMPTYING:
            if (!call[i])
                state[i] = IDLE;
            break;
        }
    }

    for (int i = 0; i < LANES; i++) {
        tof(&lamp[i], state[i] == EMPTYING, 50);
        ctu(&batches[i], lamp[i].q, batches[i].qu && !call[i], 9);
    }
    for (int i = 0; i < 80; i++)
        ctud(&level[i], filling[i].q, settling[i + 20].q, false, scans % 300 == 1, 15);
    for (int i = 0; i < 20; i++)
        tp(&horn[i], (scans + 2 * (i + 1)) % 11 < 5, 40);

    int sum = 0;
    for (int i = 0; i < LANES; i++) {
        if (lamp[i].q)
            sum += 5;
        sum += batches[i].cv * 2;
    }
    for (int i = 0; i < 80; i++) {
        if (level[i].qu || level[i].qd)
            sum += 13;
        sum += level[i].cv;
    }
    for (int i = 0; i < 20; i++)
        if (horn[i].q)
            sum += i + 1;
    check = (check * 31 + sum) % 1000003;
}
