/* 80 machines with five timers and counters each, 50 feeders with two: 500 */
#include <stdbool.h>
#include "st.h"

#define MS 1000u

struct timer { uint64_t start, elapsed; bool in, q; };
struct counter { int16_t cv; bool up, down; };

static inline bool on_delay(struct timer *t, bool in, uint64_t preset)
{
    if (!in) {
        t->elapsed = 0;
        t->q = false;
    } else {
        if (!t->in)
            t->start = now_us;
        t->elapsed = now_us - t->start;
        t->q = t->elapsed >= preset;
        if (t->q)
            t->elapsed = preset;
    }
    t->in = in;
    return t->q;
}

static inline bool off_delay(struct timer *t, bool in, uint64_t preset)
{
    if (in) {
        t->q = true;
    } else {
        if (t->in)
            t->start = now_us;
        if (t->q && now_us - t->start >= preset)
            t->q = false;
    }
    t->in = in;
    return t->q;
}

static inline bool pulse(struct timer *t, bool in, uint64_t preset)
{
    if (t->q) {
        t->q = now_us - t->start < preset;
    } else if (in && !t->in) {
        t->start = now_us;
        t->q = true;
    }
    t->in = in;
    return t->q;
}

struct machine {
    struct timer start_delay, run_on, ejector;
    struct counter parts, stock;
    bool running, full, alarm;
};

struct feeder {
    struct timer debounce;
    struct counter batch;
    bool empty;
};

static void machine_run(struct machine *m, bool sensor, bool reset, uint64_t delay)
{
    bool started = on_delay(&m->start_delay, sensor, delay);
    m->running = off_delay(&m->run_on, started, 60 * MS);
    bool eject = pulse(&m->ejector, m->running && !sensor, 30 * MS);

    struct counter *c = &m->parts;
    if (reset)
        c->cv = 0;
    else if (eject && !c->up && c->cv < INT16_MAX)
        c->cv++;
    c->up = eject;

    struct counter *s = &m->stock;
    bool up = sensor && !s->up, down = eject && !s->down;
    s->up = sensor;
    s->down = eject;
    if (reset)
        s->cv = 0;
    else if (up && !down && s->cv < INT16_MAX)
        s->cv++;
    else if (down && !up && s->cv > INT16_MIN)
        s->cv--;

    m->full = c->cv >= 12 || s->cv >= 5;
    m->alarm = m->start_delay.elapsed > 40 * MS && s->cv <= 0;
}

static void feeder_run(struct feeder *f, bool photocell, int16_t size)
{
    bool part = on_delay(&f->debounce, photocell, 20 * MS);
    struct counter *b = &f->batch;
    if (f->empty)
        b->cv = size;
    else if (part && !b->down && b->cv > INT16_MIN)
        b->cv--;
    b->down = part;
    f->empty = b->cv <= 0;
}

static struct machine machines[80];
static struct feeder feeders[50];
static uint64_t delays[80];
static int16_t phases[80];
static int16_t tick;
static bool ready;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 80; i++) {
            delays[i] = (20 + 10 * (unsigned)(i % 6)) * MS;
            phases[i] = (int16_t)(i % 23);
        }
        ready = true;
    }
    if (++tick >= 700)
        tick = 0;

    uint32_t sum = 0;
    for (int i = 0; i < 80; i++) {
        struct machine *m = &machines[i];
        if (++phases[i] >= 23 + i / 4)
            phases[i] = 0;
        machine_run(m, phases[i] < 11, tick == i, delays[i]);
        if (m->running)
            sum += (uint32_t)i;
        if (m->full)
            sum += 1000;
        if (m->alarm)
            sum += 100000;
        sum += (uint32_t)m->parts.cv;
    }
    for (int i = 0; i < 50; i++) {
        int16_t phase = phases[i + 20];
        feeder_run(&feeders[i], phase >= 4 && phase < 9, (int16_t)(3 + i / 10));
        sum = sum * 3 + (uint32_t)feeders[i].batch.cv;
        if (feeders[i].empty)
            sum += 7;
    }
    check = (int32_t)((uint32_t)check * 31u + sum + 1u);
}
