#include <math.h>
#include <stdbool.h>
#include "st.h"

#define COUNT 50
#define RAMP 25

enum drive_state { IDLE, STARTING, RUNNING, BRAKING };

struct analog { float value; bool alarm; };
struct gear { int32_t num, den; };
struct telegram { bool ok; int32_t errors; };
struct drive { int32_t speed; enum drive_state state; };

static struct analog analog[COUNT];
static struct gear gears[COUNT];
static struct telegram telegrams[COUNT];
static struct drive drives[COUNT];
static uint32_t seed = 1;

static int32_t clamp(int32_t v, int32_t low, int32_t high)
{
    if (v < low)
        return low;
    if (v > high)
        return high;
    return v;
}

static float scale(int16_t raw, float low, float high)
{
    return low + (float)raw / 27648.0f * (high - low);
}

static int32_t gcd(int32_t a, int32_t b)
{
    while (b != 0) {
        int32_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static int count_bits(uint16_t pattern)
{
    int n = 0;
    while (pattern != 0) {
        if (pattern & 1)
            n++;
        pattern >>= 1;
    }
    return n;
}

static bool hysteresis(float value, float low, float high, bool last)
{
    return value > high || (last && value >= low);
}

static void analog_update(struct analog *a, int16_t raw)
{
    a->value += 0.25f * (scale(raw, -50.0f, 150.0f) - a->value);
    a->alarm = hysteresis(a->value, 60.0f, 80.0f, a->alarm);
}

static void gear_update(struct gear *g, int32_t teeth1, int32_t teeth2)
{
    int32_t divisor = gcd(teeth1, teeth2);
    g->num = teeth1 / divisor;
    g->den = clamp(teeth2 / divisor, 1, 40);
}

static void telegram_update(struct telegram *t, uint16_t data)
{
    t->ok = count_bits(data) % 2 == 0;
    if (!t->ok)
        t->errors = clamp(t->errors + 1, 0, 5000);
}

static void drive_update(struct drive *d, bool on, int32_t reference)
{
    switch (d->state) {
    case IDLE:
        if (on)
            d->state = STARTING;
        break;
    case STARTING:
        d->speed = clamp(d->speed + RAMP, 0, reference);
        if (!on)
            d->state = BRAKING;
        else if (d->speed == reference)
            d->state = RUNNING;
        break;
    case RUNNING:
        d->speed += clamp(reference - d->speed, -RAMP, RAMP);
        if (!on)
            d->state = BRAKING;
        break;
    case BRAKING:
        d->speed = clamp(d->speed - 2 * RAMP, 0, d->speed);
        if (d->speed == 0)
            d->state = IDLE;
        break;
    }
}

void scan(void)
{
    float sum = 0.0f;
    int32_t result = 0;
    for (int i = 0; i < COUNT; i++) {
        seed = seed * 1103515245u + 12345u;
        int32_t random = (int32_t)(seed / 65536u);

        analog_update(&analog[i], random % 27649);
        sum += analog[i].value;
        if (analog[i].alarm)
            result++;

        gear_update(&gears[i], random % 200 + 12, random / 256 + 10);
        result += 3 * gears[i].num - gears[i].den;

        telegram_update(&telegrams[i], (uint16_t)random);
        result += telegrams[i].errors;

        drive_update(&drives[i], random % 16 > 2, 200 + 10 * (i + 1));
        result += drives[i].speed;
        if (drives[i].state == RUNNING)
            result += 1000;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)result + (uint32_t)(int32_t)lrintf(sum));
}
