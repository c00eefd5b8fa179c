#include <stdbool.h>
#include "st.h"
typedef struct { float value; int16_t state; bool changed; float filtered; int16_t old_state; int32_t events; } analog_in_t;
static float scale(int16_t raw, int16_t raw_lo, int16_t raw_hi, float lo, float hi)
{
    return lo + (hi - lo) * (float)(raw - raw_lo) / (float)(raw_hi - raw_lo);
}
static float absf(float x) { return x < 0.0f ? -x : x; }
static float dead_band(float x, float old, float width)
{
    if (absf(x - old) < width)
        return old;
    return x;
}
static int16_t alarm_state(float x, float ll, float l, float h, float hh)
{
    if (x >= hh) return 4;
    if (x >= h) return 3;
    if (x <= ll) return 1;
    if (x <= l) return 2;
    return 0;
}
static void analog_in(analog_in_t *a, int16_t raw, float lo, float hi)
{
    a->filtered = a->filtered + 0.25f * (scale(raw, 0, 27648, lo, hi) - a->filtered);
    a->value = dead_band(a->filtered, a->value, (hi - lo) * 0.002f);
    a->state = alarm_state(a->value, lo + (hi - lo) * 0.1f, lo + (hi - lo) * 0.2f,
                           lo + (hi - lo) * 0.8f, lo + (hi - lo) * 0.9f);
    a->changed = a->state != a->old_state;
    if (a->changed)
        a->events++;
    a->old_state = a->state;
}
static analog_in_t ai[200];
static int16_t phase;
void scan(void)
{
    phase = (int16_t)((phase + 173) % 27500);
    int16_t raw = phase;
    float sum = 0.0f;
    int32_t states = 0, changes = 0;
    for (int16_t i = 0; i < 200; i++) {
        analog_in(&ai[i], raw, -10.0f, 50.0f + (float)i);
        sum += ai[i].value;
        states += ai[i].state;
        if (ai[i].changed)
            changes++;
        raw = (int16_t)(raw + 131);
        if (raw > 27647)
            raw = (int16_t)(raw - 27648);
    }
    check = (check % 100003) * 3 + (int32_t)sum + states * 7 + changes;
}
