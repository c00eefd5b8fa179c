#include <stdbool.h>
#include "st.h"

typedef struct { float value; bool alarm_hi, alarm_lo, broken; } analog_t;
typedef struct { int16_t pos, strokes; bool is_open, is_closed, was; } valve_t;
typedef struct { int32_t hours; int16_t speed; bool running, fault; } motor_t;

static analog_t ai[80];
static valve_t vlv[60];
static motor_t mot[60];
static uint32_t seed = 1;
static int32_t n;

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static bool hyst(float x, float on, float off, bool old)
{
    return x >= on ? true : x <= off ? false : old;
}

static int16_t step_to(int16_t pos, int16_t goal, int16_t max_step)
{
    int diff = goal - pos;
    if (diff > max_step)
        diff = max_step;
    else if (diff < -max_step)
        diff = -max_step;
    return (int16_t)(pos + diff);
}

static void analog(analog_t *a, int16_t raw, float lo, float hi)
{
    a->broken = raw < 0 || raw > 27648;
    if (!a->broken)
        a->value += (scale(raw, lo, hi) - a->value) * 0.25f;
    a->alarm_hi = hyst(a->value, 80.0f, 75.0f, a->alarm_hi);
    a->alarm_lo = hyst(-a->value, -20.0f, -25.0f, a->alarm_lo);
}

static void valve(valve_t *v, bool open, bool lock)
{
    if (!lock)
        v->pos = step_to(v->pos, open ? 1000 : 0, 70);
    v->is_open = v->pos >= 990;
    v->is_closed = v->pos <= 10;
    if (v->is_open && !v->was)
        v->strokes++;
    v->was = v->is_open;
}

static void motor(motor_t *m, bool start, bool stop, bool trip, int16_t set_speed)
{
    if (trip)
        m->fault = true;
    else if (stop)
        m->fault = false;
    m->running = (start || m->running) && !stop && !m->fault;
    if (m->running) {
        m->speed = step_to(m->speed, set_speed, 25);
        m->hours++;
    } else {
        m->speed = step_to(m->speed, 0, 50);
    }
}

void scan(void)
{
    int32_t sum = 0;
    float total = 0.0f;

    n++;
    for (int i = 0; i < 80; i++) {
        seed = seed * 1103515245u + 12345u;
        analog(&ai[i], (int16_t)(seed / 65536 % 28500), 0.0f, 120.0f);
        total += ai[i].value;
    }
    for (int i = 0; i < 60; i++) {
        valve(&vlv[i], (n + (i + 1) * 3) % 50 < 25, ai[i].alarm_hi);
        sum += vlv[i].pos;
        if (vlv[i].is_closed)
            sum++;
    }
    for (int i = 0; i < 60; i++) {
        motor(&mot[i], vlv[i].is_open, (n + i + 1) % 97 == 0, ai[i + 20].broken && ai[i].alarm_lo,
              (int16_t)(1500 - vlv[i].pos / 2));
        sum += mot[i].speed;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + (int32_t)total));
}
