/* analog inputs and dosing pumps: blocks which call functions */
#include <math.h>
#include <stdbool.h>
#include "st.h"

typedef struct {
    float value;
    int16_t code;
    bool hh, h, l, ll;
} analog_in_t;

typedef struct {
    float rate;
    int32_t strokes;
    bool tank_low, inhibit;
    float tank, acc;
} dosing_t;

static analog_in_t ai[100];
static dosing_t dose[100];
static int16_t raw[100];
static uint32_t seed = 12345;
static bool init;

static float scale(int16_t r, float lo, float hi)
{
    return lo + (float)r * (hi - lo) / 27648.0f;
}

static float clamp(float x, float lo, float hi)
{
    if (x < lo) return lo;
    if (x > hi) return hi;
    return x;
}

static bool hyst(float x, float on, float off, bool old)
{
    if (x >= on) return true;
    if (x <= off) return false;
    return old;
}

static int16_t alarm_code(bool hh, bool h, bool l, bool ll, bool fault)
{
    if (fault) return 9;
    if (hh) return 4;
    if (ll) return 3;
    if (h) return 2;
    if (l) return 1;
    return 0;
}

static void analog_in(analog_in_t *a, int16_t r, float lo, float hi, float filter)
{
    float span = hi - lo;
    a->value += (clamp(scale(r, lo, hi), lo, hi) - a->value) * filter;
    a->hh = hyst(a->value, lo + span * 0.95f, lo + span * 0.93f, a->hh);
    a->h = hyst(a->value, lo + span * 0.8f, lo + span * 0.78f, a->h);
    a->l = !hyst(a->value, lo + span * 0.22f, lo + span * 0.2f, !a->l);
    a->ll = !hyst(a->value, lo + span * 0.07f, lo + span * 0.05f, !a->ll);
    a->code = alarm_code(a->hh, a->h, a->l, a->ll, r < -500 || r > 28000);
}

static float dose_rate(float flow, float ppm, float strength)
{
    if (strength < 0.5f)
        return 0.0f;
    return clamp(flow * ppm / strength, 0.0f, 60.0f);
}

static void dosing(dosing_t *d, bool enable, float flow, float ppm, float strength, int16_t code)
{
    d->inhibit = !enable || code == 9 || code == 3 || d->tank_low;
    d->rate = d->inhibit ? 0.0f : dose_rate(flow, ppm, strength);
    d->acc += d->rate * 0.1f;
    int32_t n = (int32_t)d->acc;
    d->strokes += n;
    d->acc -= (float)n;
    d->tank = clamp(d->tank - d->rate * 0.05f, 0.0f, 500.0f);
    d->tank_low = !hyst(d->tank, 450.0f, 25.0f, !d->tank_low);
    if (d->tank_low)
        d->tank += 10.0f;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 100; i++)
            dose[i].tank = 500.0f;
        init = true;
    }
    uint32_t total = 0, codes = 0;
    float rate_sum = 0.0f;
    for (int i = 0; i < 100; i++) {
        seed = seed * 1103515245u + 12345u;
        raw[i] = (int16_t)(raw[i] + (int)((seed / 65536) % 2001) - 1000);
        if (raw[i] > 28100)
            raw[i] = 20000;
        else if (raw[i] < -700)
            raw[i] = 9000;
        analog_in(&ai[i], raw[i], 0.0f, 50.0f + (float)(i + 1), 0.2f);
        codes = codes * 3 + ai[i].code;
    }
    for (int i = 0; i < 100; i++) {
        dosing(&dose[i], raw[99 - i] > 2000, ai[i].value, 2.5f, 12.0f - (float)((i + 1) % 10), ai[i].code);
        rate_sum += dose[i].rate;
        total += dose[i].strokes;
        if (dose[i].tank_low)
            codes += 7;
    }
    check = (int32_t)((uint32_t)check * 5u + total + codes + (uint32_t)(int32_t)lrintf(rate_sum * 10.0f));
}
