#include "st.h"
#include <stdbool.h>
#include <stdint.h>
#define STATIONS 100
#define MS 1000

typedef struct { bool in, q; uint64_t start, et; } tmr_t;
typedef struct { bool last, q; int cv; } ctr_t;
typedef struct {
    tmr_t settle, hold, valve;
    ctr_t parts, magazine;
    bool lot_done, empty;
} station_t;

static station_t stations[STATIONS];

static bool ton(tmr_t *t, bool in, uint64_t pt) {
    if (!in) { t->q = false; t->et = 0; }
    else {
        if (!t->in) t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) { t->et = pt; t->q = true; }
    }
    t->in = in;
    return t->q;
}
static bool tof(tmr_t *t, bool in, uint64_t pt) {
    if (in) { t->q = true; t->et = 0; }
    else {
        if (t->in) t->start = now_us;
        if (t->q) {
            t->et = now_us - t->start;
            if (t->et >= pt) { t->et = pt; t->q = false; }
        }
    }
    t->in = in;
    return t->q;
}
static bool tp(tmr_t *t, bool in, uint64_t pt) {
    if (!t->q && in && !t->in) { t->q = true; t->start = now_us; }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) { t->et = pt; t->q = false; }
    }
    if (!t->q && !in) t->et = 0;
    t->in = in;
    return t->q;
}
static bool ctu(ctr_t *c, bool cu, bool r, int pv) {
    if (r) c->cv = 0;
    else if (cu && !c->last && c->cv < 32767) c->cv++;
    c->last = cu;
    return c->q = c->cv >= pv;
}
static bool ctd(ctr_t *c, bool cd, bool ld, int pv) {
    if (ld) c->cv = pv;
    else if (cd && !c->last && c->cv > -32768) c->cv--;
    c->last = cd;
    return c->q = c->cv <= 0;
}

static int scans;
void scan(void) {
    scans++;
    int clamped = 0, blowing = 0, done = 0, emptied = 0;
    for (int i = 1; i <= STATIONS; i++) {
        station_t *s = &stations[i - 1];
        int phase = (scans + i) % (20 + i % 7);
        int lot = 3 + i % 5;
        bool settled = ton(&s->settle, phase < 10, 40 * MS);
        bool clamp = tof(&s->hold, settled, 60 * MS);
        bool blow = tp(&s->valve, clamp, 30 * MS);
        s->lot_done = ctu(&s->parts, blow, s->lot_done, lot);
        s->empty = ctd(&s->magazine, blow, s->empty, 2 * lot);
        clamped += clamp;
        blowing += blow;
        done += s->lot_done;
        emptied += s->empty;
    }
    check = (check * 3 + clamped + 2 * blowing + 5 * done + 11 * emptied) % 1000003;
}
