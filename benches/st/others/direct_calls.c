/* 200 calls of blocks that call functions, and 500 calls of a function in a loop. */
#include <stdbool.h>
#include "st.h"

typedef struct { int32_t y, calls; } smoother_t;
typedef struct { int32_t y; bool done; int32_t pos; } ramp_t;

static smoother_t smooth[120];
static ramp_t ramps[76];
static ramp_t valve_a, valve_b;
static smoother_t level_a, level_b;
static int32_t signal = 5;

static inline int32_t max(int32_t a, int32_t b) { return a > b ? a : b; }
static inline int32_t min(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t limit(int32_t lo, int32_t x, int32_t hi) { return min(max(lo, x), hi); }

static int32_t blend(int32_t a, int32_t b, int32_t w)
{
    return (a * w + b * (16 - w)) / 16;
}

static int32_t scale(int32_t x, int32_t num, int32_t den)
{
    if (den == 0)
        return 0;
    return x * num / den;
}

static int32_t mix(int32_t a, int32_t b)
{
    int32_t t = a * 13 + b;
    if (t % 2 == 0)
        t += 7 * b;
    else
        t = max(t - b, b);
    return t % 65521;
}

static void smoother(smoother_t *s, int32_t x, int32_t weight)
{
    s->y = blend(s->y, x, weight);
    s->calls = min(s->calls + 1, 1000);
}

static void ramp(ramp_t *r, int32_t target, int32_t rate)
{
    r->pos += limit(-rate, target - r->pos, rate);
    r->y = scale(r->pos, 3, 4);
    r->done = r->pos == target;
}

void scan(void)
{
    signal = (signal * 75 + 74) % 65537;

    for (int i = 0; i < 120; i++) {
        smoother(&smooth[i], (signal + i * 97) % 10000, 4 + i % 9);
        check = (check * 31 + smooth[i].y + smooth[i].calls) % 1000003;
    }

    for (int i = 0; i < 76; i++) {
        ramp(&ramps[i], smooth[i].y, 50 + 5 * i);
        check = (check * 31 + ramps[i].y + ramps[i].done) % 1000003;
    }

    ramp(&valve_a, signal % 5000, 120);
    smoother(&level_a, valve_a.y, 11);
    ramp(&valve_b, level_a.y, 35);
    smoother(&level_b, valve_b.y, 7);
    check = (check * 31 + valve_a.y + level_a.y) % 1000003;
    check = (check * 31 + valve_b.y + level_b.y + valve_b.done) % 1000003;

    int32_t acc = signal;
    for (int i = 0; i < 500; i++)
        acc = mix(acc, i);
    check = (check * 31 + acc) % 1000003;
}
