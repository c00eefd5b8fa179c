#include "st.h"
#include <stdbool.h>

#define STATIONS 64

struct ton { uint64_t start; int32_t et; bool in, q; };
struct tof { uint64_t start; bool in, q; };
struct tp  { uint64_t start; bool in, q; };
struct ctu { int16_t cv; bool cu, q; };
struct ctd { int16_t cv; bool cd, q; };
struct ctud { int16_t cv; bool cu, cd; };

struct station {
    struct ton jam_delay;
    struct tof run_on;
    struct tp stamp_out;
    struct ctu parts;
    struct ctd lot;
    struct ctud buffer;
    bool arrive_mem, leave_mem;
    int16_t edges;
    int16_t phase, period;
    int32_t preset;
};

static struct station stations[STATIONS];
static bool ready;
static int scans;

static void ton(struct ton *t, bool in, int32_t pt, uint64_t now)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now;
        uint64_t d = now - t->start;
        t->q = d >= (uint64_t)pt;
        t->et = t->q ? pt : (int32_t)d;
    }
    t->in = in;
}

static void tof(struct tof *t, bool in, int32_t pt, uint64_t now)
{
    if (in) {
        t->q = true;
    } else if (t->q) {
        if (t->in)
            t->start = now;
        t->q = now - t->start < (uint64_t)pt;
    }
    t->in = in;
}

static void tp(struct tp *t, bool in, int32_t pt, uint64_t now)
{
    if (t->q) {
        t->q = now - t->start < (uint64_t)pt;
    } else if (in && !t->in) {
        t->start = now;
        t->q = pt > 0;
    }
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

static void ctud(struct ctud *c, bool cu, bool cd, bool r)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    if (r)
        c->cv = 0;
    else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->cu = cu;
    c->cd = cd;
}

void scan(void)
{
    uint64_t now = now_us / 1000;

    if (!ready) {
        for (int i = 0; i < STATIONS; i++) {
            int n = i + 1;
            stations[i].period = (int16_t)(20 + n);
            stations[i].phase = (int16_t)(n / 2);
            stations[i].preset = 5 + 3 * (n / 4);
        }
        ready = true;
    }

    if (++scans >= 3000)
        scans = 0;
    bool reset = scans == 1;

    uint32_t sum = 0, jams = 0, motors = 0, stamps = 0, full = 0;
    for (int i = 0; i < STATIONS; i++) {
        struct station *s = &stations[i];
        if (++s->phase >= s->period)
            s->phase = 0;
        bool part = s->phase < s->period - 8;
        bool taken = s->phase > 30;

        bool arrive = part && !s->arrive_mem;
        s->arrive_mem = part;
        bool leave = !part && !s->leave_mem;
        s->leave_mem = !part;
        if (arrive || leave)
            s->edges = (int16_t)(s->edges + 1);

        ton(&s->jam_delay, part && !taken, s->preset, now);
        tof(&s->run_on, part, s->preset, now);
        tp(&s->stamp_out, arrive, 12, now);
        ctu(&s->parts, part, reset || s->parts.q, 25);
        ctd(&s->lot, leave, reset || s->lot.q, 40);
        ctud(&s->buffer, part, taken, reset);

        jams += s->jam_delay.q;
        motors += s->run_on.q && !s->jam_delay.q;
        stamps += s->stamp_out.q;
        full += s->lot.q || s->parts.q;
        sum += (uint32_t)s->jam_delay.et + (uint32_t)s->buffer.cv + (uint32_t)s->edges;
    }

    uint32_t c = (uint32_t)check;
    c = c * 31 + sum;
    c = c * 31 + jams;
    c = c * 31 + motors;
    c = c * 31 + stamps;
    c = c * 31 + full;
    check = (int32_t)c;
}
