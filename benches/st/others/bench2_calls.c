/* 200 "function block" calls: 50 each of four blocks, which call functions. */
#include "st.h"
#include <stdbool.h>

static float f_scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static float f_clamp(float lo, float v, float hi)
{
    if (v < lo)
        return lo;
    if (v > hi)
        return hi;
    return v;
}

static int16_t f_status(bool running, bool fault, bool ready, int16_t state)
{
    int16_t s = state * 8;
    if (running) s += 1;
    if (fault) s += 2;
    if (ready) s += 4;
    return s;
}

static int32_t f_wrap(int32_t v, int32_t modulus)
{
    int32_t r = v % modulus;
    if (r < 0)
        r += modulus;
    return r;
}

/* analog input with scaling, filter and alarms */
typedef struct {
    float lo, hi;
    float value;
    bool high, low;
} analog_in;

static void analog_in_call(analog_in *a, int16_t raw, float alarm_hi, float alarm_lo)
{
    float v = f_clamp(a->lo, f_scale(raw, a->lo, a->hi), a->hi);
    a->value += (v - a->value) * 0.25f;
    a->high = a->value > alarm_hi || (a->high && a->value > alarm_hi - 2.0f);
    a->low = a->value < alarm_lo || (a->low && a->value < alarm_lo + 2.0f);
}

/* set-point ramp */
typedef struct {
    float out;
    bool done;
} ramp;

static void ramp_call(ramp *r, float target, float rate)
{
    float d = target - r->out;
    r->out += f_clamp(-rate, d, rate);
    r->done = (d < 0.0f ? -d : d) <= rate;
}

/* motor with state machine */
typedef struct {
    bool running;
    int16_t status;
    int16_t state;
    int16_t delay;
} motor;

static void motor_call(motor *m, bool start, bool stop, bool trip)
{
    switch (m->state) {
    case 0:
        if (start && !stop) {
            m->state = 1;
            m->delay = 5;
        }
        break;
    case 1:
        m->delay--;
        if (m->delay <= 0)
            m->state = 2;
        break;
    case 2:
        if (stop)
            m->state = 0;
        break;
    case 3:
        if (!trip && stop)
            m->state = 0;
        break;
    }
    if (trip)
        m->state = 3;
    m->running = m->state == 2;
    m->status = f_status(m->running, m->state == 3, m->state == 0, m->state);
}

/* flow totalizer with a pulse output */
typedef struct {
    int32_t per_pulse;
    int32_t total;
    int32_t pulses;
    int32_t rest;
} totalizer;

static void totalizer_call(totalizer *t, int32_t flow, bool enable)
{
    if (enable) {
        t->rest += flow;
        if (t->rest >= t->per_pulse) {
            t->rest -= t->per_pulse;
            t->pulses = f_wrap(t->pulses + 1, 10000);
        }
        t->total = f_wrap(t->total + flow, 1000000);
    }
}

static analog_in ai[50];
static ramp rmp[50];
static motor mot[50];
static totalizer tot[50];
static int32_t n;
static bool started;

void scan(void)
{
    if (!started) {
        for (int i = 0; i < 50; i++) {
            ai[i].lo = 0.0f;
            ai[i].hi = 100.0f;
            tot[i].per_pulse = 100;
        }
        started = true;
    }

    n = (n + 1) % 10000;
    int32_t sum = 0;
    for (int i = 0; i < 50; i++) {
        int16_t raw = (int16_t)((n * 37 + i * 541) % 27649);
        analog_in_call(&ai[i], raw, 80.0f, 20.0f);
        ramp_call(&rmp[i], ai[i].value, 0.5f);
        motor_call(&mot[i], ai[i].high, ai[i].low, (n + i) % 97 == 0);
        totalizer_call(&tot[i], (int32_t)rmp[i].out, mot[i].running);

        sum += mot[i].status + tot[i].total + tot[i].pulses;
        if (rmp[i].done)
            sum++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
