/* 440 conveyor zones with five timers and counters each = 2200 */
#include <stdbool.h>
#include "st.h"

typedef struct { bool q, run; int32_t et, start; } Ton;
typedef struct { bool q, run; int32_t et, start; } Tof;
typedef struct { bool q; uint8_t state; int32_t et, start; } Tp;
typedef struct { bool q, old; int16_t cv; } Ctu;
typedef struct { bool q, old; int16_t cv; } Ctd;

static void ton(Ton *t, bool in, int32_t pt, int32_t now)
{
    if (!in) {
        t->q = false;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    if (!t->q) {
        int32_t el = now - t->start;
        if (el >= pt) {
            t->q = true;
            el = pt;
        }
        t->et = el;
    }
}

static void tof(Tof *t, bool in, int32_t pt, int32_t now)
{
    if (in) {
        t->q = true;
        t->run = true;
        t->et = 0;
        return;
    }
    if (t->run) {
        t->run = false;
        t->start = now;
    }
    if (t->q) {
        int32_t el = now - t->start;
        if (el >= pt) {
            t->q = false;
            el = pt;
        }
        t->et = el;
    }
}

static void tp(Tp *t, bool in, int32_t pt, int32_t now)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
        t->q = true;
    }
    if (t->state == 1) {
        int32_t el = now - t->start;
        if (el >= pt) {
            t->q = false;
            t->state = 2;
            el = pt;
        }
        t->et = el;
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < 32767)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > -32768)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

typedef struct {
    bool run, jam, pusher, batch_done;
    Ton ton_jam;
    Tof tof_run;
    Tp tp_pusher;
    Ctu ctu_parts;
    Ctd ctd_batch;
} Zone;

static void zone(Zone *z, bool pe, bool upstream, bool reset, int32_t t_jam, int16_t batch, int32_t now)
{
    ton(&z->ton_jam, pe, t_jam, now);
    z->jam = z->ton_jam.q;

    tof(&z->tof_run, (pe || upstream) && !z->jam, 80, now);
    z->run = z->tof_run.q;

    ctu(&z->ctu_parts, pe, reset || z->ctu_parts.q, batch);
    tp(&z->tp_pusher, z->ctu_parts.q || z->jam, 40, now);
    z->pusher = z->tp_pusher.q;

    ctd(&z->ctd_batch, z->pusher, reset || z->batch_done, 4);
    z->batch_done = z->ctd_batch.q;
}

static Zone zones[440];
static int16_t phase[440];
static int16_t nscan;
static bool init;

void scan(void)
{
    int32_t now = (int32_t)(now_us / 1000);
    int32_t njam = 0, nrun = 0, npush = 0, nbatch = 0;
    int i;
    bool up;

    if (!init) {
        for (i = 0; i < 440; i++)
            phase[i] = (i * 17) % 90;
        init = true;
    }

    nscan++;
    if (nscan >= 1000)
        nscan = 0;

    up = nscan < 500;
    for (i = 0; i < 440; i++) {
        Zone *z = &zones[i];
        /* simulated photo eye: each zone has its own rhythm */
        phase[i]++;
        if (phase[i] >= 60 + i / 4)
            phase[i] = 0;
        zone(z, phase[i] < 25 + i / 16, up, nscan == i, 30, 3 + i % 5, now);
        up = z->run;
        if (z->jam)
            njam++;
        if (z->run)
            nrun++;
        if (z->pusher)
            npush++;
        if (z->batch_done)
            nbatch++;
    }
    check = (int32_t)((uint32_t)check * 31u + njam + nrun * 101 + npush * 211 + nbatch * 307);
}
