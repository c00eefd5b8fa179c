/* 200 calls of a function block that itself calls small functions and an inner block. */
#include <stdbool.h>
#include "st.h"

typedef struct { int32_t x, k, y; } low_pass;
typedef struct {
    int32_t raw, gain;
    int32_t value;
    int16_t cls;
    bool alarm;
    low_pass lp;
    int32_t hi, cnt;
} channel;

static channel ch[200];
static int32_t cyc;

static int32_t scale(int32_t raw, int32_t gain, int32_t offs)
{
    return raw * gain / 64 + offs;
}

static int32_t clamp(int32_t lo, int32_t x, int32_t hi)
{
    if (x < lo)
        return lo;
    else if (x > hi)
        return hi;
    else
        return x;
}

static int16_t classify(int32_t x)
{
    switch (x / 1000) {
    case 0: return 1;
    case 1: case 2: case 3: return 2;
    case 4: case 5: return 3;
    case 6: case 7: case 8: return 4;
    default: return 0;
    }
}

static void low_pass_run(low_pass *f, int32_t x, int32_t k)
{
    f->x = x;
    f->k = k;
    f->y = f->y + (x - f->y) / k;
}

static void channel_run(channel *c, int32_t raw, int32_t gain)
{
    c->raw = raw;
    c->gain = gain;
    low_pass_run(&c->lp, clamp(0, scale(raw, gain, 50), 9000), 4);
    c->value = c->lp.y;
    c->cls = classify(c->value);
    if (c->value > c->hi)
        c->hi = c->value;
    else
        c->hi = c->hi - 1;
    if (c->cls >= 4)
        c->cnt++;
    else
        c->cnt = 0;
    c->alarm = c->cnt > 5;
}

void scan(void)
{
    int32_t i, sum = 0, n = 0;

    cyc = (cyc + 1) % 100000;
    for (i = 0; i < 200; i++) {
        channel_run(&ch[i], (cyc * 37 + i * 911) % 8192, 48 + i % 32);
        sum += ch[i].value;
        n += ch[i].cls;
        if (ch[i].alarm)
            n += 1000;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)n);
}
