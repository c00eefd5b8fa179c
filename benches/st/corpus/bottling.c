#include "st.h"
#include <stdbool.h>
#include <stdint.h>

typedef struct { int64_t start, et; bool q, run, mem; } timer;
typedef struct { int16_t cv; bool q, mem; } counter;
typedef struct { int16_t cv; bool qu, qd, mu, md; } updown;

static int64_t now;   /* ms */

static void ton(timer *t, bool in, int64_t pt)
{
    if (!in) {
        t->run = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    t->et = now - t->start;
    t->q = t->et >= pt;
    if (t->q)
        t->et = pt;
}

static void tof(timer *t, bool in, int64_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        t->mem = true;
        return;
    }
    if (t->mem) {
        t->mem = false;
        t->run = true;
        t->start = now;
    }
    if (t->run) {
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = t->run = false;
        }
    }
}

static void tp(timer *t, bool in, int64_t pt)
{
    if (in && !t->mem && !t->run && !t->q) {
        t->run = true;
        t->start = now;
    }
    t->mem = in;
    if (t->run) {
        t->et = now - t->start;
        t->q = true;
        if (t->et >= pt) {
            t->et = pt;
            t->q = t->run = false;
        }
    }
    if (!t->run && !in)
        t->et = 0;
}

static void ctu(counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->mem && c->cv < INT16_MAX)
        c->cv++;
    c->mem = cu;
    c->q = c->cv >= pv;
}

static void ctd(counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->mem && c->cv > INT16_MIN)
        c->cv--;
    c->mem = cd;
    c->q = c->cv <= 0;
}

static void ctud(updown *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->mu, down = cd && !c->md;
    c->mu = cu;
    c->md = cd;
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
    bool busy, fault, full, part_before, started;
    int made;
    timer dwell, jam;
    counter made_count, left;
} station;

typedef struct {
    station st[10];
    bool belt[11];
    int produced, faults;
} line;

static void run_station(station *s, bool part, bool jam, bool reset, int dwell)
{
    bool arrive = part && !s->part_before;
    s->part_before = part;
    ton(&s->dwell, part && !s->fault, dwell);
    tof(&s->jam, jam, 60);
    s->busy = part && !s->dwell.q;
    s->fault = s->jam.q && !s->busy;
    ctu(&s->made_count, s->dwell.q, reset, 20);
    ctd(&s->left, arrive, !s->started || (s->left.q && reset), 12);
    s->started = true;
    s->full = s->made_count.q || s->left.q;
    s->made = s->made_count.cv + s->left.cv;
}

static void run_line(line *l, bool infeed, bool stop, int nr)
{
    for (int i = 10; i > 0; i--)
        if (!l->st[i - 1].busy)
            l->belt[i] = l->belt[i - 1];
    l->belt[0] = infeed;
    l->produced = l->faults = 0;
    for (int i = 1; i <= 10; i++) {
        station *s = &l->st[i - 1];
        run_station(s, l->belt[i], stop && l->belt[i - 1], s->full && infeed, 5 * (2 * (i % 4) + nr));
        l->produced += s->made;
        l->faults += s->fault;
    }
}

static int32_t scans, seed = 7;
static bool infeed[10];
static line lines[10];
static timer lamp[40];
static updown magazine[5][8];
static timer tFill, tRinse, tCap, tLabel, tPack;
static timer dPump, dFan, dLight, dBelt;
static timer pHorn, pFlash, pEject, pMark;
static counter nCrates, nBottles, nLabels, nCaps;
static counter nGlue, nFilm, nInk;

void scan(void)
{
    now = now_us / 1000;
    scans++;
    for (int i = 0; i < 10; i++) {
        seed = (seed * 75 + 74) % 65537;
        infeed[i] = seed % 5 < 2 || (infeed[i] && seed % 7 > 1);
    }
    int32_t n = 0;
    for (int i = 0; i < 10; i++) {
        run_line(&lines[i], infeed[i], infeed[9 - i], i + 1);
        n += lines[i].produced + lines[i].faults * 2;
    }
    for (int i = 1; i <= 40; i++) {
        tp(&lamp[i - 1], infeed[i % 10] != (lines[(i - 1) / 4].faults > i % 3), 30 * (i % 6 + 1));
        if (lamp[i - 1].q)
            n += i;
    }
    for (int i = 1; i <= 5; i++)
        for (int j = 1; j <= 8; j++) {
            updown *m = &magazine[i - 1][j - 1];
            ctud(m, infeed[j - 1], lamp[i * 8 - j].q, false, m->qd && infeed[i - 1], 4 + j);
            n += m->cv + m->qu;
        }
    ton(&tFill, infeed[0], 40);
    ton(&tRinse, infeed[1], 70);
    ton(&tCap, infeed[2] && !tFill.q, 30);
    ton(&tLabel, tCap.q || infeed[8], 20);
    ton(&tPack, !infeed[3], 50);
    tof(&dPump, infeed[4], 90);
    tof(&dFan, tFill.q, 120);
    tof(&dLight, infeed[5] && infeed[6], 200);
    tof(&dBelt, tRinse.q, 80);
    tp(&pHorn, tPack.q, 110);
    tp(&pFlash, dPump.q && !dFan.q, 30);
    tp(&pEject, infeed[7], 40);
    tp(&pMark, tLabel.q, 20);
    ctu(&nCrates, pEject.q, nCrates.q, 30);
    ctu(&nBottles, tFill.q, pHorn.q, 100);
    ctu(&nLabels, pMark.q, scans % 300 == 0, 25);
    ctu(&nCaps, tCap.q && dPump.q, nCaps.q, 40);
    ctd(&nGlue, pMark.q, nGlue.q || scans == 1, 9);
    ctd(&nFilm, tPack.q, nFilm.q || scans == 1, 15);
    ctd(&nInk, dBelt.q, nInk.q || scans == 1, 21);
    if (tFill.q) n += 2;
    if (tRinse.q) n += 3;
    if (tCap.q) n += 4;
    if (tLabel.q) n += 5;
    if (tPack.q) n += 6;
    if (dPump.q) n += 7;
    if (dFan.q) n += 8;
    if (dLight.q) n += 9;
    if (dBelt.q) n += 10;
    if (pHorn.q) n += 11;
    if (pFlash.q) n += 12;
    if (pEject.q) n += 13;
    if (pMark.q) n += 14;
    n += nCrates.cv + nBottles.cv + nLabels.cv + nCaps.cv + nGlue.cv + nFilm.cv + nInk.cv;
    n += tFill.et + dLight.et + pHorn.et;
    check = (check * 5 + n) % 1000003;
}
