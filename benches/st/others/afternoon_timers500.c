#include "st.h"
#include <stdbool.h>
#include <stdint.h>
typedef struct { bool in, q; uint64_t start, et; } Timer;
typedef struct { bool c, q; int cv; } Counter;
static Timer ton1[100], tof1[100], tp1[100];
static Counter ctu1[100], ctd1[100];
static int scans;

static inline void ton(Timer *t, bool in, uint64_t pt) {
    if (!in) { t->q = false; t->et = 0; }
    else {
        if (!t->in) t->start = now_us;
        t->et = now_us - t->start;
        if (t->et > pt) t->et = pt;
        t->q = t->et >= pt;
    }
    t->in = in;
}
static inline void tof(Timer *t, bool in, uint64_t pt) {
    if (in) { t->q = true; t->et = 0; }
    else if (t->q) {
        if (t->in) t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) { t->et = pt; t->q = false; }
    }
    t->in = in;
}
static inline void tp(Timer *t, bool in, uint64_t pt) {
    if (in && !t->in && !t->q) { t->q = true; t->start = now_us; }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) { t->et = pt; t->q = false; }
    }
    if (!t->q && !in) t->et = 0;
    t->in = in;
}
static inline void ctu(Counter *c, bool cu, bool r, int pv) {
    if (r) c->cv = 0;
    else if (cu && !c->c && c->cv < 32767) c->cv++;
    c->c = cu;
    c->q = c->cv >= pv;
}
static inline void ctd(Counter *c, bool cd, bool ld, int pv) {
    if (ld) c->cv = pv;
    else if (cd && !c->c && c->cv > -32768) c->cv--;
    c->c = cd;
    c->q = c->cv <= 0;
}
void scan(void) {
    scans++;
    int sum = 0;
    for (int i = 0; i < 100; i++) {
        bool x = (scans + i) % 50 < 25;
        ton(&ton1[i], x, 100000);
        tof(&tof1[i], x, 150000);
        tp(&tp1[i], x, 80000);
        ctu(&ctu1[i], ton1[i].q, ctu1[i].q, 20);
        ctd(&ctd1[i], tp1[i].q, ctd1[i].q, 15);
        sum += ton1[i].q + 2 * tof1[i].q + 4 * tp1[i].q + ctu1[i].cv + ctd1[i].cv;
    }
    check = (check + sum) % 1000000;
}
