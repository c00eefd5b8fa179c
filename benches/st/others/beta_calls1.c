#include "st.h"
#include <stdbool.h>
#include <math.h>

typedef struct { float y; bool started; } LowPass;
typedef struct { float y; bool limiting; } RateLimiter;
typedef struct { float y; bool changed; } DeadBand;
typedef struct { int16_t level; bool active; int32_t events; } LevelAlarm;

static float scale_raw(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * ((float)raw / 27648.0f);
}

static void low_pass(LowPass *b, float x, float alpha)
{
    if (!b->started) {
        b->y = x;
        b->started = true;
    } else {
        b->y = b->y + alpha * (x - b->y);
    }
}

static void rate_limiter(RateLimiter *b, float x, float up, float down)
{
    float d = x - b->y;
    b->limiting = true;
    if (d > up) {
        b->y += up;
    } else if (d < -down) {
        b->y -= down;
    } else {
        b->y = x;
        b->limiting = false;
    }
}

static void dead_band(DeadBand *b, float x, float width)
{
    b->changed = fabsf(x - b->y) > width;
    if (b->changed)
        b->y = x;
}

static void level_alarm(LevelAlarm *b, float x, float ll, float l, float h, float hh, float hyst)
{
    int16_t n = b->level;
    switch (b->level) {
    case 0:
        if (x > hh) n = 2;
        else if (x > h) n = 1;
        else if (x < ll) n = -2;
        else if (x < l) n = -1;
        break;
    case 1:
        if (x > hh) n = 2;
        else if (x < h - hyst) n = 0;
        break;
    case 2:
        if (x < hh - hyst) n = 1;
        break;
    case -1:
        if (x < ll) n = -2;
        else if (x > l + hyst) n = 0;
        break;
    case -2:
        if (x > ll + hyst) n = -1;
        break;
    }
    if (n != b->level) {
        b->events++;
        b->level = n;
    }
    b->active = b->level != 0;
}

static uint32_t seed = 12345;
static LowPass filters[40];
static RateLimiter ramps[40];
static DeadBand bands[40];
static LevelAlarm alarms[40];

void scan(void)
{
    int32_t n_active = 0, sum = 0;
    for (int i = 0; i < 40; i++) {
        seed = seed * 1664525u + 1013904223u;
        int16_t raw = (int16_t)((seed / 65536u) % 27649u);
        float eng = scale_raw(raw, -10.0f, 100.0f);
        low_pass(&filters[i], eng, 0.15f);
        rate_limiter(&ramps[i], filters[i].y, 4.0f, 6.0f);
        dead_band(&bands[i], ramps[i].y, 0.5f);
        level_alarm(&alarms[i], bands[i].y, 20.0f, 32.0f, 55.0f, 65.0f, 2.0f);
        if (alarms[i].active)
            n_active++;
        if (bands[i].changed)
            sum += (int32_t)(bands[i].y * 10.0f);
        sum += alarms[i].level + alarms[i].events % 100;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)n_active);
}
