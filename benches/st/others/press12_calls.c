/* 200 calls a scan of four kinds of blocks, with functions inside */
#include <stdbool.h>
#include "st.h"

#define COUNT 50

static inline float clampf(float x, float lo, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline float scale_raw(int16_t raw, float lo, float hi)
{
    return clampf(lo + (float)raw * (hi - lo) / 27648.0f, lo, hi);
}

static inline int32_t abs_diff(int32_t x, int32_t y)
{
    return x > y ? x - y : y - x;
}

static inline uint32_t mix(uint32_t h, int32_t x)
{
    return h * 31 + (uint32_t)x;
}

typedef struct { float y; bool done; } Ramp;
typedef struct { bool q; int32_t switches; } Hysteresis;
typedef struct { int16_t buffer[8]; int idx; int32_t total; int16_t avg; } MovingAverage;
typedef struct { int32_t total, last; bool full; } Totalizer;

static inline void ramp_run(Ramp *r, float target, float rate)
{
    r->y += clampf(target - r->y, -rate, rate);
    r->done = r->y == target;
}

static inline void hysteresis_run(Hysteresis *h, float x, float lo, float hi)
{
    if (h->q ? x < lo : x > hi) {
        h->q = !h->q;
        h->switches++;
    }
}

static inline void average_run(MovingAverage *m, int16_t x)
{
    m->total += x - m->buffer[m->idx];
    m->buffer[m->idx] = x;
    m->idx = (m->idx + 1) % 8;
    m->avg = m->total / 8;
}

static inline void totalizer_run(Totalizer *t, int32_t flow, bool enable, int32_t batch, uint32_t *grand)
{
    t->full = false;
    if (enable && abs_diff(flow, t->last) < 5000) {
        t->total += flow;
        *grand += flow;
    }
    t->last = flow;
    if (t->total >= batch) {
        t->total -= batch;
        t->full = true;
    }
}

static Ramp ramps[COUNT];
static Hysteresis hysts[COUNT];
static MovingAverage averages[COUNT];
static Totalizer totals[COUNT];
static uint32_t seed = 99, grand, full_count;

void scan(void)
{
    uint32_t hash = 0;
    for (int i = 0; i < COUNT; i++) {
        seed = seed * 1664525u + 1013904223u;
        int16_t raw = seed / 65536 % 27649;
        average_run(&averages[i], raw);
        float level = scale_raw(averages[i].avg, -50.0f, 150.0f);
        ramp_run(&ramps[i], level, 0.5f + (float)(i % 4));
        hysteresis_run(&hysts[i], ramps[i].y, 45.0f, 55.0f);
        totalizer_run(&totals[i], averages[i].avg, hysts[i].q || ramps[i].done, 200000 + i * 1000, &grand);
        if (totals[i].full)
            full_count++;
        hash = mix(hash, totals[i].total);
        hash = mix(hash, hysts[i].switches + (int32_t)(ramps[i].y * 10.0f));
    }
    check = (int32_t)(mix(hash, (int32_t)grand) + full_count);
}
