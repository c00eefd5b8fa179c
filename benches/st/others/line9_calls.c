/* Two hundred small objects per scan: analogue inputs, ramps, valves and flow totalizers */
#include "st.h"
#include <stdbool.h>

#define COUNT 50

enum valve_state { VALVE_CLOSED, VALVE_OPENING, VALVE_OPEN, VALVE_CLOSING, VALVE_ERROR };

struct scaling {
    int16_t raw_low, raw_high;
    float eng_low, eng_high;
};

struct channel {
    int16_t raw;
    struct scaling scaling;
    float value;
    bool alarm;
};

struct analog_in { float filtered; };
struct ramp { int32_t position; bool arrived; };
struct valve { enum valve_state state; int32_t code, stroke, cycles; };
struct totalizer { int32_t total; bool full; };

static struct channel channels[COUNT];
static struct analog_in inputs[COUNT];
static struct ramp ramps[COUNT];
static struct valve valves[COUNT];
static struct totalizer totals[COUNT];
static bool ready;
static int scans;

static int32_t clamp(int32_t v, int32_t lo, int32_t hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static float scale_linear(int16_t raw, const struct scaling *s)
{
    return s->eng_low + (float)(raw - s->raw_low) * (s->eng_high - s->eng_low) / (float)(s->raw_high - s->raw_low);
}

static bool is_outside(float v, float lo, float hi)
{
    return v < lo || v > hi;
}

static float low_pass(float last, float v, float alpha)
{
    return last + alpha * (v - last);
}

static int32_t step_towards(int32_t actual, int32_t target, int32_t rate)
{
    return actual + clamp(target - actual, -rate, rate);
}

static int32_t state_code(enum valve_state s)
{
    switch (s) {
    case VALVE_CLOSED: return 1;
    case VALVE_OPENING: return 20;
    case VALVE_OPEN: return 300;
    case VALVE_CLOSING: return 4000;
    case VALVE_ERROR: return 50000;
    }
    return 0;
}

static void analog_update(struct analog_in *a, struct channel *ch)
{
    a->filtered = low_pass(a->filtered, scale_linear(ch->raw, &ch->scaling), 0.25f);
    ch->value = a->filtered;
    ch->alarm = is_outside(a->filtered, ch->scaling.eng_low + 5.0f, ch->scaling.eng_high - 5.0f);
}

static void ramp_update(struct ramp *r, int32_t target, int32_t rate)
{
    r->position = step_towards(r->position, target, rate);
    r->arrived = r->position == target;
}

static void valve_update(struct valve *v, bool open, bool reset)
{
    switch (v->state) {
    case VALVE_CLOSED:
        if (open)
            v->state = VALVE_OPENING;
        break;
    case VALVE_OPENING:
        v->stroke = step_towards(v->stroke, 100, 30);
        if (!open) {
            v->state = VALVE_CLOSING;
        } else if (v->stroke == 100) {
            v->state = VALVE_OPEN;
            v->cycles++;
        }
        break;
    case VALVE_OPEN:
        if (!open)
            v->state = VALVE_CLOSING;
        if (v->cycles >= 20)
            v->state = VALVE_ERROR;
        break;
    case VALVE_CLOSING:
        v->stroke = step_towards(v->stroke, 0, 40);
        if (v->stroke == 0)
            v->state = VALVE_CLOSED;
        break;
    case VALVE_ERROR:
        if (reset) {
            v->cycles = 0;
            v->state = VALVE_CLOSING;
        }
        break;
    }
    v->code = state_code(v->state);
}

static void totalizer_update(struct totalizer *t, int32_t flow, bool enable)
{
    t->full = false;
    if (enable)
        t->total += clamp(flow, 0, 500);
    if (t->total >= 20000) {
        t->total -= 20000;
        t->full = true;
    }
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < COUNT; i++)
            channels[i].scaling = (struct scaling){ 0, 27648, -10.0f, 100.0f + (float)i };
        ready = true;
    }
    scans = (scans + 1) % 9000;
    int32_t alarms = 0;
    for (int i = 0; i < COUNT; i++) {
        channels[i].raw = (int16_t)((channels[i].raw + 391 + i * 7) % 27649);
        analog_update(&inputs[i], &channels[i]);
        alarms += channels[i].alarm;
        ramp_update(&ramps[i], (scans / 64 + i) % 10 * 250, 9 + i);
        valve_update(&valves[i], ramps[i].arrived || ramps[i].position > 1500, scans % 100 == i);
        totalizer_update(&totals[i], ramps[i].position - (int32_t)channels[i].value, valves[i].state == VALVE_OPEN);
        int32_t result = totals[i].total + valves[i].code + ramps[i].position;
        if (totals[i].full)
            result += 7;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)result);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)alarms);
}
