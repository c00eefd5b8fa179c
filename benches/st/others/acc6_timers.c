#include <stdbool.h>
#include "st.h"

#define MS 1000

typedef struct { int64_t start, et; bool run, q; } timer_t_;
typedef struct { int64_t start, et; bool in, run, q; } pulse_t;
typedef struct { int16_t cv; bool edge, q; } count_t;
typedef struct { int16_t cv; bool cu, cd, qu, qd; } updown_t;

static timer_t_ tons[100], tofs[100];
static pulse_t tps[75];
static count_t ctus[75], ctds[75];
static updown_t ctuds[75];
static int32_t n;

static void ton(timer_t_ *t, bool in, int64_t pt)
{
    if (!in) {
        t->run = false;
        t->et = 0;
        t->q = false;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = (int64_t)now_us;
    }
    int64_t d = (int64_t)now_us - t->start;
    t->q = d >= pt;
    t->et = t->q ? pt : d;
}

/* run: was on, so that a falling edge starts the delay */
static void tof(timer_t_ *t, bool in, int64_t pt)
{
    if (in) {
        t->run = true;
        t->q = true;
        t->et = 0;
        t->start = -1;
        return;
    }
    if (!t->run)
        return;
    if (t->start < 0)
        t->start = (int64_t)now_us;
    int64_t d = (int64_t)now_us - t->start;
    if (d >= pt) {
        t->et = pt;
        t->q = false;
        t->run = false;
    } else {
        t->et = d;
    }
}

static void tp(pulse_t *t, bool in, int64_t pt)
{
    if (!t->run && in && !t->in) {
        t->run = true;
        t->q = true;
        t->start = (int64_t)now_us;
    }
    t->in = in;
    if (t->run) {
        int64_t d = (int64_t)now_us - t->start;
        if (d >= pt) {
            t->run = false;
            t->q = false;
            t->et = pt;
        } else {
            t->et = d;
        }
    }
    if (!t->run && !in)
        t->et = 0;
}

static void ctu(count_t *c, bool cu, bool r, int16_t pv)
{
    bool up = cu && !c->edge;
    c->edge = cu;
    if (r)
        c->cv = 0;
    else if (up && c->cv < INT16_MAX)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(count_t *c, bool cd, bool ld, int16_t pv)
{
    bool down = cd && !c->edge;
    c->edge = cd;
    if (ld)
        c->cv = pv;
    else if (down && c->cv > INT16_MIN)
        c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(updown_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
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

void scan(void)
{
    int32_t active = 0, late = 0, total = 0;

    n++;
    for (int i = 0; i < 100; i++) {
        ton(&tons[i], !tons[i].q && (n + i) % 64 != 0, 50 * MS + i * 5 * MS);
        active += tons[i].q;
        late += tons[i].et >= 100 * MS;
    }
    for (int i = 0; i < 100; i++) {
        tof(&tofs[i], tons[i].q, 30 * MS + i * 2 * MS);
        if (tofs[i].q)
            active += 2;
        late += tofs[i].et > 40 * MS;
    }
    for (int i = 0; i < 75; i++) {
        tp(&tps[i], tofs[i + 10].q, 70 * MS);
        if (tps[i].q)
            active += 3;
    }
    for (int i = 0; i < 75; i++) {
        ctu(&ctus[i], tps[i].q, ctus[i].q, 10);
        if (ctus[i].q)
            active += 5;
        total += ctus[i].cv;
    }
    for (int i = 0; i < 75; i++) {
        ctd(&ctds[i], tons[i].q, ctds[i].q, 8);
        if (ctds[i].q)
            active += 7;
        total += ctds[i].cv;
    }
    for (int i = 0; i < 75; i++) {
        ctud(&ctuds[i], tons[i + 20].q, tps[i].q, ctuds[i].qu, ctus[i].q, 15);
        if (ctuds[i].qd)
            active += 11;
        total += ctuds[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(active * 1000 + late * 10 + total + 1));
}
