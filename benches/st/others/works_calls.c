/* Device layer of a process unit: 80 valves, 60 motors, 60 analog inputs = 200 FB calls */
#include <stdbool.h>
#include "st.h"

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static int16_t limit_int(int16_t mn, int16_t x, int16_t mx)
{
    if (x < mn)
        return mn;
    else if (x > mx)
        return mx;
    return x;
}

static int32_t mix(int32_t h, int32_t v)     /* order-sensitive fold */
{
    return (h * 17 + v) % 9999991;
}

typedef struct {
    bool out, fault;
    int16_t state;          /* 0 closed, 1 opening, 2 open, 3 closing, 9 fault */
    int16_t travel;
} Valve;

static void valve_run(Valve *v, bool cmdOpen, bool fbOpen, bool fbClosed, bool interlock, int16_t travelMax)
{
    switch (v->state) {
    case 0:
        v->travel = 0;
        if (cmdOpen && !interlock)
            v->state = 1;
        break;
    case 1:
        v->travel = limit_int(0, v->travel + 1, 1000);
        if (fbOpen)
            v->state = 2;
        else if (v->travel > travelMax)
            v->state = 9;
        else if (!cmdOpen || interlock)
            v->state = 3;
        break;
    case 2:
        v->travel = 0;
        if (!cmdOpen || interlock)
            v->state = 3;
        break;
    case 3:
        v->travel = limit_int(0, v->travel + 1, 1000);
        if (fbClosed)
            v->state = 0;
        else if (v->travel > travelMax)
            v->state = 9;
        break;
    default:
        if (fbClosed && !cmdOpen)
            v->state = 0;
        break;
    }
    v->out = v->state == 1 || v->state == 2;
    v->fault = v->state == 9;
}

typedef struct {
    bool running, tripped;
    int16_t speed;
    int32_t hours;
} Motor;

static void motor_run(Motor *m, bool start, bool stop, bool overload, int16_t speedSp)
{
    m->tripped = (m->tripped || overload) && !stop;
    m->running = (m->running || start) && !stop && !m->tripped;
    if (m->running) {
        int16_t tmp = limit_int(-50, speedSp - m->speed, 50);    /* ramp */
        m->speed += tmp;
        m->hours++;
        if (m->hours >= 1000000)
            m->hours = 0;
    } else {
        m->speed = limit_int(0, m->speed - 100, 3000);
    }
}

typedef struct {
    float value;
    bool hiAl, loAl, wireBreak;
} Analog;

static void analog_run(Analog *a, int16_t raw, float lo, float hi, float alarmHi, float alarmLo, float hyst)
{
    float x;

    a->wireBreak = raw < -4864;
    x = scale(limit_int(0, raw, 27648), lo, hi);
    a->value = a->value + (x - a->value) * 0.25f;
    if (a->value > alarmHi)
        a->hiAl = true;
    else if (a->value < alarmHi - hyst)
        a->hiAl = false;
    if (a->value < alarmLo)
        a->loAl = true;
    else if (a->value > alarmLo + hyst)
        a->loAl = false;
}

static Valve valve[81];
static Motor motor[61];
static Analog analog[61];
static int16_t n;

void scan(void)
{
    int16_t i, ph, faults = 0;
    int32_t h = 0;

    n = (n + 1) % 5000;

    for (i = 1; i <= 80; i++) {
        ph = (n + i * 7) % 60;
        valve_run(&valve[i], ph < 30, ph > 6 && ph < 32, ph > 34 + i % 16,
                  (n + i) % 211 == 0, 12);
        if (valve[i].out)
            h = mix(h, valve[i].state);
        if (valve[i].fault)
            faults++;
    }

    for (i = 1; i <= 60; i++) {
        motor_run(&motor[i], (n + i) % 40 == 3, (n + i * 3) % 90 == 7,
                  (n + i * 11) % 333 == 1, 500 + i * 20);
        h = mix(h, (int32_t)motor[i].speed + motor[i].hours);
        if (motor[i].tripped)
            faults++;
    }

    for (i = 1; i <= 60; i++) {
        int16_t raw = ((n % 128) * (180 + i)) % 28000 - 100 + i;
        analog_run(&analog[i], raw, 0.0f, 150.0f, 110.0f, 15.0f, 2.5f);
        if (analog[i].hiAl || analog[i].loAl || analog[i].wireBreak)
            faults++;
        h = mix(h, (int32_t)(analog[i].value * 10.0f));
    }

    check = mix(check, h + faults);
}
