#include <stdbool.h>
#include "st.h"

#define MS(x) ((int64_t)(x) * 1000)

typedef struct { bool in, q; int64_t start, et; } ton_t;
typedef struct { bool in, q; int64_t start, et; } tof_t;
typedef struct { bool in, q; int64_t start, et; } tp_t;
typedef struct { bool cu, q; int16_t cv; } ctu_t;
typedef struct { bool cd, q; int16_t cv; } ctd_t;

static inline void ton(ton_t *t, bool in, int64_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = (int64_t)now_us;
        if (!t->q) {
            t->et = (int64_t)now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->in = in;
}

static inline void tof(tof_t *t, bool in, int64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in)
            t->start = (int64_t)now_us;
        if (t->q) {
            t->et = (int64_t)now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->in = in;
}

static inline void tp(tp_t *t, bool in, int64_t pt)
{
    if (t->q) {
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->in) {
        t->start = (int64_t)now_us;
        t->et = 0;
        t->q = pt > 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static inline void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

struct heater {
    ton_t on;
    tof_t hold;
    tp_t purge;
    ctu_t start;
    ctd_t life;
    bool heat, warning, due;
};

static struct heater heater[100];
static int32_t tick;

static inline void heater_run(struct heater *h, bool demand, bool service,
                              int64_t on_delay, int64_t hold, int64_t purge)
{
    ton(&h->on, demand, on_delay);
    tof(&h->hold, h->on.q, hold);
    tp(&h->purge, h->on.q, purge);
    h->heat = h->hold.q && !h->purge.q;
    h->warning = demand && !h->on.q && h->on.et >= MS(50);
    ctu(&h->start, h->heat, service, 20);
    ctd(&h->life, h->purge.q, service, 12);
    h->due = h->start.q || h->life.q;
}

void scan(void)
{
    int32_t sum = 0, on_cnt = 0;

    tick++;
    for (int32_t i = 0; i < 100; i++) {
        struct heater *h = &heater[i];
        int32_t phase = (tick + i * 7) % (60 + i);
        heater_run(h, phase < 40 + i / 4, (tick + i * 13) % 3001 == 0, MS(120), MS(170), MS(80));
        if (h->heat) {
            on_cnt++;
            sum += i;
        }
        if (h->warning)
            sum += 1000;
        if (h->due)
            sum += 3 * i;
        sum += h->start.cv * 5 - h->life.cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum * 101u + (uint32_t)on_cnt);
}
