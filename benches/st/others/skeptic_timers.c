/* 63 conveyor stations with TON, TOF, TP, CTU, CTD, CTUD, R_TRIG and F_TRIG each, driven by pseudo-random sensors */
#include <stdbool.h>
#include "st.h"

#define MS(n) ((int64_t)(n) * 1000)

struct ton  { bool in, q; int64_t start, et; };
struct tof  { bool in, q; int64_t start, et; };
struct tp   { uint8_t state; bool q; int64_t start, et; };
struct ctu  { bool cu, q; int16_t cv; };
struct ctd  { bool cd, q; int16_t cv; };
struct ctud { bool cu, cd, qu, qd; int16_t cv; };

static inline bool rising(bool *m, bool clk)
{
    bool q = clk && !*m;
    *m = clk;
    return q;
}

static inline bool falling(bool *m, bool clk)
{
    bool q = !clk && !*m;
    *m = !clk;
    return q;
}

static void ton(struct ton *t, bool in, int64_t pt)
{
    if (!in) {
        t->in = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->in) {
        t->in = true;
        t->start = (int64_t)now_us;
    }
    if (!t->q) {
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(struct tof *t, bool in, int64_t pt)
{
    if (in) {
        t->in = t->q = true;
        t->et = 0;
        return;
    }
    if (t->in) {
        t->in = false;
        t->start = (int64_t)now_us;
    }
    if (t->q) {
        t->et = (int64_t)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
}

static void tp(struct tp *t, bool in, int64_t pt)
{
    switch (t->state) {
    case 0:
        if (in) {
            t->state = 1;
            t->q = true;
            t->start = (int64_t)now_us;
            t->et = 0;
        }
        return;
    case 1:
        t->et = (int64_t)now_us - t->start;
        if (t->et < pt)
            return;
        t->et = pt;
        t->q = false;
        t->state = 2;
        /* fall through */
    default:
        if (!in) {
            t->state = 0;
            t->et = 0;
        }
    }
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    bool up = rising(&c->cu, cu);
    if (r)
        c->cv = 0;
    else if (up && c->cv < INT16_MAX)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    bool down = rising(&c->cd, cd);
    if (ld)
        c->cv = pv;
    else if (down && c->cv > INT16_MIN)
        c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(struct ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = rising(&c->cu, cu), down = rising(&c->cd, cd);
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

struct station {
    bool run, part;
    struct ton start;
    struct tof stop;
    struct tp eject;
    struct ctu good;
    struct ctd left;
    struct ctud belt;
    bool rise, fall;
};

static int32_t station(struct station *s, bool jam, bool clear,
                       int64_t on_delay, int64_t off_delay, int64_t pulse, int16_t lot)
{
    bool rise = rising(&s->rise, s->part);
    bool fall = falling(&s->fall, s->run);

    ton(&s->start, s->run && !jam, on_delay);
    tof(&s->stop, s->start.q || s->part, off_delay);
    tp(&s->eject, rise && s->stop.q, pulse);
    ctu(&s->good, s->part && s->start.q, clear, lot);
    ctd(&s->left, s->eject.q, clear || s->good.q, lot);
    ctud(&s->belt, s->part, !s->part, clear, fall, lot);

    int32_t score = 0;
    if (s->good.q)
        score = 7;
    else if (s->start.et > MS(40))
        score = 11 + s->good.cv;
    else if (s->eject.q)
        score = 13;

    int16_t left = s->left.cv;
    switch (left) {
    case 0:
        score += 17;
        break;
    case 1: case 2: case 3:
        score += left * 5;
        break;
    default:
        if (s->left.q)
            score += 19;
        else
            score -= left;
    }
    if (s->belt.qu)
        score += s->belt.cv;
    else if (s->belt.qd)
        score += 23;
    if (s->stop.q && s->stop.et < MS(20))
        score += 29;
    return score;
}

static inline uint32_t next_random(uint32_t *s)
{
    uint32_t x = *s;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return *s = x;
}

static uint32_t seed = 0x1234ABCD;
static struct station st[63];

void scan(void)
{
    uint32_t sum = (uint32_t)check;
    for (int i = 0; i < 63; i++) {
        struct station *s = &st[i];
        uint32_t r = next_random(&seed);
        if ((r & 0x0000000F) == 0)
            s->run = !s->run;
        if ((r & 0x00000300) == 0)
            s->part = !s->part;
        int32_t score = station(s, (r & 0x0001F000) == 0, (r & 0x07E00000) == 0,
                                MS(20 + 10 * (i % 7)), MS(10 + 10 * (i % 5)),
                                MS(30 + 10 * (i % 3)), (int16_t)(3 + i % 6));
        sum = sum * 31 + (uint32_t)score;
    }
    check = (int32_t)sum;
}
