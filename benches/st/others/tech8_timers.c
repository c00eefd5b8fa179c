#include <stdbool.h>
#include "st.h"

#define N_TON 120
#define N_TOF 120
#define N_TP 100
#define N_CTU 60
#define N_CTD 50
#define N_CTUD 50
#define MS(x) ((uint64_t)(x) * 1000)

struct timer { uint64_t start, et; bool in, q, running; };
struct counter { int16_t cv; bool cu, cd, qu, qd; };

static struct timer on_delay[N_TON], off_delay[N_TOF], pulse[N_TP];
static struct counter up[N_CTU], down[N_CTD], updown[N_CTUD];
static uint64_t on_time[N_TON];
static int16_t phase[N_TON];
static bool sig[N_TON];
static bool initialised;

static void ton(struct timer *t, bool in, uint64_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = now_us;
        if (!t->q) {
            t->et = now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->in = in;
}

static void tof(struct timer *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in)
            t->start = now_us;
        if (t->q) {
            t->et = now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->in = in;
}

static void tp(struct timer *t, bool in, uint64_t pt)
{
    if (in && !t->in && !t->q) {
        t->start = now_us;
        t->q = true;
    }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static void ctu(struct counter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->qu = c->cv >= pv;
}

static void ctd(struct counter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->qd = c->cv <= 0;
}

static void ctud(struct counter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool u = cu && !c->cu, d = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (u && !d && c->cv < INT16_MAX)
        c->cv++;
    else if (d && !u && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < N_TON; i++) {
            on_time[i] = MS(7) * (i + 1);
            phase[i] = i + 1;
        }
    }
    for (int i = 0; i < N_TON; i++) {
        if (++phase[i] >= i + 6) {
            phase[i] = 0;
            sig[i] = !sig[i];
        }
    }

    int32_t active = 0, late = 0, total = 0;
    for (int i = 0; i < N_TON; i++) {
        ton(&on_delay[i], sig[i], on_time[i]);
        if (on_delay[i].q)
            active += i + 1;
        if (on_delay[i].et > MS(100))
            late++;
    }
    for (int i = 0; i < N_TOF; i++) {
        tof(&off_delay[i], sig[i], on_time[N_TOF - 1 - i]);
        if (off_delay[i].q)
            active += 2 * (i + 1);
    }
    for (int i = 0; i < N_TP; i++) {
        tp(&pulse[i], sig[i], MS(200));
        if (pulse[i].q)
            active += 3 * (i + 1);
        if (pulse[i].et >= MS(150))
            late += 2;
    }
    for (int i = 0; i < N_CTU; i++) {
        ctu(&up[i], on_delay[i].q, up[i].qu && pulse[i].q, i + 4);
        total += up[i].cv;
    }
    for (int i = 0; i < N_CTD; i++) {
        ctd(&down[i], pulse[i].q, down[i].qd && sig[i], 2 * (i + 1));
        total += down[i].cv;
        if (down[i].qd)
            active++;
    }
    for (int i = 0; i < N_CTUD; i++) {
        ctud(&updown[i], sig[i], off_delay[i + 1].q,
             updown[i].qu && sig[N_TON - 2 - i], updown[i].qd && sig[N_TON - 1 - i], 10);
        total += updown[i].cv;
        if (updown[i].qu || updown[i].qd)
            active += 5;
    }
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)(active + 1000 * late + 7 * total));
}
