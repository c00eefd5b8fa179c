#include <stdbool.h>
#include "st.h"

#define COUNT 50

/* Times in milliseconds. */
struct ton { bool in, q; uint32_t start, et; };
struct tof { bool in, q; uint32_t start; };
struct tp { bool in, q; uint32_t start; };
struct ctu { bool cu, q; int16_t cv; };
struct ctd { bool cd; int16_t cv; };
struct ctud { bool cu, cd; int16_t cv; };

struct station {
    bool run, jam, horn, batch_done, idle;
    bool pec_in_old, pec_out_n_old;
    struct ton entry, jam_delay, idle_delay;
    struct tof run_on;
    struct tp horn_pulse;
    struct ctu batch;
    struct ctd left;
    struct ctud fill;
};

static bool init_done;
static uint32_t seed = 12345;
static struct station st[COUNT];
static bool pec[COUNT + 1];
static uint32_t jam_time[COUNT], run_on[COUNT];
static uint32_t now;

static bool ton(struct ton *t, bool in, uint32_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now;
        if (!t->q) {
            uint32_t et = now - t->start;
            t->q = et >= pt;
            t->et = t->q ? pt : et;
        }
    }
    t->in = in;
    return t->q;
}

static bool tof(struct tof *t, bool in, uint32_t pt)
{
    if (in) {
        t->q = true;
    } else {
        if (t->in)
            t->start = now;
        if (t->q && now - t->start >= pt)
            t->q = false;
    }
    t->in = in;
    return t->q;
}

static bool tp(struct tp *t, bool in, uint32_t pt)
{
    if (t->q) {
        if (now - t->start >= pt)
            t->q = false;
    } else if (in && !t->in) {
        t->start = now;
        t->q = true;
    }
    t->in = in;
    return t->q;
}

static bool ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    bool edge = cu && !c->cu;
    c->cu = cu;
    if (r)
        c->cv = 0;
    else if (edge && c->cv < INT16_MAX)
        c->cv++;
    return c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    bool edge = cd && !c->cd;
    c->cd = cd;
    if (ld)
        c->cv = pv;
    else if (edge && c->cv > INT16_MIN)
        c->cv--;
}

static void ctud(struct ctud *c, bool cu, bool cd, bool r)
{
    bool up = cu && !c->cu;
    bool down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r) {
        c->cv = 0;
    } else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
}

static void station(struct station *s, bool pec_in, bool pec_out, bool enable, bool ack,
                    uint32_t jam_time, uint32_t run_on, int16_t batch)
{
    bool came = pec_in && !s->pec_in_old;
    bool left = !pec_out && !s->pec_out_n_old;
    s->pec_in_old = pec_in;
    s->pec_out_n_old = !pec_out;

    bool entry = ton(&s->entry, pec_in, 3);
    bool jam = ton(&s->jam_delay, pec_out && enable, jam_time);
    if (ack)
        s->jam = false;
    else if (jam)
        s->jam = true;

    s->run = tof(&s->run_on, entry || pec_out, run_on) && enable && !s->jam;
    s->horn = tp(&s->horn_pulse, s->jam, 25);
    s->idle = ton(&s->idle_delay, !s->run, 50);

    s->batch_done = ctu(&s->batch, came, s->batch_done, batch);
    ctd(&s->left, s->batch_done, ack, 20);
    ctud(&s->fill, came, left, ack && s->jam);
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    now = (uint32_t)(now_us / 1000);
    if (!init_done) {
        for (int i = 0; i < COUNT; i++) {
            jam_time[i] = 20 + (uint32_t)(i + 1);
            run_on[i] = 5 + (uint32_t)((i + 1) % 13);
        }
        init_done = true;
    }

    for (int i = 0; i < 6; i++) {
        seed = seed * 1664525u + 1013904223u;
        uint32_t n = (seed >> 16) % 51;
        pec[n] = !pec[n];
    }
    bool ack = (seed >> 20) % 64 == 0;
    bool enable = (seed >> 22) % 32 != 0;

    int32_t running = 0, jams = 0, horns = 0, idles = 0, batches = 0, level = 0, entry_ms = 0;
    for (int i = 0; i < COUNT; i++) {
        struct station *s = &st[i];
        station(s, pec[i], pec[i + 1], enable, ack, jam_time[i], run_on[i],
                (int16_t)(3 + (i + 1) % 5));
        running += s->run;
        jams += s->jam;
        horns += s->horn;
        idles += s->idle;
        batches += s->left.cv;
        level += s->fill.cv;
        entry_ms += (int32_t)s->entry.et;
    }

    add(running);
    add(jams);
    add(horns);
    add(idles);
    add(batches);
    add(level);
    add(entry_ms);
}
