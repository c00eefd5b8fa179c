#include "st.h"
#include <stdbool.h>

enum { MODULES = 50 };

/* All times in microseconds. */
struct ton { uint64_t start; uint64_t et; bool running, q; };
struct tof { uint64_t start; uint64_t et; bool running, q; };
struct tp  { uint64_t start; uint64_t et; bool in, q; };
struct ctu { int16_t cv; bool mem, q; };
struct ctd { int16_t cv; bool mem, q; };
struct ctud { int16_t cv; bool up_mem, down_mem, qu, qd; };

struct timing { uint64_t start_up, feed, push, coast, stall, dwell, hold; };

struct module {
    struct ton start_up, feed, stall, dwell;
    struct tof coast, hold;
    struct tp push;
    struct ctu batch;
    struct ctd remaining;
    struct ctud buffer;
    struct timing timing;
};

static struct module modules[MODULES];
static bool ready;
static int32_t scan_no;

static void ton_run(struct ton *t, bool in, uint64_t pt)
{
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now_us;
    }
    uint64_t elapsed = now_us - t->start;
    t->q = elapsed >= pt;
    t->et = t->q ? pt : elapsed;
}

static void tof_run(struct tof *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->running = false;
        t->et = 0;
        return;
    }
    if (!t->q)
        return;
    if (!t->running) {
        t->running = true;
        t->start = now_us;
    }
    uint64_t elapsed = now_us - t->start;
    t->q = elapsed < pt;
    t->et = t->q ? elapsed : pt;
}

static void tp_run(struct tp *t, bool in, uint64_t pt)
{
    if (in && !t->in && !t->q && t->et == 0) {
        t->q = true;
        t->start = now_us;
    }
    t->in = in;
    if (t->q) {
        uint64_t elapsed = now_us - t->start;
        t->q = elapsed < pt;
        t->et = t->q ? elapsed : pt;
    }
    if (!t->q && !in)
        t->et = 0;
}

static void ctu_run(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->mem && c->cv < INT16_MAX)
        c->cv++;
    c->mem = cu;
    c->q = c->cv >= pv;
}

static void ctd_run(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->mem && c->cv > INT16_MIN)
        c->cv--;
    c->mem = cd;
    c->q = c->cv <= 0;
}

static void ctud_run(struct ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->up_mem;
    bool down = cd && !c->down_mem;
    c->up_mem = cu;
    c->down_mem = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static void module_run(struct module *m, bool run, bool part, bool clear)
{
    const struct timing *t = &m->timing;
    ton_run(&m->start_up, run, t->start_up);
    ton_run(&m->feed, m->start_up.q && !m->feed.q, t->feed);
    tp_run(&m->push, m->feed.q, t->push);
    tof_run(&m->coast, m->start_up.q, t->coast);
    ton_run(&m->stall, m->coast.q && !m->push.q, t->stall);
    ton_run(&m->dwell, m->push.q && part, t->dwell);
    tof_run(&m->hold, m->stall.q || m->dwell.q, t->hold);
    ctu_run(&m->batch, m->push.q, m->batch.q, 5);
    ctd_run(&m->remaining, m->dwell.q, m->remaining.q, 8);
    ctud_run(&m->buffer, m->dwell.q, m->hold.q, clear, m->remaining.q, 10);
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < MODULES; i++) {
            modules[i].timing = (struct timing){
                .start_up = 20000,
                .feed = 10000 * (2 + i % 5),
                .push = 10000 * (3 + i % 7),
                .coast = 50000,
                .stall = 15000 * (1 + i % 4),
                .dwell = 20000,
                .hold = 5000 * (4 + i % 9),
            };
        }
        ready = true;
    }

    int32_t sum = 0;
    uint64_t total = 0;
    for (int i = 0; i < MODULES; i++) {
        struct module *m = &modules[i];
        module_run(m, (scan_no + 7 * i) % 97 < 70, (scan_no + 3 * i) % 13 < 8,
                   (scan_no + i) % 301 == 0);
        sum += m->batch.cv + m->remaining.cv + 16 * m->buffer.cv;
        if (m->hold.q || m->push.q)
            sum += 1000;
        if (m->buffer.qu && !m->buffer.qd)
            sum += i;
        total += m->stall.et + m->hold.et + m->push.et;
    }
    scan_no++;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(total / 1000));
}
