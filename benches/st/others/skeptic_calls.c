/* 200 calls of function blocks which call functions, and 300 direct calls of functions, a scan */
#include <stdbool.h>
#include "st.h"

#define COUNT 40

static int32_t clamp(int32_t lo, int32_t x, int32_t hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static int16_t scale(int16_t x, int16_t num, int16_t den)
{
    if (den == 0)
        return 0;
    return (int16_t)clamp(-30000, (int32_t)x * num / den, 30000);
}

static uint8_t gray(uint8_t b)
{
    return (uint8_t)(b ^ (b >> 1));
}

static uint8_t crc8(uint8_t crc, uint8_t data)
{
    uint8_t c = crc ^ data;
    for (int n = 0; n < 8; n++) {
        if (c & 0x80)
            c = (uint8_t)((c << 1) ^ 0x07);
        else
            c = (uint8_t)(c << 1);
    }
    return c;
}

static int16_t pop_count(uint16_t w)
{
    int16_t n = 0;
    while (w != 0) {
        if (w & 1)
            n++;
        w >>= 1;
    }
    return n;
}

static int32_t gcd(int32_t x, int32_t y)
{
    while (y != 0) {
        int32_t t = x % y;
        x = y;
        y = t;
    }
    return x;
}

static float median3(float a, float b, float c)
{
    if (a > b) {
        if (b > c)
            return b;
        return a > c ? c : a;
    }
    if (a > c)
        return a;
    return b > c ? c : b;
}

static float curve(float x)
{
    if (x < 100.0f)
        return 0.5f * x;
    if (x < 300.0f)
        return 50.0f + 1.25f * (x - 100.0f);
    return 300.0f + 0.25f * (x - 300.0f);
}

struct ramp { int16_t out; bool moving; };
struct debounce { bool q; int16_t edges, seen; };
struct smooth { float value, old1, old2; };
struct frame { uint8_t crc; int16_t errors; };
struct mixer { int16_t out; int32_t total; };

static void ramp(struct ramp *p, int16_t target, int16_t step)
{
    int32_t delta = clamp(-step, target - p->out, step);
    p->moving = delta != 0;
    if (p->moving)
        p->out = (int16_t)(p->out + delta);
}

static void debounce(struct debounce *p, bool signal, int16_t need)
{
    if (signal == p->q) {
        p->seen = 0;
        return;
    }
    if (++p->seen >= need) {
        p->q = signal;
        p->seen = 0;
        p->edges = scale((int16_t)(p->edges + 1), 7, 8);
    }
}

static void smooth(struct smooth *p, float raw)
{
    p->value += 0.25f * (curve(median3(raw, p->old1, p->old2)) - p->value);
    p->old2 = p->old1;
    p->old1 = raw;
}

static void frame(struct frame *p, uint16_t data)
{
    uint8_t hi = (uint8_t)(data >> 8), lo = (uint8_t)data;
    if ((hi & 0xC0) == 0xC0) {
        p->errors = (int16_t)(p->errors + pop_count(data));
        return;
    }
    p->crc = crc8(crc8(p->crc, hi), gray(lo));
}

static void mixer(struct mixer *p, int16_t a, int16_t b, uint8_t select)
{
    switch (select) {
    case 0:
        p->out = scale(a, 3, 4);
        break;
    case 1:
        p->out = scale(b, a % 16, 5);
        break;
    case 2: case 3:
        p->out = (int16_t)gcd(a + 1, b + 1);
        break;
    case 4: case 5: case 6:
        p->total = clamp(-100000, p->total + a - b, 100000);
        p->out = (int16_t)(p->total / 8);
        break;
    default:
        p->out /= 2;
    }
}

struct unit {
    struct ramp ramp;
    struct debounce bounce;
    struct smooth smooth;
    struct frame frame;
    struct mixer mixer;
    int16_t target;
};

static struct unit units[COUNT];
static uint32_t seed = 99;
static uint8_t crc;

static inline int16_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (int16_t)(seed / 131072);
}

void scan(void)
{
    uint32_t sum = 0;
    float level = 0.0f;

    for (int i = 1; i <= COUNT; i++) {
        struct unit *u = &units[i - 1];
        int16_t r = next_random();
        int16_t s = next_random();
        if (r % 16 == 0)
            u->target = (int16_t)(s - 16000);
        ramp(&u->ramp, u->target, (int16_t)(1 + s % 1000));
        debounce(&u->bounce, r % 8 > 2, (int16_t)(1 + i % 4));
        smooth(&u->smooth, (float)(s % 400));
        frame(&u->frame, (uint16_t)(r ^ (s << 3)));
        mixer(&u->mixer, u->ramp.out / 2, s, (uint8_t)(r / 64 % 8));
        sum += (uint32_t)(u->ramp.out + u->mixer.out);
        if (u->bounce.q)
            sum += (uint32_t)u->bounce.edges;
        sum += u->ramp.moving ? u->frame.crc : (uint32_t)u->frame.errors;
        level += u->smooth.value;
    }

    for (int i = 1; i <= 100; i++) {
        int16_t r = next_random();
        int32_t d = gcd(r % 512 + 1, i + 64);
        if (d > 1) {
            sum += (uint32_t)(d * pop_count((uint16_t)r));
            crc = crc8(crc, (uint8_t)(r % 256));
        } else {
            sum += (uint32_t)scale(r, (int16_t)i, 77);
            level += curve((float)(r % 500));
        }
    }
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)(int32_t)level + crc);
}
