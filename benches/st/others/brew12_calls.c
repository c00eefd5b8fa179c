/* 40 measuring channels, five small blocks each. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define CHANNELS 40

struct scale { float out; bool over; };
struct filter { float out; };
struct hyst { bool q; int32_t count; };
struct ramp { float out; bool ready; };
struct totalizer { int32_t total; float rest; };

struct channel {
    struct scale scale;
    struct filter filter;
    struct hyst hyst;
    struct ramp ramp;
    struct totalizer total;
};

static struct channel channels[CHANNELS];
static uint32_t seed = 4711;

static inline float clampf(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static inline float lerp(float x, float x0, float x1, float y0, float y1)
{
    return y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

static inline float plato(float sg)
{
    return ((135.997f * sg - 630.272f) * sg + 1111.14f) * sg - 616.868f;
}

static void scale_step(struct scale *s, int16_t raw, float low, float high)
{
    s->over = raw < 0 || raw > 27648;
    s->out = clampf(low, lerp((float)raw, 0.0f, 27648.0f, low, high), high);
}

static void filter_step(struct filter *f, float in, float k)
{
    f->out += clampf(0.0f, k, 1.0f) * (in - f->out);
}

static void hyst_step(struct hyst *h, float in, float on, float off)
{
    if (h->q) {
        h->q = in > off;
    } else if (in > on) {
        h->q = true;
        h->count++;
    }
}

static void ramp_step(struct ramp *r, float target, float step, bool hold)
{
    if (!hold)
        r->out += clampf(-step, target - r->out, step);
    r->ready = fabsf(target - r->out) < 0.01f;
}

static void totalizer_step(struct totalizer *t, float flow, bool enable)
{
    if (!enable)
        return;
    t->rest += flow;
    if (t->rest >= 1.0f) {
        int32_t whole = (int32_t)t->rest;
        t->total += whole;
        t->rest -= (float)whole;
    }
}

void scan(void)
{
    uint32_t sum = 0;
    for (int i = 0; i < CHANNELS; i++) {
        struct channel *c = &channels[i];
        seed = seed * 1664525u + 1013904223u;
        int16_t raw = (int16_t)((seed >> 16) % 28000u);

        scale_step(&c->scale, raw, 1.0f, 1.08f);
        filter_step(&c->filter, plato(c->scale.out), 0.05f + (float)(i + 1) * 0.01f);
        hyst_step(&c->hyst, c->filter.out, 10.5f, 9.0f);
        ramp_step(&c->ramp, c->hyst.q ? 80.0f : 20.0f, 1.5f, c->scale.over);
        totalizer_step(&c->total, c->ramp.out * 0.03f, !c->ramp.ready);

        sum = sum * 3u + (uint32_t)c->total.total + (uint32_t)c->hyst.count
            + (uint32_t)lrintf(c->filter.out * 1000.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
