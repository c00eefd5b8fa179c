#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

enum { CHANNELS = 50 };

enum level { NORMAL, WARNING, ALARM, TRIP };

struct config { int32_t gain, offset, ramp, high; };
struct filter { int32_t memory, value; };
struct ramp { int32_t value; bool done; };
struct supervisor { enum level level; int32_t events; bool latched; };
struct totalizer { int32_t total, rest; bool pulse; };

struct channel {
    struct config config;
    struct filter filter;
    struct ramp ramp;
    struct supervisor alarm;
    struct totalizer total;
};

static struct channel channels[CHANNELS];
static uint32_t seed = 12345;
static bool initialised;

static int32_t clamp(int32_t value, int32_t low, int32_t high)
{
    if (value < low)
        return low;
    return value > high ? high : value;
}

static int32_t scale(int32_t raw, int32_t gain, int32_t offset)
{
    return raw * gain / 1000 + offset;
}

static int32_t dead_band(int32_t value, int32_t width)
{
    if (abs(value) <= width)
        return 0;
    return value > 0 ? value - width : value + width;
}

static enum level level_of(int32_t value, int32_t high)
{
    if (value >= high + 200)
        return TRIP;
    if (value >= high + 100)
        return ALARM;
    if (value >= high)
        return WARNING;
    return NORMAL;
}

static void filter_run(struct filter *f, int32_t raw, int32_t gain, int32_t offset)
{
    f->memory += (scale(raw, gain, offset) * 16 - f->memory) / 4;
    f->value = clamp(f->memory / 16, -1000, 1000);
}

static void ramp_run(struct ramp *r, int32_t target, int32_t step)
{
    int32_t delta = dead_band(target - r->value, 3);
    r->value += clamp(delta, -step, step);
    r->done = delta == 0;
}

static void supervisor_run(struct supervisor *s, int32_t value, int32_t high, bool ack)
{
    enum level now = level_of(value, high);
    if (now != s->level)
        s->events++;
    if (now == TRIP)
        s->latched = true;
    else if (ack)
        s->latched = false;
    s->level = s->latched ? TRIP : now;
}

static void totalizer_run(struct totalizer *t, int32_t rate, bool enable)
{
    t->pulse = false;
    if (!enable)
        return;
    t->rest += dead_band(rate, 20);
    if (abs(t->rest) >= 5000) {
        t->total += t->rest / 5000;
        t->rest %= 5000;
        t->pulse = true;
    }
}

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < CHANNELS; i++)
            channels[i].config = (struct config){
                .gain = 800 + 10 * i,
                .offset = 5 * i - 100,
                .ramp = 5 + i % 20,
                .high = 300 + 8 * i,
            };
        initialised = true;
    }

    int32_t sum = 0;
    for (int i = 0; i < CHANNELS; i++) {
        struct channel *c = &channels[i];
        seed = seed * 1103515245u + 12345u;
        filter_run(&c->filter, (int32_t)seed / 1048576, c->config.gain, c->config.offset);
        ramp_run(&c->ramp, c->filter.value, c->config.ramp);
        supervisor_run(&c->alarm, c->filter.value, c->config.high, c->ramp.done);
        totalizer_run(&c->total, c->ramp.value, c->alarm.level != TRIP);
        sum += c->ramp.value + c->alarm.events + c->total.total;
        if (c->total.pulse)
            sum += 17;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
