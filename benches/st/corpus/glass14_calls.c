/* Roller drives and analogue inputs: 100 drives and 100 measuring channels */
#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

#define COUNT 100

typedef struct { int32_t acc, value; bool alarm; } channel_t;
typedef struct { int32_t speed, position, turns; bool at_speed; } drive_t;

static channel_t chan[COUNT];
static drive_t drv[COUNT];
static uint32_t seed = 4711;

static inline int32_t clamp(int32_t x, int32_t lo, int32_t hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline int32_t scale_raw(int32_t raw, int32_t span, int32_t offs)
{
    return raw * span / 4096 + offs;
}

static inline int32_t slew(int32_t actual, int32_t target, int32_t rate)
{
    return actual + clamp(target - actual, -rate, rate);
}

static void channel_step(channel_t *c, int32_t raw, int32_t span)
{
    c->acc += raw - c->acc / 8;
    c->value = scale_raw(c->acc / 8, span, 20);
    if (c->value > 700)
        c->alarm = true;
    else if (c->value < 500)
        c->alarm = false;
}

static void drive_step(drive_t *d, bool enable, int32_t target, int32_t rate)
{
    if (enable)
        d->speed = slew(d->speed, clamp(target, 0, 1500), rate);
    else
        d->speed = slew(d->speed, 0, 2 * rate);
    d->at_speed = abs(d->speed - target) < 10;
    d->position += d->speed;
    if (d->position >= 36000) {
        d->position -= 36000;
        d->turns++;
    }
}

void scan(void)
{
    int32_t sum = 0, n_alarm = 0, n_ready = 0, before = 800;
    for (int i = 0; i < COUNT; i++) {
        seed = seed * 1664525u + 1013904223u;
        channel_step(&chan[i], (int32_t)(seed / 1048576u), 900 + 5 * i);
        if (chan[i].alarm)
            n_alarm++;
        drive_step(&drv[i], !chan[i].alarm, (chan[i].value * 2 + before) / 2, 3 + i % 8);
        before = drv[i].speed;
        if (drv[i].at_speed)
            n_ready++;
        sum += drv[i].speed * 3 + chan[i].value;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + n_alarm * 1000 + n_ready));
}
