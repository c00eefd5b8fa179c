/* Example 7: 200 calls of function blocks (4 kinds, 50 instances each). */
#include <stdbool.h>
#include "st.h"

#define N 50

static float scale_raw(int16_t raw, float low, float high)
{
    return low + (float)raw * (high - low) / 27648.0f;
}

static int16_t clamp_int(int16_t x, int16_t mn, int16_t mx)
{
    if (x < mn)
        return mn;
    if (x > mx)
        return mx;
    return x;
}

static bool in_window(float x, float centre, float width)
{
    return x >= centre - width && x <= centre + width;
}

static float low_pass(float old, float new, float alpha)
{
    return old + alpha * (new - old);
}

struct analog {
    float value;
    bool fault;
};

static void analog_run(struct analog *a, int16_t raw, float low, float high)
{
    int16_t lim = clamp_int(raw, 0, 27648);

    a->fault = lim != raw;
    a->value = low_pass(a->value, scale_raw(lim, low, high), 0.25f);
}

struct limit {
    bool alarm, good, old;
    int16_t events;
};

static void limit_run(struct limit *l, float value, float setpoint, float band)
{
    if (value > setpoint + band)
        l->alarm = true;
    else if (value < setpoint - band)
        l->alarm = false;
    l->good = in_window(value, setpoint, band);
    if (l->alarm && !l->old)
        l->events = clamp_int((int16_t)(l->events + 1), 0, 9999);
    l->old = l->alarm;
}

struct valve {
    int16_t state; /* 0 closed, 1 opening, 2 open, 3 closing */
    int16_t pos;
};

static void valve_run(struct valve *v, bool cmd_open, int16_t travel)
{
    switch (v->state) {
    case 0:
        if (cmd_open)
            v->state = 1;
        break;
    case 1:
        v->pos = clamp_int((int16_t)(v->pos + 1), 0, travel);
        if (!cmd_open)
            v->state = 3;
        else if (v->pos >= travel)
            v->state = 2;
        break;
    case 2:
        if (!cmd_open)
            v->state = 3;
        break;
    case 3:
        v->pos = clamp_int((int16_t)(v->pos - 1), 0, travel);
        if (cmd_open)
            v->state = 1;
        else if (v->pos <= 0)
            v->state = 0;
        break;
    }
}

struct total {
    int32_t litres;
    float rest;
};

static void total_run(struct total *t, float flow, bool open, bool reset)
{
    if (reset) {
        t->litres = 0;
        t->rest = 0.0f;
    } else if (open) {
        t->rest += flow;
        while (t->rest >= 1.0f) {
            t->rest -= 1.0f;
            t->litres++;
        }
    }
}

static struct analog analogs[N];
static struct limit limits[N];
static struct valve valves[N];
static struct total totals[N];
static int32_t cycle;

void scan(void)
{
    int32_t sum = 0;

    cycle = (cycle + 1) % 100000;
    for (int i = 0; i < N; i++) {
        /* simulated raw value: saw tooth, now and then out of range */
        int16_t raw = (int16_t)((cycle * 97 + (i + 1) * 1201) % 28500);

        analog_run(&analogs[i], raw, 0.0f, 150.0f);
        limit_run(&limits[i], analogs[i].value, 80.0f, 5.0f);
        valve_run(&valves[i], limits[i].alarm && !analogs[i].fault, 10);
        total_run(&totals[i], analogs[i].value * 0.02f, valves[i].state != 0, cycle % 3000 == 0);

        sum += valves[i].pos + limits[i].events + totals[i].litres;
        if (limits[i].good)
            sum += i + 1;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum
                      + (uint32_t)(int32_t)(analogs[24].value * 100.0f));
}
