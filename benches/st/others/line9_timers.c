/* Fifty lanes of a sorter, each with debouncing, jam and starvation watchdogs and counters */
#include "st.h"
#include <stdbool.h>

typedef int64_t msec;

struct ton { msec start; bool run, q; };
struct tof { msec start; bool timing, q; };
struct tp { msec start; bool last, q; };
struct edge { bool last; };
struct ctu { int16_t cv; bool last, q; };
struct ctd { int16_t cv; bool last, q; };
struct ctud { int16_t cv; bool last_up, last_down, qu; };

static bool ton(struct ton *t, bool in, msec pt, msec now)
{
    if (!in) {
        t->run = t->q = false;
    } else {
        if (!t->run) {
            t->run = true;
            t->start = now;
        }
        t->q = now - t->start >= pt;
    }
    return t->q;
}

static bool tof(struct tof *t, bool in, msec pt, msec now)
{
    if (in) {
        t->q = true;
        t->timing = false;
    } else if (t->q) {
        if (!t->timing) {
            t->timing = true;
            t->start = now;
        }
        if (now - t->start >= pt)
            t->q = t->timing = false;
    }
    return t->q;
}

static bool tp(struct tp *t, bool in, msec pt, msec now)
{
    if (t->q) {
        if (now - t->start >= pt)
            t->q = false;
    } else if (in && !t->last) {
        t->q = pt > 0;
        t->start = now;
    }
    t->last = in;
    return t->q;
}

static bool rising(struct edge *e, bool clk)
{
    bool q = clk && !e->last;
    e->last = clk;
    return q;
}

/* starts with the memory of an idle (low) signal: a first call with low counts as a falling edge */
static bool falling(struct edge *e, bool clk)
{
    bool q = !clk && !e->last;
    e->last = !clk;
    return q;
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->last && c->cv < INT16_MAX)
        c->cv++;
    c->last = cu;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->last && c->cv > INT16_MIN)
        c->cv--;
    c->last = cd;
    c->q = c->cv <= 0;
}

static void ctud(struct ctud *c, bool cu, bool cd, bool r, int16_t pv)
{
    bool up = cu && !c->last_up, down = cd && !c->last_down;
    c->last_up = cu;
    c->last_down = cd;
    if (r)
        c->cv = 0;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
}

#define LANES 50

struct lane_param {
    msec debounce_on, debounce_off, jam_time, starve_time, eject_time;
    int16_t batch_size, order_size;
};

struct lane_sim { int16_t phase, period, duty; };

struct lane_status {
    bool occupied, jam, starved, eject;
    int16_t batch, remaining, buffered;
};

struct lane {
    struct ton on_delay, jam_timer, starve;
    struct tof off_delay;
    struct edge arrived, departed;
    struct ctu batch;
    struct ctd order;
    struct ctud buffer;
    struct tp eject_pulse;
};

static struct lane lanes[LANES];
static struct lane_param params[LANES];
static struct lane_sim sims[LANES];
static struct lane_status status[LANES];
static bool ready;
static int32_t scans;

static bool simulate_sensor(struct lane_sim *s)
{
    if (++s->phase >= s->period)
        s->phase = 0;
    return s->phase < s->duty;
}

static void lane_update(struct lane *l, const struct lane_param *p, struct lane_status *s,
                        bool sensor, bool running, bool reset, msec now)
{
    bool on = ton(&l->on_delay, sensor, p->debounce_on, now);
    bool occupied = tof(&l->off_delay, on, p->debounce_off, now);
    bool arrived = rising(&l->arrived, occupied);
    bool departed = falling(&l->departed, occupied);
    ctu(&l->batch, arrived, reset || l->batch.q, p->batch_size);
    ctd(&l->order, departed, reset || l->order.q, p->order_size);
    bool eject = tp(&l->eject_pulse, l->batch.q, p->eject_time, now);
    ctud(&l->buffer, arrived, eject, reset, 25);
    s->occupied = occupied;
    s->jam = ton(&l->jam_timer, running && occupied, p->jam_time, now);
    s->starved = ton(&l->starve, running && !occupied, p->starve_time, now) && !l->buffer.qu;
    s->eject = eject;
    s->batch = l->batch.cv;
    s->remaining = l->order.cv;
    s->buffered = l->buffer.cv;
}

static int32_t status_code(const struct lane_status *s)
{
    int32_t code = s->batch + s->remaining * 16 + s->buffered * 256;
    if (s->occupied) code += 10000;
    if (s->jam) code += 20000;
    if (s->starved) code += 40000;
    if (s->eject) code += 80000;
    return code;
}

static void init(void)
{
    for (int i = 0; i < LANES; i++) {
        int n = i + 1;
        params[i] = (struct lane_param){ 3, 5, 50, 80, 15, 3 + n % 4, 8 + n % 7 };
        if (n % 5 == 0) {
            params[i].debounce_on = 8;
            params[i].jam_time = 30;
        }
        sims[i].period = 20 + n * 3;
        sims[i].duty = 10 + n;
    }
    ready = true;
}

void scan(void)
{
    msec now = (msec)(now_us / 1000);
    if (!ready)
        init();
    scans = (int32_t)((uint32_t)scans + 1u);
    bool running = scans % 997 > 40;
    for (int i = 0; i < LANES; i++) {
        bool reset = (int32_t)((uint32_t)scans + (uint32_t)(i + 1) * 37u) % 2500 == 0;
        lane_update(&lanes[i], &params[i], &status[i], simulate_sensor(&sims[i]), running, reset, now);
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)status_code(&status[i]));
    }
}
