/* 400 function block calls per scan: 160 motors, 120 valves, 120 analog inputs, with small functions in them. */
#include <stdbool.h>
#include "st.h"

enum mode { OFF, STARTING, RUNNING, STOPPING, FAILED };

struct motor { bool contactor, fault, hot; float heat[6]; int32_t starts, hours; enum mode state; int16_t wait; };
struct valve { bool is_open, is_closed, leak; int32_t strokes; float flow; int16_t pos; bool old; };
struct analog { float value; bool high, low; float history[8]; int16_t next; };

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static bool hysteresis(bool old, float x, float on, float off)
{
    if (x >= on)
        return true;
    if (x <= off)
        return false;
    return old;
}

static float linearise(float x)        /* third order polynomial of the sensor */
{
    return ((0.000002f * x - 0.0004f) * x + 1.02f) * x - 0.5f;
}

static float approach(float act, float target, float tau)
{
    return act + (target - act) / tau;
}

static int16_t count_up(int16_t n, int16_t top)
{
    return n < top ? (int16_t)(n + 1) : top;
}

static void motor(struct motor *m, bool cmd, bool feedback, bool ack)
{
    switch (m->state) {
    case OFF:
        if (cmd) { m->state = STARTING; m->wait = 0; m->starts++; }
        break;
    case STARTING:
        m->wait = count_up(m->wait, 20);
        if (feedback) m->state = RUNNING; else if (m->wait == 20) m->state = FAILED;
        if (!cmd) { m->state = STOPPING; m->wait = 0; }
        break;
    case RUNNING:
        m->hours++;
        if (!cmd) { m->state = STOPPING; m->wait = 0; }
        break;
    case STOPPING:
        m->wait = count_up(m->wait, 15);
        if (!feedback) m->state = OFF; else if (m->wait == 15) m->state = FAILED;
        break;
    case FAILED:
        if (ack) m->state = OFF;
        break;
    }
    m->contactor = m->state == STARTING || m->state == RUNNING;
    m->fault = m->state == FAILED;
    float hottest = 0.0f;
    for (int w = 0; w < 6; w++) {
        m->heat[w] = approach(m->heat[w], m->contactor ? 110.0f + (float)w : 20.0f, m->contactor ? 15.0f : 40.0f);
        if (m->heat[w] > hottest) hottest = m->heat[w];
    }
    m->hot = hysteresis(m->hot, hottest, 90.0f, 60.0f);
}

static void valve(struct valve *v, bool open, int16_t travel)
{
    if (open) v->pos = count_up(v->pos, travel); else if (v->pos > 0) v->pos--;
    v->is_open = v->pos >= travel;
    v->is_closed = v->pos == 0;
    if (v->is_open && !v->old) v->strokes++;
    v->old = v->is_open;
    v->flow = approach(v->flow, linearise((float)v->pos * 100.0f / (float)travel), 5.0f);
    v->leak = hysteresis(v->leak, v->flow, 12.0f, 8.0f) && v->is_closed;
}

static void analog(struct analog *a, int16_t raw, float lo, float hi)
{
    float span = hi - lo;
    float x = linearise(scale(raw, lo, hi));
    a->history[a->next] = x;
    a->next = (int16_t)((a->next + 1) % 8);
    float mean = 0.0f;
    for (int k = 0; k < 8; k++)
        mean += a->history[k];
    a->value = approach(a->value, mean / 8.0f, 2.0f);
    a->high = hysteresis(a->high, a->value, lo + span * 0.7f, lo + span * 0.6f);
    a->low = !hysteresis(!a->low, a->value, lo + span * 0.4f, lo + span * 0.3f);
}

static int32_t seed = 7;
static struct motor motors[160];
static struct valve valves[120];
static struct analog inputs[120];

void scan(void)
{
    int16_t n = 0;
    int32_t sum = 0;
    float total = 0.0f;
    for (int i = 0; i < 120; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        analog(&inputs[i], (int16_t)(seed % 27649), -20.0f, 180.0f);
        total += inputs[i].value;
        if (inputs[i].high) n++;
        if (inputs[i].low) n += 2;
    }
    for (int i = 0; i < 120; i++) {
        valve(&valves[i], !inputs[i].low && !valves[i].is_open, (int16_t)(3 + i % 6));
        sum += valves[i].strokes;
        total += valves[i].flow;
        if (valves[i].is_closed && !valves[i].leak) n++;
    }
    for (int i = 0; i < 160; i++) {
        motor(&motors[i], !inputs[i % 120].high, motors[i].contactor && !valves[i * 3 / 4].is_open, inputs[119].high);
        sum = (int32_t)((uint32_t)sum + (uint32_t)motors[i].starts + (uint32_t)motors[i].hours);
        total += motors[i].heat[1];
        if (motors[i].hot) n++;
        if (motors[i].fault) n++;
    }
    check = (check * 31 + sum % 10007 + n + (int32_t)total) % 1000003;
}
