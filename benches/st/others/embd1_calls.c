/* 50 drive channels, four blocks each = 200 block calls, with small functions */
#include <stdbool.h>
#include "st.h"

#define CHANNELS 50

typedef struct {
    int32_t value;
    int32_t acc;
} filter_t;

typedef struct {
    int32_t value;
    bool at_target;
} ramp_t;

typedef struct {
    int32_t speed;
    int16_t state;
    int32_t ticks;
} drive_t;

typedef struct {
    bool alarm;
    int32_t events;
    int32_t peak;
    bool was;
} monitor_t;

static filter_t filter[CHANNELS];
static ramp_t ramp[CHANNELS];
static drive_t drive[CHANNELS];
static monitor_t mon[CHANNELS];
static int32_t cyc;

static int32_t clamp(int32_t x, int32_t lo, int32_t hi)
{
    if (x < lo)
        return lo;
    else if (x > hi)
        return hi;
    else
        return x;
}

static int32_t scale(int32_t x, int32_t in_lo, int32_t in_hi, int32_t out_lo, int32_t out_hi)
{
    return out_lo + (x - in_lo) * (out_hi - out_lo) / (in_hi - in_lo);
}

static int32_t deadband(int32_t x, int32_t band)
{
    int32_t mag = x < 0 ? -x : x;

    if (mag <= band)
        return 0;
    else if (x > 0)
        return x - band;
    else
        return x + band;
}

static void filter_run(filter_t *f, int32_t raw, int32_t weight)
{
    f->acc = f->acc + (raw * 256 - f->acc) / weight;
    f->value = f->acc / 256;
}

static void ramp_run(ramp_t *r, int32_t target, int32_t rate, bool enable)
{
    if (enable)
        r->value = r->value + clamp(target - r->value, -rate, rate);
    else
        r->value = r->value - clamp(r->value, -rate * 2, rate * 2);
    r->at_target = r->value == target;
}

static void drive_run(drive_t *d, bool run, bool ack, int32_t speed_ref)
{
    int32_t err = deadband(speed_ref - d->speed, 2);

    switch (d->state) {
    case 0: /* stopped */
        d->speed = 0;
        if (run) {
            d->state = 1;
            d->ticks = 0;
        }
        break;
    case 1: /* magnetising */
        d->ticks++;
        if (!run)
            d->state = 0;
        else if (d->ticks >= 5)
            d->state = 2;
        break;
    case 2: /* running */
        d->speed = d->speed + err / 4;
        if (err > 1500)
            d->state = 3;
        else if (!run)
            d->state = 4;
        break;
    case 3: /* fault */
        d->speed = d->speed - d->speed / 8;
        if (ack)
            d->state = 0;
        break;
    case 4: /* coasting */
        d->speed = d->speed - d->speed / 16;
        if (d->speed < 20)
            d->state = 0;
        break;
    }
}

static void monitor_run(monitor_t *m, int32_t value, int32_t high, int32_t low)
{
    if (value > high)
        m->alarm = true;
    else if (value < low)
        m->alarm = false;
    if (m->alarm && !m->was)
        m->events++;
    m->was = m->alarm;
    m->peak = m->peak - 1 > value ? m->peak - 1 : value;
}

void scan(void)
{
    int32_t sum = 0;
    int16_t i;

    cyc++;
    for (i = 0; i < CHANNELS; i++) {
        int32_t ch = i + 1;
        int32_t adc = (cyc * (ch + 3) + ch * 97) % 4096;
        int32_t ref;

        filter_run(&filter[i], adc, 8);
        ref = scale(clamp(filter[i].value, 200, 3900), 200, 3900, 0, 3000);
        ramp_run(&ramp[i], ref, 15 + ch, drive[i].state != 3);
        drive_run(&drive[i], (cyc + ch * 13) % 400 < 330, (cyc + ch) % 64 == 0, ramp[i].value);
        monitor_run(&mon[i], drive[i].speed, 1600, 1200);
        sum = sum + drive[i].speed + drive[i].state * 7 + mon[i].events + mon[i].peak;
        if (ramp[i].at_target)
            sum++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
