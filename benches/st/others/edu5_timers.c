#include <stdbool.h>
#include "st.h"

typedef struct { uint64_t start; int64_t et; bool q, last; } Timer;
typedef struct { int16_t cv; bool q, qd, last_up, last_down; } Counter;

static Timer on[100], off[100], pulse[100];
static Counter up[100], down[50], both[50];

static void ton(Timer *t, bool in, int64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->last) t->start = now_us;
        t->et = (int64_t)(now_us - t->start);
        t->q = t->et >= pt;
        if (t->q) t->et = pt;
    }
    t->last = in;
}

static void tof(Timer *t, bool in, int64_t pt)
{
    if (in) {
        t->et = 0;
        t->q = true;
    } else if (t->q) {
        if (t->last) t->start = now_us;
        t->et = (int64_t)(now_us - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    t->last = in;
}

static void tp(Timer *t, bool in, int64_t pt)
{
    if (!t->q && in && !t->last) {
        t->q = true;
        t->start = now_us;
    }
    t->last = in;
    if (t->q) {
        t->et = (int64_t)(now_us - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in) t->et = 0;
}

static void ctu(Counter *c, bool cu, bool r, int16_t pv)
{
    if (r) c->cv = 0;
    else if (cu && !c->last_up && c->cv < INT16_MAX) c->cv++;
    c->last_up = cu;
    c->q = c->cv >= pv;
}

static void ctd(Counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld) c->cv = pv;
    else if (cd && !c->last_down && c->cv > INT16_MIN) c->cv--;
    c->last_down = cd;
    c->q = c->cv <= 0;
}

static void ctud(Counter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool u = cu && !c->last_up, d = cd && !c->last_down;
    c->last_up = cu;
    c->last_down = cd;
    if (r) c->cv = 0;
    else if (ld) c->cv = pv;
    else if (u && !d && c->cv < INT16_MAX) c->cv++;
    else if (d && !u && c->cv > INT16_MIN) c->cv--;
    c->q = c->cv >= pv;
    c->qd = c->cv <= 0;
}

void scan(void)
{
    int sum = 1;
    int64_t delay = 20000;
    for (int i = 0; i < 100; i++) {
        int n = i + 1;
        delay += 10000;
        ton(&on[i], !off[i].q, delay);
        tof(&off[i], on[i].q, 50000);
        tp(&pulse[i], on[i].q, delay);
        ctu(&up[i], off[i].q, up[i].q, 10);
        if (on[i].q) sum += n;
        if (on[i].et > 50000) sum += 1;
        if (off[i].q) sum += 2 * n;
        if (pulse[i].q) sum += 3 * n;
        sum += up[i].cv;
    }
    for (int i = 0; i < 50; i++) {
        ctd(&down[i], pulse[i].q, down[i].q, 20);
        ctud(&both[i], on[i].q, pulse[i + 50].q, both[i].q, down[i].q, 8);
        sum += down[i].cv + 5 * both[i].cv;
        if (both[i].qd) sum += i + 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
