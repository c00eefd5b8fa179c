#include <stdbool.h>
#include "st.h"

/* A small timer library, microseconds. */
struct ton { bool q, in; uint64_t start, et; };
struct tof { bool q, in, run; uint64_t start, et; };
struct tp  { bool q, in; uint64_t start, et; };
struct ctu { bool q, cu; int16_t cv; };
struct ctud { bool qu, qd, cu, cd; int16_t cv; };

#define MS 1000u

static inline void ton(struct ton *t, bool in, uint64_t pt)
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

static inline void tof(struct tof *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
        t->run = false;
    } else {
        if (t->in) {
            t->start = now_us;
            t->run = true;
        }
        if (t->run) {
            t->et = now_us - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
                t->run = false;
            }
        }
    }
    t->in = in;
}

static inline void tp(struct tp *t, bool in, uint64_t pt)
{
    if (!t->q && in && !t->in) {
        t->q = true;
        t->start = now_us;
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

static inline void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctud(struct ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

struct wtg {
    bool run, trip, yaw_brake, pump;
    uint32_t status;
    struct ton wind, grid, vib;
    struct tof tpump;
    struct tp brake;
    struct ctu trips;
    struct ctud twist;
};

static struct wtg wtgs[72];
static uint32_t rnd = 0x9E3779B9u;
static int32_t n;

static inline void supervise(struct wtg *w, bool wind_ok, bool grid_ok, bool vibration, bool yaw_req, bool reset,
                             uint64_t base)
{
    ton(&w->wind, wind_ok, base);
    ton(&w->grid, grid_ok && !w->trip, base + 20 * MS);
    ton(&w->vib, vibration, 30 * MS);

    if (w->vib.q || w->trips.q)
        w->trip = true;
    else if (reset)
        w->trip = false;

    w->run = w->wind.q && w->grid.q && !w->trip;
    tof(&w->tpump, w->run, base);
    w->pump = w->tpump.q;
    tp(&w->brake, yaw_req, 50 * MS);
    w->yaw_brake = w->brake.q;
    ctu(&w->trips, w->vib.q, reset && wind_ok, 3);
    ctud(&w->twist, w->yaw_brake && wind_ok, w->yaw_brake && !wind_ok, reset && w->trip, false, 5);

    w->status = w->run | w->trip << 1 | w->yaw_brake << 2 | w->pump << 3 | w->twist.qu << 4 | w->twist.qd << 5
                | (w->wind.et > 40 * MS) << 6 | (w->tpump.et > 20 * MS) << 7 | (w->brake.et >= 30 * MS) << 8;
}

void scan(void)
{
    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;
    n++;
    int running = 0;
    uint32_t c = (uint32_t)check;
    for (int i = 0; i < 72; i++) {
        int32_t phase = (n + i * 7) % 101;
        supervise(&wtgs[i], phase > 12, phase != 40 && (rnd >> (i % 27) & 31) != 31,
                  phase > 70 && phase < 72 + i % 6, phase % 16 < 9, phase == 90, 10 * MS * (i % 9 + 2));
        if (wtgs[i].run)
            running++;
        c = c * 5 + wtgs[i].status;
    }
    check = (int32_t)(c + running);
}
