#include "st.h"
struct ton { int32_t pt, et; uint64_t start; uint8_t in, q; };
struct ctu { uint8_t cu, r, q, last; int16_t pv, cv; };
static struct ton t[200], f[100], p[100];
static struct ctu c[100];
static int32_t scans;
static void ton(struct ton *t)
{
    if (!t->in) { t->q = 0; t->et = 0; t->start = 0; return; }
    if (t->q) return;
    if (!t->start) t->start = now_us / 1000 + 1;
    t->et = (int32_t)(now_us / 1000 + 1 - t->start);
    if (t->et >= t->pt) { t->et = t->pt; t->q = 1; }
}
static void tof(struct ton *t)
{
    if (t->in) { t->q = 1; t->et = 0; t->start = 0; return; }
    if (!t->q) return;
    if (!t->start) t->start = now_us / 1000 + 1;
    t->et = (int32_t)(now_us / 1000 + 1 - t->start);
    if (t->et >= t->pt) { t->et = t->pt; t->q = 0; }
}
static uint8_t tp_last[100];
static void tp(struct ton *t, int i)
{
    if (!t->start && t->in && !tp_last[i]) { t->start = now_us / 1000 + 1; t->q = 1; }
    if (t->start) {
        if (t->q) {
            t->et = (int32_t)(now_us / 1000 + 1 - t->start);
            if (t->et >= t->pt) { t->et = t->pt; t->q = 0; }
        }
        if (!t->q && !t->in) { t->start = 0; t->et = 0; }
    }
    tp_last[i] = t->in;
}
static void ctu(struct ctu *c)
{
    if (c->r) c->cv = 0;
    else if (c->cu && !c->last && c->cv < 32767) c->cv++;
    c->last = c->cu;
    c->q = c->cv >= c->pv;
}
void scan(void)
{
    for (int i = 0; i < 200; i++) {
        t[i].in = (scans + i) % 100 < 60; t[i].pt = 200; ton(&t[i]);
        if (t[i].q) check++;
    }
    for (int i = 0; i < 100; i++) {
        f[i].in = t[i].q; f[i].pt = 150; tof(&f[i]);
        p[i].in = t[i + 100].q; p[i].pt = 70; tp(&p[i], i);
        c[i].cu = p[i].q; c[i].r = c[i].q; c[i].pv = 10; ctu(&c[i]);
        if (f[i].q && p[i].q) check += c[i].cv;
    }
    scans++;
}
