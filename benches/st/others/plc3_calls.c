#include <stdbool.h>
#include "st.h"

static float scale_raw(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static int32_t clamp(int32_t mn, int32_t x, int32_t mx)
{
    if (x < mn)
        return mn;
    else if (x > mx)
        return mx;
    else
        return x;
}

static int16_t msg_code(int16_t unit, bool fault, bool warn)
{
    if (fault)
        return 1000 + unit;
    else if (warn)
        return 500 + unit;
    else
        return 0;
}

typedef struct {
    bool start, stop, feedback, reset;
    bool contactor, fault;
    int32_t speed;
    int16_t fbCount;
    bool startOld;
    int32_t starts;
} motor_t;

typedef struct {
    bool open, lsOpen, lsClosed;
    bool coil;
    int16_t state;
    int16_t travel;
} valve_t;

typedef struct {
    int16_t raw;
    float lo, hi, alarmHi, alarmLo;
    float value;
    bool high, low;
} analog_t;

static void motor(motor_t *m)
{
    if (m->reset) {
        m->fault = false;
        m->fbCount = 0;
    }
    if (m->start && !m->startOld && !m->fault) {
        m->contactor = true;
        m->starts++;
    }
    m->startOld = m->start;
    if (m->stop || m->fault)
        m->contactor = false;
    if (m->contactor && !m->feedback) {
        m->fbCount++;
        if (m->fbCount > 20)
            m->fault = true;
    } else {
        m->fbCount = 0;
    }
    if (m->contactor)
        m->speed = clamp(0, m->speed + 25, 1500);
    else
        m->speed = clamp(0, m->speed - 40, 1500);
}

static void valve(valve_t *v)
{
    v->coil = v->open;
    switch (v->state) {
    case 0:
        if (v->open) {
            v->state = 1;
            v->travel = 0;
        }
        break;
    case 1:
        v->travel++;
        if (v->lsOpen)
            v->state = 2;
        else if (v->travel > 15)
            v->state = 9;
        break;
    case 2:
        if (!v->open) {
            v->state = 3;
            v->travel = 0;
        }
        break;
    case 3:
        v->travel++;
        if (v->lsClosed)
            v->state = 0;
        else if (v->travel > 15)
            v->state = 9;
        break;
    case 9:
        if (!v->open && v->lsClosed)
            v->state = 0;
        break;
    }
}

static void analog_in(analog_t *a)
{
    a->value = a->value + 0.25f * (scale_raw(a->raw, a->lo, a->hi) - a->value);
    if (a->value > a->alarmHi)
        a->high = true;
    else if (a->value < a->alarmHi - 1.0f)
        a->high = false;
    if (a->value < a->alarmLo)
        a->low = true;
    else if (a->value > a->alarmLo + 1.0f)
        a->low = false;
}

static int16_t n;
static motor_t motors[80];
static valve_t valves[60];
static analog_t analogs[60];

void scan(void)
{
    int16_t i;
    int32_t sum = 0;
    float total = 0.0f;

    n++;
    if (n >= 2000)
        n = 0;

    for (i = 0; i < 80; i++) {
        motor_t *m = &motors[i];
        m->start = (n + i) % 50 == 3;
        m->stop = (n + i) % 170 == 160;
        m->feedback = m->contactor && (n + 3 * i) % 400 > 30;
        m->reset = n % 500 == 499;
        motor(m);
        sum += m->speed + msg_code(i, m->fault, false);
    }
    for (i = 0; i < 60; i++) {
        valve_t *v = &valves[i];
        v->open = motors[i].contactor;
        v->lsOpen = (n + i) % 11 == 0;
        v->lsClosed = (n + i) % 13 == 0;
        valve(v);
        sum += msg_code(100 + i, v->state == 9, v->state == 1 || v->state == 3);
    }
    for (i = 0; i < 60; i++) {
        analog_t *a = &analogs[i];
        a->raw = n * 13 + i * 20;
        a->lo = 0.0f;
        a->hi = 150.0f;
        a->alarmHi = 110.0f;
        a->alarmLo = 12.0f;
        analog_in(a);
        total = total + a->value;
        sum += msg_code(200 + i, a->high, a->low);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(int32_t)total);
}
