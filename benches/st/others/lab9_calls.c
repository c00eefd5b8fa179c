/* Call overhead: 100 filters and 100 oscillators, each calling small functions. */
#include <stdbool.h>
#include "st.h"

#define N 100

typedef struct { int32_t y; bool high; int32_t acc, n; } filter_t;
typedef struct { int32_t y; int32_t s, c; } osc_t;

static int32_t seed = 74755;
static filter_t flt[N];
static osc_t osc[N];

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

static int32_t Clamp(int32_t x, int32_t lo, int32_t hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static int32_t Scale(int32_t x, int32_t num, int32_t den)
{
    return x * num / den;
}

static int32_t Mix3(int32_t a, int32_t b, int32_t c)
{
    return Clamp((a * 3 + b * 5 - c * 7) % 10007, -9000, 9000);
}

static void filter(filter_t *f, int32_t x, int32_t k)
{
    f->acc = f->acc + Clamp(x - f->acc, -k, k);
    f->y = Scale(f->acc, 75, 100);
    f->high = f->y > 500;
    if (f->high)
        f->n = f->n + 1;
}

static void oscillate(osc_t *o, bool kick, int32_t x)
{
    if (kick)
        o->s = Clamp(o->s + 16, -20000, 20000);
    o->s = o->s - Scale(o->c, 1, 16);
    o->c = Clamp(o->c + Scale(o->s, 1, 16), -20000, 20000);
    o->y = Mix3(o->s, o->c, x);
}

void scan(void)
{
    int32_t i, x, sum = 0;

    x = Rand() % 4000 - 1000;
    for (i = 0; i < N; i++) {
        filter(&flt[i], x, i + 20);
        oscillate(&osc[i], flt[i].high, flt[i].y);
        x = Clamp(x + Scale(osc[i].y, 1, 8), -3000, 3000);
        sum = sum + flt[i].y + osc[i].y * 3 + flt[i].n;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
