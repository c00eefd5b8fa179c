/* Course unit 7: signal chains, 40 channels of five blocks. */
#include "st.h"
#include <stdbool.h>

static float scale_linear(int16_t raw, int16_t raw_min, int16_t raw_max, float out_min, float out_max)
{
    return (float)(raw - raw_min) * (out_max - out_min) / (float)(raw_max - raw_min) + out_min;
}

static float limit_real(float value, float low, float high)
{
    float v = value > low ? value : low;
    return v < high ? v : high;
}

static int32_t next_noise(int32_t seed)
{
    return (seed * 1103 + 12345) % 65536;
}

static bool in_range(float value, float low, float high)
{
    return value >= low && value <= high;
}

typedef struct { float y; bool started; } LowPass;
typedef struct { float value; bool reached; } Ramp;
typedef struct { bool on, before; int16_t switchings; } TwoPoint;
typedef struct { bool stable; int16_t counter; } Debounce;
typedef struct { int32_t total; bool overflow; } Totalizer;

static void low_pass(LowPass *f, float x, float k)
{
    if (f->started) {
        f->y = f->y + (x - f->y) * k;
    } else {
        f->y = x;
        f->started = true;
    }
}

static void ramp(Ramp *r, float target, float step)
{
    r->value = r->value + limit_real(target - r->value, -step, step);
    r->reached = in_range(r->value - target, -0.01f, 0.01f);
}

static void two_point(TwoPoint *t, float actual, float low, float high)
{
    t->before = t->on;
    if (actual < low)
        t->on = true;
    else if (actual > high)
        t->on = false;
    if (t->on && !t->before)
        t->switchings = (int16_t)((t->switchings + 1) % 1000);
}

static void debounce(Debounce *d, bool signal, int16_t cycles)
{
    if (signal == d->stable) {
        d->counter = 0;
    } else {
        d->counter++;
        if (d->counter >= cycles) {
            d->stable = signal;
            d->counter = 0;
        }
    }
}

static void totalizer(Totalizer *t, bool enable, int32_t increment, bool reset)
{
    if (reset) {
        t->total = 0;
        t->overflow = false;
    } else if (enable) {
        t->total += increment;
        if (t->total >= 100000) {
            t->total -= 100000;
            t->overflow = true;
        }
    }
}

static int32_t seed = 4711;
static int32_t scan_no;
static LowPass filters[40];
static Ramp ramps[40];
static TwoPoint switches[40];
static Debounce contacts[40];
static Totalizer totals[40];

void scan(void)
{
    scan_no = (scan_no + 1) % 5000;
    int32_t sum = 0;
    for (int i = 0; i < 40; i++) {
        seed = next_noise(seed);
        int16_t raw = (int16_t)(seed % 27649);
        float level = scale_linear(raw, 0, 27648, 0.0f, 100.0f);
        low_pass(&filters[i], level, 0.2f);
        ramp(&ramps[i], filters[i].y, 5.0f);
        two_point(&switches[i], ramps[i].value, 45.0f, 55.0f);
        debounce(&contacts[i], switches[i].on, 3);
        totalizer(&totals[i], contacts[i].stable, (int32_t)ramps[i].value, scan_no == 0);
        sum += totals[i].total + switches[i].switchings;
        if (ramps[i].reached || totals[i].overflow)
            sum += 1;
    }
    check = (check * 31 + sum) % 1000003;
}
