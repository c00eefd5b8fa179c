/* 500 timers and counters: 60 stations with five blocks each, 200 blocks in arrays */
#include "st.h"
#include <stdbool.h>

struct ton { uint32_t start; int32_t et; bool q, running; };
struct tof { uint32_t start; int32_t et; bool q, in_old; };
struct tp  { uint32_t start; int32_t et; bool q, active; };
struct ctu { int16_t cv; bool q, old; };
struct ctd { int16_t cv; bool q, old; };

static void ton(struct ton *t, bool in, int32_t pt, uint32_t now)
{
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now;
    }
    if (!t->q) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tof(struct tof *t, bool in, int32_t pt, uint32_t now)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in_old)
            t->start = now;
        if (t->q) {
            int32_t el = (int32_t)(now - t->start);
            if (el >= pt) {
                t->q = false;
                t->et = pt;
            } else {
                t->et = el;
            }
        }
    }
    t->in_old = in;
}

/* active: from the edge until the time is over and the input has dropped */
static void tp(struct tp *t, bool in, int32_t pt, uint32_t now)
{
    if (!t->active && in) {
        t->active = true;
        t->q = true;
        t->start = now;
    }
    if (t->q) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) {
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
    if (t->active && !t->q && !in) {
        t->active = false;
        t->et = 0;
    }
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

struct station {
    struct ton debounce;
    struct tof run_on;
    struct tp kick;
    struct ctu produced;
    struct ctd remaining;
    bool busy, batch_done;
    int32_t waited;
    int16_t parts;
};

static void station(struct station *s, bool part, bool done, bool reset,
                    int32_t t_on, int32_t t_off, int32_t t_pulse, int16_t batch, uint32_t now)
{
    ton(&s->debounce, part, t_on, now);
    tof(&s->run_on, s->debounce.q, t_off, now);
    tp(&s->kick, done && s->run_on.q, t_pulse, now);
    ctu(&s->produced, s->kick.q, reset || s->batch_done, batch);
    ctd(&s->remaining, s->kick.q, reset || s->remaining.q, batch);
    s->busy = s->run_on.q || s->kick.q;
    s->batch_done = s->produced.q;
    s->waited = s->debounce.et;
    s->parts = s->produced.cv - s->remaining.cv;
}

static struct station st[60];
static struct ton on_delay[70];
static struct tof off_delay[40];
static struct tp pulse[30];
static struct ctu up[30];
static struct ctd down[30];
static int16_t cyc;

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    int32_t n_busy = 0, n_q = 0, cv_sum = 0, et_sum = 0;
    int i;
    bool x;

    cyc = (cyc + 1) % 3000;

    for (i = 1; i <= 60; i++) {
        struct station *s = &st[i - 1];
        station(s, (cyc + i * 13) % 90 < 60, (cyc + i * 5) % 14 < 6, cyc == i * 40,
                30, 120, 15, 5 + i % 4, now);
        if (s->busy)
            n_busy++;
        et_sum += s->waited;
        cv_sum += s->parts;
    }

    for (i = 0; i < 70; i++) {
        ton(&on_delay[i], (cyc + i * 3) % 50 < 35, 10 + i, now);
        if (on_delay[i].q)
            n_q++;
        et_sum += on_delay[i].et;
    }

    for (i = 0; i < 40; i++) {
        x = on_delay[i].q && !on_delay[i + 20].q;
        tof(&off_delay[i], x, 25, now);
        if (off_delay[i].q)
            n_q++;
        et_sum += off_delay[i].et;
    }

    for (i = 0; i < 30; i++) {
        tp(&pulse[i], off_delay[i].q, 40, now);
        ctu(&up[i], pulse[i].q, up[i].cv >= 20, 12);
        ctd(&down[i], pulse[i].q, (cyc + i) % 200 == 0, 8);
        if (up[i].q)
            n_q++;
        if (down[i].q)
            n_q += 2;
        cv_sum += up[i].cv + down[i].cv;
        et_sum += pulse[i].et;
    }

    check = (check + n_busy * 3 + n_q * 7 + cv_sum * 11 + et_sum) % 10000019;
}
