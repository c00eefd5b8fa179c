#include <stdbool.h>
#include "st.h"

static int32_t now_ms;

typedef struct { bool q, run; int32_t et, start; } Timer;
typedef struct { bool q, run, last; int32_t et, start; } Pulse;
typedef struct { bool q, last; int16_t cv; } Counter;
typedef struct { bool qu, qd, last_u, last_d; int16_t cv; } UpDown;
typedef struct { bool q, m; } Edge;

static void ton(Timer *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = t->run = false;
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

static void tof(Timer *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->q) return;
    if (!t->run) {
        t->run = true;
        t->start = now_ms;
    }
    t->et = now_ms - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = t->run = false;
    }
}

static void tp(Pulse *t, bool in, int32_t pt)
{
    if (!t->q && in && !t->last) {
        t->q = true;
        t->start = now_ms;
    }
    if (t->q) {
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in) t->et = 0;
    t->last = in;
}

static void ctu(Counter *c, bool cu, bool r, int16_t pv)
{
    if (r) c->cv = 0;
    else if (cu && !c->last && c->cv < 32767) c->cv++;
    c->last = cu;
    c->q = c->cv >= pv;
}

static void ctd(Counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld) c->cv = pv;
    else if (cd && !c->last && c->cv > -32768) c->cv--;
    c->last = cd;
    c->q = c->cv <= 0;
}

static void ctud(UpDown *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->last_u, down = cd && !c->last_d;
    c->last_u = cu;
    c->last_d = cd;
    if (r) c->cv = 0;
    else if (ld) c->cv = pv;
    else if (up && !down && c->cv < 32767) c->cv++;
    else if (down && !up && c->cv > -32768) c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static void r_trig(Edge *e, bool clk) { e->q = clk && !e->m; e->m = clk; }
static void f_trig(Edge *e, bool clk) { e->q = !clk && !e->m; e->m = !clk; }

static int32_t n;
static Timer tons[100], tofs[100];
static Pulse tps[100];
static Counter ctus[60], ctds[40];
static UpDown ctuds[40];
static Edge rts[30], fts[30];
static bool sig[100];
static int16_t phase[100], period[100], duty[100], preset[60];
static int32_t ptime[100];

void scan(void)
{
    now_ms = (int32_t)(now_us / 1000);

    if (n == 0) {
        for (int i = 0; i < 100; i++) {
            period[i] = 9 + (i * 7) % 41;
            duty[i] = 2 + (i * 5) % (period[i] - 4);
            phase[i] = i % period[i];
            ptime[i] = 20 + 5 * ((i * 3) % 37);
        }
        for (int i = 0; i < 60; i++) preset[i] = 2 + (i * 3) % 11;
    }

    for (int i = 0; i < 100; i++) {
        phase[i]++;
        if (phase[i] >= period[i]) phase[i] = 0;
        sig[i] = phase[i] < duty[i];
    }

    int32_t acc = 0;
    for (int i = 0; i < 100; i++) {
        ton(&tons[i], sig[i], ptime[i]);
        tof(&tofs[i], sig[99 - i], ptime[i]);
        tp(&tps[i], sig[i] && !tons[i].q, ptime[99 - i]);
        if (tons[i].q) acc += i + 1;
        if (tons[i].et >= 40) acc += 2;
        if (tofs[i].q) acc += 100 - i;
        if (tofs[i].et >= 30) acc += 3;
        if (tps[i].q) acc += i * 2 + 5;
        if (tps[i].et >= 50) acc += 7;
    }

    for (int i = 0; i < 60; i++) {
        ctu(&ctus[i], sig[i], sig[i + 40] && tps[i].q && tofs[i].q && i > 9, preset[i]);
        acc += ctus[i].cv;
        if (ctus[i].q) acc += 11;
    }
    for (int i = 0; i < 40; i++) {
        ctd(&ctds[i], sig[i + 50], ctds[i].q && tons[i].q, preset[i]);
        ctud(&ctuds[i], sig[i + 20], sig[i + 60], tons[i + 3].q && !sig[i + 5] && ctus[i].q,
             ctds[i].q && tps[i].q && tofs[i].q, preset[i + 20]);
        acc += ctds[i].cv * 2 + ctuds[i].cv * 3;
        if (ctds[i].q) acc += 13;
        if (ctuds[i].qu) acc += 17;
        if (ctuds[i].qd) acc += 19;
    }
    for (int i = 0; i < 30; i++) {
        r_trig(&rts[i], tofs[i].q);
        f_trig(&fts[i], sig[i + 30]);
        if (rts[i].q) acc += 23 + i;
        if (fts[i].q) acc += 29 + i;
    }

    n++;
    check = (check * 31 + acc) % 1000003;
}
