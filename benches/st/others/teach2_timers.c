/* Example 2: 50 stations with ten timers and counters each = 500 blocks. */
#include <stdbool.h>
#include "st.h"

#define STATIONS 50

struct ton { bool run, q; int32_t et; uint32_t start; };
struct tof { bool run, q, in; int32_t et; uint32_t start; };
struct tp  { bool run, q, in; int32_t et; uint32_t start; };
struct ctu { bool q, cu; int16_t cv; };
struct ctd { bool q, cd; int16_t cv; };

static uint32_t now_ms;

static void ton(struct ton *t, bool in, int32_t pt)
{
    if (!in) {
        t->run = false;
        t->q = false;
        t->et = 0;
    } else if (!t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(struct tof *t, bool in, int32_t pt)
{
    if (in) {
        t->run = false;
        t->q = true;
        t->et = 0;
    } else if (t->q) {
        if (t->in) {
            t->run = true;
            t->start = now_ms;
        }
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->run = false;
        }
    }
    t->in = in;
}

static void tp(struct tp *t, bool in, int32_t pt)
{
    if (!t->run && in && !t->in) {
        t->run = true;
        t->start = now_ms;
        t->q = true;
    }
    if (t->run) {
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->run = false;
            t->q = false;
        }
    }
    if (!t->run && !in)
        t->et = 0;
    t->in = in;
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

struct station {
    bool motor, valve, rejector, jam, tray_full;
    int16_t count, rejects;
    struct ton ton_debounce, ton_jam, ton_idle;
    struct tof tof_motor, tof_fan;
    struct tp tp_valve, tp_reject;
    struct ctu ctu_bottles, ctu_rejects;
    struct ctd ctd_tray;
};

static void station_run(struct station *s, bool enable, bool bottle, bool quality,
                        bool reset, int32_t t_fill, int16_t tray_count)
{
    /* entry */
    ton(&s->ton_debounce, bottle && enable, 5);
    ton(&s->ton_jam, bottle, 250);
    ton(&s->ton_idle, !bottle, 400);
    s->jam = s->ton_jam.q;

    /* drives */
    tof(&s->tof_motor, enable && !s->ton_idle.q && !s->jam, 120);
    tof(&s->tof_fan, s->tof_motor.q, 300);
    s->motor = s->tof_motor.q;

    /* filling and rejecting */
    tp(&s->tp_valve, s->ton_debounce.q && s->motor, t_fill);
    tp(&s->tp_reject, s->ton_debounce.q && !quality, 15);
    s->valve = s->tp_valve.q;
    s->rejector = s->tp_reject.q;

    /* counting */
    ctu(&s->ctu_bottles, s->valve, reset || s->ctu_bottles.q, 1000);
    ctu(&s->ctu_rejects, s->rejector, reset, 50);
    ctd(&s->ctd_tray, s->valve && !s->rejector, s->tray_full || reset, tray_count);
    s->tray_full = s->ctd_tray.q;
    s->count = s->ctu_bottles.cv;
    s->rejects = s->ctu_rejects.cv;
}

static struct station stations[STATIONS];
static int32_t cycle;

void scan(void)
{
    uint32_t c = (uint32_t)check;
    int16_t running = 0, jams = 0;

    now_ms = (uint32_t)(now_us / 1000);
    cycle++;
    if (cycle >= 1000000)
        cycle = 0;

    for (int i = 1; i <= STATIONS; i++) {
        struct station *s = &stations[i - 1];
        /* simulated inputs: every station has its own rhythm */
        int32_t phase = (cycle + i * 7) % (40 + i);
        station_run(s, cycle % 2000 > 20, phase < 18, (cycle + i) % 5 != 0,
                    cycle % 5000 == i, 12, 24);
        if (s->motor)
            running++;
        if (s->jam)
            jams++;
        c = c * 31u + (uint32_t)(s->count + s->rejects);
        if (s->valve)
            c += 1;
        if (s->tray_full)
            c += 3;
    }
    check = (int32_t)(c * 31u + (uint32_t)(running * 100 + jams));
}
