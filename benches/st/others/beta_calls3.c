#include "st.h"
#include <stdbool.h>

typedef struct { int16_t x, y; } Point;
typedef struct { int16_t address, kind, value; uint16_t flags; } Telegram;

static uint16_t crc_step(uint16_t crc, uint8_t data)
{
    uint16_t w = crc ^ data;
    for (int i = 0; i < 8; i++) {
        if (w & 1)
            w = (w >> 1) ^ 0xA001;
        else
            w >>= 1;
    }
    return w;
}

static int16_t classify(Telegram t)
{
    switch (t.kind) {
    case 0:
        return 1;
    case 1: case 2: case 3:
        return t.value / 100;
    case 4: case 5: case 6: case 7: case 8: case 9:
        if (t.value < 0)
            return -t.kind;
        return t.kind;
    case 10:
        return t.address % 5;
    case 12: case 14:
        return t.address + t.kind;
    default:
        return 0;
    }
}

static int16_t interpolate(int16_t x, const Point c[8])
{
    if (x <= c[0].x)
        return c[0].y;
    for (int i = 1; i <= 7; i++) {
        if (x < c[i].x) {
            int32_t dx = c[i].x - c[i - 1].x;
            int32_t dy = c[i].y - c[i - 1].y;
            return c[i - 1].y + (int16_t)((x - c[i - 1].x) * dy / dx);
        }
    }
    return c[7].y;
}

static int16_t bit_count(uint16_t w)
{
    int16_t n = 0;
    while (w != 0) {
        n += w & 1;
        w >>= 1;
    }
    return n;
}

static int16_t gcd(int16_t a, int16_t b)
{
    int16_t x = a < 0 ? -a : a;
    int16_t y = b < 0 ? -b : b;
    while (y != 0) {
        int16_t r = x % y;
        x = y;
        y = r;
    }
    return x;
}

static bool split_value(int16_t value, int16_t *high, int16_t *low)
{
    *high = value / 256;
    *low = value % 256;
    return *high != 0;
}

static bool ready;
static uint32_t seed = 4711;
static Telegram tel[34];
static Point shape[8];

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int i = 0; i <= 7; i++) {
            shape[i].x = i * i * 60 - 1000;
            shape[i].y = i * 150 - (i % 3) * 40;
        }
        for (int i = 0; i <= 33; i++) {
            tel[i].address = i * 3 + 1;
            tel[i].kind = i % 16;
        }
    }
    uint16_t crc = 0xFFFF;
    int32_t sum = 0;
    for (int i = 0; i <= 33; i++) {
        int16_t hi, lo;
        seed = seed * 1103515245u + 12345u;
        tel[i].value = (int16_t)((seed / 65536u) % 4000u) - 1500;
        tel[i].flags = (uint16_t)tel[i].value ^ 0x0F0F;
        crc = crc_step(crc, (uint8_t)tel[i].value);
        sum += classify(tel[i]);
        sum += interpolate(tel[i].value, shape);
        sum += bit_count(tel[i].flags);
        sum += gcd(tel[i].value, tel[i].address * 12);
        if (split_value(tel[i].value, &hi, &lo))
            sum += hi;
        else
            sum -= lo;
    }
    check = (int32_t)((uint32_t)check * 13u + (uint32_t)sum + (uint32_t)(int16_t)crc);
}
