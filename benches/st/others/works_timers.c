/* 50 conveyor zones of a packaging line, ten timers/counters each = 500 blocks */
#include <stdbool.h>
#include "st.h"

typedef struct { int32_t et; uint32_t start; bool q, old; } Timer;
typedef struct { int16_t cv; bool q, old; } Counter;

static uint32_t now_ms;

static void ton(Timer *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->old)
            t->start = now_ms;
        if (!t->q) {
            t->et = (int32_t)(now_ms - t->start);
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->old = in;
}

static void tof(Timer *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->old)
            t->start = now_ms;
        if (t->q) {
            t->et = (int32_t)(now_ms - t->start);
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->old = in;
}

static void tp(Timer *t, bool in, int32_t pt)
{
    if (t->q) {
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = in ? pt : 0;
            t->q = false;
        }
    } else if (in && !t->old) {
        t->start = now_ms;
        t->et = 0;
        t->q = pt > 0;
    } else if (!in) {
        t->et = 0;
    }
    t->old = in;
}

static void ctu(Counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

typedef struct {
    bool run, jam, batch, lamp;
    int32_t ms;
    Timer tStart, tJamIn, tJamOut, tStarve, tRunOn, tAccu, tEject;
    Counter cTotal, cJams, cBatch;
} Zone;

static void zone(Zone *z, bool peIn, bool peOut, bool enable, bool nextFree, bool reset, int32_t base)
{
    ton(&z->tStart, enable && !z->jam, base);
    ton(&z->tJamIn, peIn && z->run, base + 40);
    ton(&z->tJamOut, peOut && !nextFree, base + 120);
    ton(&z->tStarve, z->run && !peIn, 250);
    tof(&z->tRunOn, peIn || peOut, base + base);
    tof(&z->tAccu, peOut, 30);
    z->run = z->tStart.q && z->tRunOn.q && (nextFree || !z->tAccu.q);
    tp(&z->tEject, z->tJamIn.q || z->tJamOut.q, 75);
    ctu(&z->cTotal, peOut, reset, 100);
    ctu(&z->cJams, z->tEject.q, reset, 5);
    ctd(&z->cBatch, peOut && z->run, reset || z->batch, 12);
    z->batch = z->cBatch.q;
    z->jam = ((z->tJamIn.q && z->tJamOut.q) || z->jam) && !reset;
    z->lamp = z->tStarve.q || z->tEject.q || z->cJams.q || z->cTotal.q;
    z->ms = z->tStart.et + z->tJamIn.et + z->tRunOn.et;
}

static Zone zones[51];
static int32_t base[51];
static bool first = true;
static int32_t scanNo;

void scan(void)
{
    int32_t i, sum = 0;
    bool free = true;

    now_ms = (uint32_t)(now_us / 1000);
    if (first) {
        for (i = 1; i <= 50; i++)
            base[i] = 10 + (i * 7) % 60;
        first = false;
    }
    scanNo = (scanNo + 1) % 100000;
    for (i = 50; i >= 1; i--) {
        Zone *z = &zones[i];
        int32_t phase = (scanNo + i * 13) % 97;
        zone(z, phase < 40, phase > 30 && phase < 70, phase != 96, free,
             (scanNo + i) % 701 == 0, base[i]);
        free = !z->jam && z->run;
        if (z->run) sum += i;
        if (z->lamp) sum += 3;
        if (z->batch) sum += 1000;
        sum += z->ms;
    }
    check = (check * 3 + sum) % 10000019;
}
