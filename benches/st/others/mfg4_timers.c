#include <stdbool.h>
#include "st.h"

typedef struct { uint64_t start; int64_t et; bool in, q; } Timer;
typedef struct { int16_t cv; bool q, edge; } Counter;
typedef struct { int16_t cv; bool qu, qd, up, down; } UpDown;

static void ton(Timer *t, bool in, int64_t pt)
{
    if (!in) {
        t->et = 0;
        t->q = false;
    } else if (!t->in) {
        t->start = now_us;
        t->et = 0;
        t->q = pt <= 0;
    } else if (!t->q) {
        t->et = (int64_t)(now_us - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
    t->in = in;
}

static void tof(Timer *t, bool in, int64_t pt)
{
    if (in) {
        t->q = true;
    } else if (t->in) {
        t->start = now_us;
    } else if (t->q && (int64_t)(now_us - t->start) >= pt) {
        t->q = false;
    }
    t->in = in;
}

static void tp(Timer *t, bool in, int64_t pt)
{
    if (t->q) {
        if ((int64_t)(now_us - t->start) >= pt)
            t->q = false;
    } else if (in && !t->in) {
        t->start = now_us;
        t->q = true;
    }
    t->in = in;
}

static void ctu(Counter *c, bool cu, bool r, int16_t pv)
{
    bool e = cu && !c->edge;
    c->edge = cu;
    if (r)
        c->cv = 0;
    else if (e && c->cv < INT16_MAX)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(Counter *c, bool cd, bool ld, int16_t pv)
{
    bool e = cd && !c->edge;
    c->edge = cd;
    if (ld)
        c->cv = pv;
    else if (e && c->cv > INT16_MIN)
        c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(UpDown *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->up, down = cd && !c->down;
    c->up = cu;
    c->down = cd;
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

typedef struct {
    int64_t delay, fill, drip, watch, blow;
    int16_t batch, period, on;
} Config;

typedef struct {
    Timer delay, fill, drip, watch, motor, blow, reject;
    Counter batch, caps;
    UpDown buffer;
    int16_t pos;
    bool done_old, watch_old;
} Station;

typedef struct {
    int32_t tick;
    uint32_t produced, rejected, alarms, wait;
    int64_t sum;
} Line;

static Line line;
static Station stations[50];
static Config configs[50];
static bool initialised;

static void station(Station *s, const Config *cfg, int phase)
{
    if (++s->pos >= cfg->period)
        s->pos = 0;
    bool bottle = s->pos < cfg->on;

    ton(&s->delay, bottle, cfg->delay);
    ton(&s->fill, s->delay.q, cfg->fill);
    bool valve = s->delay.q && !s->fill.q;
    tof(&s->drip, valve, cfg->drip);
    bool done = s->fill.q && !s->drip.q;

    ton(&s->watch, bottle && !done, cfg->watch);
    tof(&s->motor, !bottle || done, 70000);
    tp(&s->blow, done, cfg->blow);
    tp(&s->reject, s->watch.q, 40000);

    bool clear = line.tick % 512 == phase;
    bool out = s->blow.q && s->motor.q;
    ctu(&s->batch, done, clear || s->batch.q, cfg->batch);
    ctd(&s->caps, done || s->watch.q, s->caps.q || clear, 25);
    ctud(&s->buffer, done, out, clear, false, 8);

    if (done && !s->done_old)
        line.produced++;
    s->done_old = done;
    if (s->watch.q && !s->watch_old)
        line.alarms++;
    s->watch_old = s->watch.q;
    if (s->reject.q)
        line.rejected++;
    if (s->batch.q || s->buffer.qu)
        line.wait += 3;
    if (s->motor.q)
        line.wait += (uint32_t)s->buffer.cv;
    line.sum += s->watch.et;
}

static void init(void)
{
    for (int i = 0; i < 50; i++) {
        Config *c = &configs[i];
        c->delay = 20000 + 10000 * (i % 4);
        c->fill = 80000 + 10000 * (i % 9);
        c->drip = 30000 + 5000 * (i % 3);
        c->watch = 180000 + 10000 * (i % 5);
        c->blow = 50000 + 10000 * (i % 7);
        c->batch = (int16_t)(6 + i % 11);
        c->period = (int16_t)(40 + i % 13);
        c->on = (int16_t)(24 + i % 7);
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        init();
    }
    line.tick++;
    line.sum = 0;
    for (int i = 0; i < 50; i++)
        station(&stations[i], &configs[i], i * 7);
    check = (int32_t)((uint32_t)check * 31u + line.produced + line.rejected * 3u + line.alarms * 5u + line.wait
                      + (uint32_t)(line.sum / 1000) + 1u);
}
