/* 200 block calls a scan (100 analog channels, 100 valves), which call functions. */
#include "st.h"
#include <stdbool.h>

static float scale_raw(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static float smooth(float old, float new, float factor)
{
    return old + (new - old) * factor;
}

static bool in_band(float x, float lo, float hi)
{
    return x >= lo && x <= hi;
}

static int16_t count_up(int16_t value, int16_t top)
{
    if (value < top)
        return (int16_t)(value + 1);
    return top;
}

typedef struct {
    float value;
    bool alarm;
    int16_t bad;
} AnalogChannel;

static void analog_channel(AnalogChannel *c, int16_t raw, float lo, float hi)
{
    c->value = smooth(c->value, scale_raw(raw, lo, hi), 0.25f);
    if (in_band(c->value, lo + 5.0f, hi - 5.0f))
        c->bad = 0;
    else
        c->bad = count_up(c->bad, 10);
    c->alarm = c->bad >= 3;
}

typedef struct {
    bool is_open, is_closed;
    int16_t moves;
    int16_t position;
    bool was_open;
} Valve;

static void valve(Valve *v, bool open_cmd, bool close_cmd, int16_t travel)
{
    if (open_cmd && !close_cmd)
        v->position = count_up(v->position, travel);
    else if (close_cmd && v->position > 0)
        v->position = (int16_t)(v->position - 1);
    v->is_open = v->position >= travel;
    v->is_closed = v->position <= 0;
    if (v->is_open && !v->was_open)
        v->moves = count_up(v->moves, 1000);
    v->was_open = v->is_open;
}

static int32_t tick;
static AnalogChannel channels[100];
static Valve valves[100];

void scan(void)
{
    int32_t i, sum;
    int16_t raw;

    tick = (tick + 1) % 27648;
    sum = 0;
    for (i = 0; i < 100; i++) {
        raw = (int16_t)((tick * 3 + i * 271) % 27648);
        analog_channel(&channels[i], raw, 0.0f, 150.0f);
        sum += (int32_t)(channels[i].value * 10.0f);
        if (channels[i].alarm)
            sum += 1;
    }
    for (i = 0; i < 100; i++) {
        valve(&valves[i], channels[i].value > 80.0f, channels[99 - i].alarm, (int16_t)(10 + i % 7));
        if (valves[i].is_open)
            sum += 2;
        if (valves[i].is_closed)
            sum += 3;
        sum += valves[i].moves;
    }
    check = (check % 1000003) * 31 + sum;
}
