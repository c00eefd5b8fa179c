#include "st.h"
struct timer { uint8_t in, q, run; int64_t start; int32_t et; };
struct counter { uint8_t before, q; int16_t cv; };
static struct timer on[101], off[101], pulse[101];
static struct counter up[101], down[51];
static uint8_t edge[51];
static int32_t scans;
static void ton(struct timer *t, int in, int32_t pt)
{
    int64_t now = now_us / 1000;
    if (!in) {
        t->q = t->run = 0;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = 1;
        t->start = now;
    }
    int64_t et = now - t->start;
    t->q = et >= pt;
    t->et = t->q ? pt : et;
}
static void tof(struct timer *t, int in, int32_t pt)
{
    int64_t now = now_us / 1000;
    if (in) {
        t->q = t->in = 1;
        t->et = t->run = 0;
        return;
    }
    if (t->in) {
        t->run = 1;
        t->start = now;
        t->in = 0;
    }
    if (t->run) {
        int64_t et = now - t->start;
        if (et >= pt) {
            et = pt;
            t->q = t->run = 0;
        }
        t->et = et;
    }
}
static void tp(struct timer *t, int in, int32_t pt)
{
    int64_t now = now_us / 1000;
    if (in && !t->in && !t->q) {
        t->q = 1;
        t->start = now;
    }
    if (t->q) {
        int64_t et = now - t->start;
        if (et >= pt) {
            et = pt;
            t->q = 0;
        }
        t->et = et;
    } else if (!in)
        t->et = 0;
    t->in = in;
}
static void ctu(struct counter *c, int cu, int r, int pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->before && c->cv < 32767)
        c->cv++;
    c->before = cu;
    c->q = c->cv >= pv;
}
static void ctd(struct counter *c, int cd, int ld, int pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->before && c->cv > -32768)
        c->cv--;
    c->before = cd;
    c->q = c->cv <= 0;
}
void scan(void)
{
    int32_t n = 0;
    for (int i = 1; i <= 100; i++) {
        ton(&on[i], (scans + i) % 20 < 12, 50);
        tof(&off[i], on[i].q, 30);
        tp(&pulse[i], off[i].q, 100);
        ctu(&up[i], pulse[i].q, up[i].q, 7);
        if (up[i].q | pulse[i].q)
            n++;
        n += up[i].cv;
    }
    for (int i = 1; i <= 50; i++) {
        int rises = on[i].q && !edge[i];
        edge[i] = on[i].q;
        ctd(&down[i], rises, down[i].q, 5);
        n += down[i].cv;
    }
    check += n;
    scans++;
}
