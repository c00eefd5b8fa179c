#include "st.h"
#include <math.h>
#include <stdbool.h>

#define CHANNELS 40

struct analog_input { float low, high, value; bool broken; };
struct low_pass { float weight, y; };
struct ramp { float max_step, y; bool done; };
struct monitor { uint32_t count; bool alarm, old; };
struct totalizer { uint32_t units; float part; };

static struct channel {
    struct analog_input input;
    struct low_pass filter;
    struct ramp ramp;
    struct monitor monitor;
    struct totalizer total;
} channels[CHANNELS];

static uint32_t seed = 4711;
static bool ready;

static float clamp(float low, float x, float high)
{
    return x < low ? low : x > high ? high : x;
}

static float blend(float old, float new, float weight) { return old + weight * (new - old); }

static float dead_band(float x, float width)
{
    return x > width ? x - width : x < -width ? x + width : 0.0f;
}

static uint32_t mix_hash(uint32_t value, uint32_t key) { return value * 33u + key; }

static void analog_input(struct analog_input *a, int16_t raw)
{
    a->broken = raw < 0;
    a->value = clamp(a->low, a->low + (a->high - a->low) * (float)raw / 27648.0f, a->high);
}

static void low_pass(struct low_pass *f, float x)
{
    f->y = blend(f->y, x, clamp(0.0f, f->weight, 1.0f));
}

static void ramp(struct ramp *r, float goal)
{
    float diff = dead_band(goal - r->y, 0.01f);
    r->y += clamp(-r->max_step, diff, r->max_step);
    r->done = diff == 0.0f;
}

static void monitor(struct monitor *m, float x, float high, float low)
{
    if (m->alarm)
        m->alarm = dead_band(x - (high + low) / 2.0f, (high - low) / 4.0f) != 0.0f;
    else
        m->alarm = x > high || x < low;
    if (m->alarm && !m->old)
        m->count = mix_hash(m->count, 1);
    m->old = m->alarm;
}

static void totalizer(struct totalizer *t, float flow, bool enable)
{
    if (!enable)
        return;
    t->part += clamp(0.0f, flow, 200.0f) * 0.01f;
    if (t->part >= 1.0f) {
        t->units = mix_hash(t->units, (uint32_t)(int32_t)t->part);
        t->part -= 1.0f;
    }
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < CHANNELS; i++) {
            channels[i].input.high = 100.0f + (float)i;
            channels[i].filter.weight = 0.05f + (float)i * 0.01f;
            channels[i].ramp.max_step = 0.5f + (float)(i % 5) * 0.25f;
        }
        ready = true;
    }

    float sum = 0.0f;
    uint32_t hash = 0;
    for (int i = 0; i < CHANNELS; i++) {
        struct channel *c = &channels[i];
        seed = seed * 1664525u + 1013904223u;
        analog_input(&c->input, (int16_t)((int)(seed / 131072u) - 2000));
        low_pass(&c->filter, c->input.value);
        ramp(&c->ramp, c->filter.y);
        monitor(&c->monitor, c->ramp.y, 60.0f, 45.0f);
        totalizer(&c->total, c->ramp.y, !c->input.broken);
        sum += c->ramp.y;
        if (c->ramp.done)
            hash = mix_hash(hash, 5);
        hash = mix_hash(hash, c->monitor.count + c->total.units);
    }
    uint32_t k = (uint32_t)check;
    k = k * 31 + (uint32_t)lrintf(sum * 100.0f);
    k = k * 31 + hash;
    check = (int32_t)k;
}
