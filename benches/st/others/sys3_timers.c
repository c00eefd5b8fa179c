#include "st.h"
#include <stdbool.h>

struct ton { bool in, q; int32_t pt, et; uint32_t start; bool run; };
struct tof { bool in, q; int32_t pt, et; uint32_t start; bool run; };
struct tp  { bool in, q; int32_t pt, et; uint32_t start; bool run, done; };
struct ctu { bool cu, r, q, m; int16_t pv, cv; };
struct ctd { bool cd, ld, q, m; int16_t pv, cv; };

static struct ton ton1[150];
static struct tof tof1[100];
static struct tp tp1[100];
static struct ctu ctu1[100];
static struct ctd ctd1[50];
static int32_t tick;

static void ton_call(struct ton *t, bool in, int32_t pt, uint32_t now)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->et = 0;
        t->run = false;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
        t->et = 0;
        t->q = false;
    }
    if (!t->q) {
        int32_t d = (int32_t)(now - t->start);
        if (d >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = d;
        }
    }
}

static void tof_call(struct tof *t, bool in, int32_t pt, uint32_t now)
{
    t->pt = pt;
    if (in) {
        t->q = true;
        t->et = 0;
        t->run = false;
    } else {
        if (t->in) {
            t->run = true;
            t->start = now;
        }
        if (t->run) {
            int32_t d = (int32_t)(now - t->start);
            if (d >= pt) {
                t->q = false;
                t->et = pt;
                t->run = false;
            } else {
                t->et = d;
            }
        }
    }
    t->in = in;
}

static void tp_call(struct tp *t, bool in, int32_t pt, uint32_t now)
{
    t->pt = pt;
    if (!t->run && !t->done && in) {
        t->run = true;
        t->start = now;
        t->q = true;
        t->et = 0;
    }
    if (t->run) {
        int32_t d = (int32_t)(now - t->start);
        if (d >= pt) {
            t->q = false;
            t->et = pt;
            t->run = false;
            t->done = true;
        } else {
            t->et = d;
        }
    }
    if (t->done && !in) {
        t->done = false;
        t->et = 0;
    }
    t->in = in;
}

static void ctu_call(struct ctu *c, bool cu, bool r, int16_t pv)
{
    c->r = r;
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->m && c->cv < INT16_MAX)
        c->cv++;
    c->m = cu;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static void ctd_call(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    c->ld = ld;
    c->pv = pv;
    if (ld)
        c->cv = pv;
    else if (cd && !c->m && c->cv > INT16_MIN)
        c->cv--;
    c->m = cd;
    c->cd = cd;
    c->q = c->cv <= 0;
}

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    int32_t sum = 0;

    tick++;
    if (tick > 100000)
        tick = 1;
    for (int32_t i = 0; i < 150; i++) {
        ton_call(&ton1[i], (tick + i) % 40 > 8, 3 * (i % 20), now);
        if (ton1[i].q)
            sum += 1;
        sum += ton1[i].et;
    }
    for (int32_t i = 0; i < 100; i++) {
        tof_call(&tof1[i], ton1[i].q, 25, now);
        if (tof1[i].q)
            sum += 2;
    }
    for (int32_t i = 0; i < 100; i++) {
        tp_call(&tp1[i], (tick + 3 * i) % 17 < 5, 10, now);
        if (tp1[i].q)
            sum += 3;
        sum += tp1[i].et;
    }
    for (int32_t i = 0; i < 100; i++) {
        ctu_call(&ctu1[i], tp1[i].q, ctu1[i].q, 12);
        sum += ctu1[i].cv;
    }
    for (int32_t i = 0; i < 50; i++) {
        ctd_call(&ctd1[i], tof1[i].q, ctd1[i].q, 7);
        sum += ctd1[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
