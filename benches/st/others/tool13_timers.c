#include <stdbool.h>
#include "st.h"

#define MS 1000u

typedef struct { bool q, in; uint64_t start, et; } TON;
typedef struct { bool q, in; uint64_t start, et; } TOF;
typedef struct { bool q, in, running; uint64_t start, et; } TP;
typedef struct { bool q, cu; int16_t cv; } CTU;
typedef struct { bool q, cd; int16_t cv; } CTD;
typedef struct { bool qu, qd, cu, cd; int16_t cv; } CTUD;

static inline void ton(TON *t, bool in, uint64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_us;
        uint64_t et = now_us - t->start;
        t->q = et >= pt;
        t->et = t->q ? pt : et;
    }
    t->in = in;
}

static inline void tof(TOF *t, bool in, uint64_t pt)
{
    if (in) {
        t->et = 0;
        t->q = true;
    } else {
        if (t->in)
            t->start = now_us;
        if (t->q) {
            uint64_t et = now_us - t->start;
            t->q = et < pt;
            t->et = t->q ? et : pt;
        }
    }
    t->in = in;
}

static inline void tp(TP *t, bool in, uint64_t pt)
{
    if (!t->running && in && !t->in) {
        t->running = true;
        t->start = now_us;
    }
    if (t->running) {
        uint64_t et = now_us - t->start;
        t->q = et < pt;
        t->et = t->q ? et : pt;
        if (!t->q && !in) {
            t->running = false;
            t->et = 0;
        }
    }
    t->in = in;
}

static inline void ctu(CTU *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(CTD *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static inline void ctud(CTUD *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
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
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static TON on_delay[100];
static TOF off_delay[100];
static TP pulse[100];
static CTU pieces[100];
static CTD batch[50];
static CTUD level[50];
static int32_t tick;

void scan(void)
{
    uint32_t sum = 0;
    for (int i = 0; i < 100; i++) {
        bool sensor = (tick + i * 7) % 40 < 15 + i % 10;
        uint64_t delay = 20 * MS + i * MS;

        ton(&on_delay[i], sensor, delay);
        tof(&off_delay[i], on_delay[i].q, 55 * MS);
        tp(&pulse[i], !off_delay[i].q, 75 * MS);
        ctu(&pieces[i], pulse[i].q, pieces[i].q, 5 + i % 4);

        if (on_delay[i].q) sum += 1;
        if (off_delay[i].q) sum += 2;
        if (pulse[i].q) sum += 4;
        if (on_delay[i].et > 35 * MS) sum += 8;
        if (off_delay[i].et > 25 * MS) sum += 16;
        if (pulse[i].et > 45 * MS) sum += 32;
        sum += pieces[i].cv * (i + 1);
    }
    for (int i = 0; i < 50; i++) {
        ctd(&batch[i], on_delay[2 * i].q, batch[i].q, 6);
        ctud(&level[i], on_delay[i].q, pulse[i + 50].q, level[i].qu,
             pieces[i].q && pieces[i + 50].q, 12);
        sum += batch[i].cv * 3 + level[i].cv * (i + 5);
        if (level[i].qd) sum += 64;
    }
    tick++;
    check = (int32_t)((uint32_t)check * 31u + sum);
}
