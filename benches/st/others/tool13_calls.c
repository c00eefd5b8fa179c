#include <stdbool.h>
#include "st.h"

#define N 100

typedef struct { float y, trend; bool started; } Filter;
typedef struct { bool q; int16_t trips; } LimitSwitch;

static inline float scale(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static inline float deadband(float x, float width)
{
    if (x > width)
        return x - width;
    if (x < -width)
        return x + width;
    return 0.0f;
}

static void filter_step(Filter *f, int16_t raw, float gain)
{
    float x = scale(raw, -20.0f, 120.0f);
    if (!f->started) {
        f->y = x;
        f->started = true;
    }
    f->trend = deadband(x - f->y, 0.5f);
    f->y += f->trend * gain;
}

static void limit_step(LimitSwitch *s, float x, float low, float high)
{
    if (s->q) {
        if (x < low)
            s->q = false;
    } else if (x > high) {
        s->q = true;
        s->trips = (s->trips + 1) % 10000;
    }
}

static Filter filters[N];
static LimitSwitch switches[N];
static int16_t raw[N];
static int tick;

void scan(void)
{
    int32_t sum = 0;
    for (int i = 0; i < N; i++) {
        raw[i] += 137 + 3 * i + tick % 7;
        if (raw[i] > 27648)
            raw[i] -= 27648;
        filter_step(&filters[i], raw[i], 0.1f);
        limit_step(&switches[i], filters[i].y, 40.0f, 60.0f);
        sum += (int32_t)(filters[i].y * 100.0f) + switches[i].trips;
        if (switches[i].q)
            sum += i;
    }
    tick = (tick + 1) % 10000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
