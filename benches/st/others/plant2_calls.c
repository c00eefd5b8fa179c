#include <stdbool.h>
#include "st.h"

#define N 50

typedef enum { CLOSED, OPENING, OPEN, CLOSING, FAULT } ValveState;
typedef struct { ValveState state; bool fb_open, fb_closed, fault; int16_t pos, stuck; int32_t status; } Valve;
typedef struct { bool run, at_speed, old; float speed; int32_t status, starts; } Motor;
typedef struct { float value; bool hi, lo, broken; int32_t status; } Analog;
typedef struct { int32_t litres; float part; bool done; } Total;

static Valve valve[N];
static Motor motor[N];
static Analog analog[N];
static Total total[N];
static int32_t nscan;

static float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static bool hyst(float in, float on, float off, bool old)
{
    return in > on || (old && in > off);
}

static bool permit(bool cmd, bool ilk1, bool ilk2, int mode)
{
    switch (mode) {
    case 0: return false;
    case 1: return cmd && ilk1;
    case 2: return cmd && ilk1 && ilk2;
    default: return cmd;
    }
}

static int32_t status_word(bool a, bool b, bool c, bool d)
{
    return a | b << 1 | c << 2 | d << 3;
}

static void valve_step(Valve *v, bool cmd, bool ilk, int mode, int16_t travel)
{
    bool go = permit(cmd, ilk, !v->fault, mode);
    switch (v->state) {
    case CLOSED:
        v->pos = 0;
        if (go) v->state = OPENING;
        break;
    case OPENING:
        v->pos++;
        if (!go) {
            v->state = CLOSING;
            v->stuck++;
        } else if (v->pos >= travel) {
            v->state = OPEN;
            v->stuck = 0;
        }
        break;
    case OPEN:
        if (!go) v->state = CLOSING;
        break;
    case CLOSING:
        v->pos--;
        if (v->pos <= 0) v->state = CLOSED;
        if (v->stuck > 3) v->state = FAULT;
        break;
    case FAULT:
        v->pos = 0;
        v->stuck--;
        if (v->stuck <= 0) v->state = CLOSED;
        break;
    }
    v->fb_open = v->state == OPEN;
    v->fb_closed = v->state == CLOSED;
    v->fault = v->state == FAULT;
    v->status = status_word(v->fb_open, v->fb_closed, v->fault, go);
}

static void motor_step(Motor *m, bool start, bool stop, bool ilk, int mode, float sp)
{
    m->run = permit(start || m->run, ilk, !stop, mode) && !stop;
    if (m->run) {
        m->speed += limit(-2.5f, sp - m->speed, 2.5f);
    } else {
        float s = m->speed - 4.0f;
        m->speed = s > 0.0f ? s : 0.0f;
    }
    if (m->run && !m->old) m->starts++;
    m->old = m->run;
    m->at_speed = hyst(m->speed, 0.95f * sp, 0.85f * sp, m->at_speed);
    m->status = status_word(m->run, m->at_speed, ilk, stop);
}

static void analog_step(Analog *a, int16_t raw, float lo, float hi)
{
    a->broken = raw < 200 || raw > 27500;
    if (!a->broken) a->value += 0.25f * (scale(raw, lo, hi) - a->value);
    a->hi = hyst(a->value, 60.0f, 55.0f, a->hi);
    a->lo = hyst(-a->value, -40.0f, -45.0f, a->lo);
    a->status = status_word(a->hi, a->lo, a->broken, false);
}

static void total_step(Total *t, float flow, bool enable, bool reset)
{
    if (reset) {
        t->litres = 0;
        t->part = 0.0f;
    } else if (enable) {
        t->part += flow * 0.05f;
        while (t->part >= 1.0f) {
            t->part -= 1.0f;
            t->litres++;
        }
    }
    t->done = t->litres >= 250;
}

void scan(void)
{
    uint32_t sum = 0;
    nscan++;
    for (int i = 1; i <= N; i++) {
        Analog *a = &analog[i - 1];
        Motor *m = &motor[i - 1];
        Valve *v = &valve[i - 1];
        Total *t = &total[i - 1];
        int32_t ph = nscan + i * 13;
        analog_step(a, (int16_t)(ph * 173 % 27648), 0.0f, 100.0f);
        motor_step(m, ph % 61 == 0, ph % 197 == 0, !a->broken || ph % 3 == 0, i % 4, 30.0f + (float)i);
        valve_step(v, ph % 47 > 15, m->at_speed || a->lo || i > 25, (i + 1) % 4, (int16_t)(5 + i % 16));
        total_step(t, a->value * 0.3f, v->fb_open, t->done);
        sum = sum * 3 + (uint32_t)(v->status + m->status * 16 + a->status * 256 + t->litres + m->starts);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
