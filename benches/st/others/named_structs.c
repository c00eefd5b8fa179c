#include "st.h"
#include <xmmintrin.h>
#include <stdbool.h>

typedef struct {
    int16_t raw;
    float value, high, low;
    bool alarm;
} analog_t;

typedef enum { IDLE, FILLING, HOLDING, DRAINING } state_t;

typedef struct {
    int16_t number;
    state_t state;
    analog_t level, temp;
    int32_t steps;
    int16_t batches;
    bool in_valve, out_valve, heater;
} tank_t;

static void control(tank_t *t)
{
    switch (t->state) {
    case IDLE:
        t->in_valve = t->out_valve = false;
        if (t->level.value < t->level.low)
            t->state = FILLING;
        break;
    case FILLING:
        t->in_valve = true;
        t->level.value += 1.5f;
        if (t->level.value >= t->level.high) {
            t->state = HOLDING;
            t->steps = 0;
        }
        break;
    case HOLDING:
        t->in_valve = false;
        t->heater = t->temp.value < t->temp.high;
        if (++t->steps > 20 + t->number)
            t->state = DRAINING;
        break;
    case DRAINING:
        t->heater = false;
        t->out_valve = true;
        t->level.value -= 2.25f;
        if (t->level.value <= 1.0f) {
            t->state = IDLE;
            t->batches++;
        }
        break;
    }
    if (t->heater)
        t->temp.value += 0.75f;
    else
        t->temp.value -= (t->temp.value - 20.0f) * 0.03125f;
    t->temp.raw = _mm_cvt_ss2si(_mm_set_ss(t->temp.value * 100.0f));
    t->level.raw = _mm_cvt_ss2si(_mm_set_ss(t->level.value * 100.0f));
    t->temp.alarm = t->temp.value > t->temp.high || t->temp.value < t->temp.low;
    t->level.alarm = t->level.value > t->level.high || t->level.value < t->level.low;
}

static tank_t farm[60];
static tank_t fullest;
static int32_t scans;

void scan(void)
{
    scans++;
    if (scans == 1)
        for (int i = 1; i <= 60; i++) {
            tank_t *t = &farm[i - 1];
            t->number = i;
            t->state = IDLE;
            t->level.high = 60.0f + (i % 7) * 4.0f;
            t->level.low = 5.0f;
            t->temp.value = 20.0f + i;
            t->temp.high = 45.0f;
            t->temp.low = 22.0f;
        }
    int32_t n = 0;
    for (int i = 0; i < 60; i++)
        control(&farm[i]);
    fullest = farm[0];
    for (int i = 1; i < 60; i++)
        if (farm[i].level.value > fullest.level.value)
            fullest = farm[i];
    for (int i = 0; i < 60; i++) {
        tank_t *t = &farm[i];
        n += t->level.raw + t->temp.raw * 2 + t->batches;
        if (t->temp.alarm || t->level.alarm)
            n += i + 1;
        if (t->in_valve != t->out_valve)
            n += 5;
    }
    check = (check + n + fullest.number * 10 + fullest.level.raw) % 1000000;
}
