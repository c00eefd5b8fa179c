#include "st.h"
#include <stdbool.h>
#include <stdint.h>
#define N 125
struct timer { bool in, q; uint64_t start, et; };
struct ctu { bool cu, q; int cv; };
struct ctud { bool cu, cd, qu, qd; int cv; };
static struct timer on_timer[N], off_timer[N];
static struct ctu up_count[N];
static struct ctud updn_count[N];
static uint64_t preset[N];
static int period[N];
static bool input[N];
static int scans;

static void ton(struct timer *t, bool in, uint64_t pt) {
    if (!in) { t->et = 0; t->q = false; }
    else {
        if (!t->in) t->start = now_us;
        t->et = now_us - t->start;
        if ((t->q = t->et >= pt)) t->et = pt;
    }
    t->in = in;
}
static void tof(struct timer *t, bool in, uint64_t pt) {
    if (in) { t->et = 0; t->q = true; }
    else if (t->q) {
        if (t->in) t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) { t->et = pt; t->q = false; }
    }
    t->in = in;
}
static void ctu(struct ctu *c, bool cu, bool r, int pv) {
    if (r) c->cv = 0;
    else if (cu && !c->cu && c->cv < 32767) c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}
static void ctud(struct ctud *c, bool cu, bool cd, bool r, bool ld, int pv) {
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r) c->cv = 0;
    else if (ld) c->cv = pv;
    else if (!(up && down)) {
        if (up && c->cv < 32767) c->cv++;
        else if (down && c->cv > -32768) c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}
void scan(void) {
    if (++scans == 1)
        for (int i = 0; i < N; i++) {
            preset[i] = 20000 + 10000 * (i % 13);
            period[i] = 8 + i % 37;
        }
    for (int i = 0; i < N; i++) input[i] = scans % period[i] < period[i] / 2;
    for (int i = 0; i < N; i++) {
        ton(&on_timer[i], input[i], preset[i]);
        tof(&off_timer[i], on_timer[i].q, preset[i]);
    }
    for (int i = 0; i < N; i++) {
        ctu(&up_count[i], on_timer[i].q, up_count[i].cv >= 30, 20);
        ctud(&updn_count[i], off_timer[i].q, up_count[i].q, false, updn_count[i].qu, 12);
    }
    int sum = 0;
    for (int i = 0; i < N; i++) {
        sum += (int)(on_timer[i].et / 1000) + (int)(off_timer[i].et / 1000) / 10;
        sum += up_count[i].cv + 2 * updn_count[i].cv;
    }
    check = (check + sum) % 999983;
}
