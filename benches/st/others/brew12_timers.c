/* 40 tanks with 12 timers and counters each, 20 conveyor sections with one. */
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define MS(x) ((uint64_t)(x) * 1000u)

/* --- timers and counters --- */
struct ton { bool q, in; uint64_t start, et; };
struct tof { bool q, in; uint64_t start, et; };
struct tp  { bool q, in; uint64_t start, et; };
struct ctu { bool q, cu; int16_t cv; };
struct ctd { bool q, cd; int16_t cv; };
struct ctud { bool qu, qd, cu, cd; int16_t cv; };

static inline bool ton(struct ton *t, bool in, uint64_t pt)
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
    return t->q;
}

static inline bool tof(struct tof *t, bool in, uint64_t pt)
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
    return t->q;
}

static inline bool tp(struct tp *t, bool in, uint64_t pt)
{
    if (in && !t->in && !t->q) {
        t->q = true;
        t->start = now_us;
    }
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (!in) {
        t->et = 0;
    }
    t->in = in;
    return t->q;
}

static inline bool ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
    return c->q;
}

static inline bool ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
    return c->q;
}

static inline void ctud(struct ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r) {
        c->cv = 0;
    } else if (ld) {
        c->cv = pv;
    } else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

/* --- plant --- */
struct tank {
    bool inlet, pump, agitator, alarm, cip_due;
    int16_t stock;
    struct ton high, dry, agit_on, agit_off;
    struct tof inlet_off, pump_off;
    struct tp dose, horn;
    struct ctu doses, fills;
    struct ctd batches;
    struct ctud stocks;
};

struct section {
    bool run, jam;
    struct ton jam_delay;
};

static struct tank tanks[40];
static struct section sections[20];
static uint32_t seed = 777, slow;
static int32_t scans;

static void tank_step(struct tank *t, bool level_high, bool demand, bool agitate, bool reset,
                      uint64_t base)
{
    ton(&t->high, level_high, base);
    t->inlet = tof(&t->inlet_off, !t->high.q && !t->alarm, MS(50));

    tof(&t->pump_off, demand && !t->alarm, MS(80));
    ton(&t->dry, t->pump_off.q && !level_high, MS(200));
    t->pump = t->pump_off.q && !t->dry.q;
    t->alarm = t->dry.q && !reset;
    tp(&t->horn, t->alarm, MS(1000));

    ton(&t->agit_off, agitate && !t->agit_on.q, base);
    ton(&t->agit_on, t->agit_off.q, MS(120));
    t->agitator = t->agit_off.q && !t->horn.q;

    tp(&t->dose, t->pump && demand, MS(70));
    ctu(&t->doses, t->dose.q, reset, 25);
    ctu(&t->fills, t->high.q, t->fills.q, 10);
    ctd(&t->batches, t->fills.q, t->batches.q || reset, 4);
    ctud(&t->stocks, t->inlet, t->dose.q, reset && t->alarm, t->doses.q, 15);
    t->stock = t->stocks.cv;
    t->cip_due = t->doses.q || t->batches.q || (t->stocks.qu && t->dry.et > MS(100));
}

static void section_step(struct section *s, bool enable, bool cell)
{
    s->jam = ton(&s->jam_delay, cell && enable, MS(40));
    s->run = enable && !s->jam;
}

void scan(void)
{
    scans++;
    seed = seed * 1664525u + 1013904223u;
    uint32_t in = seed;
    if (scans % 8 == 0)
        slow = (in << 13) | (in >> 19);

    uint32_t sum = 0;
    for (int i = 1; i <= 40; i++) {
        struct tank *t = &tanks[i - 1];
        int bit = i % 32;
        tank_step(t, (slow >> bit) & 1, (slow >> (31 - bit)) & 1, ((slow >> (bit / 4)) & 3) != 0,
                  ((in >> (bit / 2)) & 0x3F) == 0x3F, MS(10 * (2 + i % 5)));
        sum = sum * 3 + (uint32_t)t->stock + t->inlet + 2 * t->pump + 4 * t->agitator + 8 * t->cip_due;
    }

    bool enable = true;
    for (int i = 20; i >= 1; i--) {
        struct section *s = &sections[i - 1];
        section_step(s, enable || tanks[i - 1].pump, (slow >> i) & 1);
        enable = s->run;
        if (s->jam)
            sum += (uint32_t)i;
    }

    check = (int32_t)((uint32_t)check * 31u + sum);
}
