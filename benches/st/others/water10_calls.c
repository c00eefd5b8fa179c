#include <math.h>
#include <stdbool.h>
#include "st.h"

#define POINTS 100

enum quality { GOOD, UNCERTAIN, BAD };
struct range { int16_t raw_lo, raw_hi; float eng_lo, eng_hi; };
struct point { float value, sent; enum quality quality; int16_t events; };
struct total { int32_t pulses; float velocity, rest; bool burst; };

static const struct range ranges[4] = {
    { 0, 27648, 0.0f, 250.0f },
    { 4000, 20000, 0.0f, 180.0f },
    { 0, 4095, 10.0f, 90.0f },
    { -16000, 16000, -50.0f, 50.0f },
};
static uint32_t rnd = 2024;
static int16_t raw[POINTS];
static struct point point[POINTS];
static struct total total[POINTS];

static float scale_analog(int16_t r, const struct range *g)
{
    return g->eng_lo + (float)(int16_t)(r - g->raw_lo) * (g->eng_hi - g->eng_lo)
           / (float)(int16_t)(g->raw_hi - g->raw_lo);
}

static enum quality rate_quality(int16_t r, const struct range *g)
{
    int16_t margin = (int16_t)((int16_t)(g->raw_hi - g->raw_lo) / 16);
    if (r < g->raw_lo || r > g->raw_hi)
        return BAD;
    if (r < (int16_t)(g->raw_lo + margin) || r > (int16_t)(g->raw_hi - margin))
        return UNCERTAIN;
    return GOOD;
}

static bool dead_band(float v, float old, float band) { return fabsf(v - old) > band; }

static float pipe_velocity(float flow, float dn) { return flow / 3600.0f / (0.785398f * dn * dn); }

static void analog_point(struct point *p, int16_t r, const struct range *g)
{
    p->quality = rate_quality(r, g);
    if (p->quality != BAD)
        p->value += 0.3f * (scale_analog(r, g) - p->value);
    if (dead_band(p->value, p->sent, 0.5f)) {
        p->sent = p->value;
        p->events = (int16_t)(p->events + 1);
    }
}

static void flow_total(struct total *t, float flow, float dn, bool valid)
{
    t->velocity = pipe_velocity(flow, dn);
    t->burst = valid && t->velocity > 2.5f;
    if (valid) {
        t->rest += flow * 0.01f;
        while (t->rest >= 1.0f) {
            t->rest -= 1.0f;
            t->pulses = (int32_t)((uint32_t)t->pulses + 1u);
        }
    }
}

static inline void add(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    for (int i = 0; i < POINTS; i++) {
        rnd = rnd * 1664525u + 1013904223u;
        int v = raw[i] + (int)(rnd >> 22) - 511;
        if (v < 22000 && v > -3000)
            raw[i] = (int16_t)v;
    }

    uint32_t sum = 0, bursts = 0;
    for (int i = 0; i < POINTS; i++) {
        struct point *p = &point[i];
        struct total *t = &total[i];
        analog_point(p, raw[i], &ranges[i % 4]);
        flow_total(t, p->value, 0.1f + 0.002f * (float)i, p->quality == GOOD);
        switch (p->quality) {
        case GOOD: sum += 1; break;
        case UNCERTAIN: sum += 200; break;
        case BAD: sum += 40000; break;
        }
        if (t->burst)
            bursts++;
        add((uint32_t)t->pulses + (uint32_t)p->events + (uint32_t)(int32_t)lrintf(t->velocity * 1000.0f));
    }
    add(sum + bursts);
}
