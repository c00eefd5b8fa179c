#include "st.h"
#include <xmmintrin.h>
#include <stdbool.h>

static float scale(int16_t raw, float low, float high)
{
    return low + raw * (high - low) / 27648.0f;
}

static float clampf(float v, float low, float high)
{
    return v < low ? low : v > high ? high : v;
}

static int32_t wrap(int32_t v, int32_t modulo)
{
    v %= modulo;
    return v < 0 ? v + modulo : v;
}

typedef struct { float value; bool high_alarm, low_alarm; } analog_t;
typedef struct { int16_t state, position; bool opened, closed; } valve_t;
typedef struct { bool running, fault, last; float act_speed; int16_t starts; } motor_t;
typedef struct { float total; int32_t overflows; } total_t;

static void analog(analog_t *a, int16_t raw, float high)
{
    float scaled = clampf(scale(raw, 0.0f, 100.0f), 0.0f, 95.0f);
    a->value += (scaled - a->value) * 0.125f;
    a->high_alarm = a->value > high || (a->high_alarm && a->value > high - 2.0f);
    a->low_alarm = a->value < 10.0f || (a->low_alarm && a->value < 12.0f);
}

static void valve(valve_t *v, bool open, bool close)
{
    switch (v->state) {
    case 0:
        if (open && !close)
            v->state = 1;
        break;
    case 1:
        v->position += 8;
        if (close)
            v->state = 3;
        else if (v->position >= 100) {
            v->position = 100;
            v->state = 2;
        }
        break;
    case 2:
        if (close)
            v->state = 3;
        break;
    case 3:
        v->position -= 12;
        if (v->position <= 0) {
            v->position = 0;
            v->state = 0;
        }
        break;
    default:
        v->state = 0;
    }
    v->opened = v->state == 2;
    v->closed = v->state == 0;
}

static void motor(motor_t *m, bool start, bool stop, bool trip, float speed)
{
    if (trip)
        m->fault = true;
    else if (stop)
        m->fault = false;
    m->running = (m->running || start) && !stop && !m->fault;
    if (m->running && !m->last)
        m->starts++;
    m->last = m->running;
    m->act_speed = clampf(m->running ? m->act_speed + 4.0f : m->act_speed - 6.0f, 0.0f, speed);
}

static void totalizer(total_t *t, float flow, bool reset)
{
    if (reset)
        t->total = 0.0f;
    t->total += flow * 0.01f;
    if (t->total > 500.0f) {
        t->total -= 500.0f;
        t->overflows++;
    }
}

static analog_t ai[50];
static valve_t valves[50];
static motor_t motors[50];
static total_t totals[50];
static int32_t scans;

void scan(void)
{
    scans++;
    int32_t n = 0;
    for (int i = 1; i <= 50; i++) {
        analog_t *a = &ai[i - 1];
        valve_t *v = &valves[i - 1];
        motor_t *m = &motors[i - 1];
        total_t *t = &totals[i - 1];
        int32_t phase = wrap(scans * 3 - i * 11, 200);
        analog(a, phase * 130, 70.0f);
        valve(v, a->high_alarm, a->low_alarm);
        motor(m, v->opened, v->closed, phase == 77, 50.0f);
        totalizer(t, a->value * m->act_speed, phase == 199 && i > 40);
        if (a->high_alarm)
            n++;
        if (a->low_alarm)
            n += 3;
        if (m->running)
            n += i;
        n += v->state * 5 + m->starts + t->overflows + _mm_cvt_ss2si(_mm_set_ss(t->total));
    }
    check = (check + n) % 1000000;
}
