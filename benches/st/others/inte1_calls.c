/* 200 block calls: 60 analog inputs, 60 motors, 50 valves, 30 totalizers, with small functions */
#include <stdbool.h>
#include "st.h"

struct analog { float value; bool alarm, broken; float filt; };
struct motor  { bool out, fault; int16_t starts; int32_t run_scans; bool out_old; int16_t tmo; };
struct valve  { int16_t pos; bool is_open, is_closed, moving; };
struct total  { int32_t total; float rest; };

static int32_t scan_no;
static struct analog ai[60];
static struct motor mot[60];
static struct valve vlv[50];
static struct total tot[30];
static int16_t raw[60];
static uint32_t seed = 7;

static float scale(int16_t r, float lo, float hi)
{
    return lo + (float)r * (hi - lo) / 27648.0f;
}

static float clamp(float x, float mn, float mx)
{
    if (x < mn)
        return mn;
    if (x > mx)
        return mx;
    return x;
}

static bool hyst(float x, float limit, float h, bool old)
{
    if (old)
        return x > limit - h;
    return x > limit;
}

static bool interlock(bool a, bool b, bool c, bool bypass)
{
    return (a && b && c) || bypass;
}

static int16_t step(int16_t pos, int16_t target, int16_t rate)
{
    if (target > pos + rate)
        return pos + rate;
    if (target < pos - rate)
        return pos - rate;
    return target;
}

static void analog_run(struct analog *a, int16_t r, float lo, float hi, float alarm_hi)
{
    a->broken = r < -1000 || r > 28500;
    if (!a->broken)
        a->filt = a->filt + (scale(r, lo, hi) - a->filt) * 0.125f;
    a->value = clamp(a->filt, lo, hi);
    a->alarm = hyst(a->value, alarm_hi, 2.0f, a->alarm);
}

static void motor_run(struct motor *m, bool cmd, bool fb, bool prot, bool ack)
{
    if (ack)
        m->fault = false;
    m->out = cmd && interlock(prot, !m->fault, m->starts < 30000, false);
    if (m->out && !m->out_old) {
        m->starts++;
        m->tmo = 0;
    }
    if (m->out) {
        m->run_scans++;
        if (fb) {
            m->tmo = 0;
        } else {
            m->tmo++;
            if (m->tmo > 20)
                m->fault = true;
        }
    }
    if (!prot)
        m->fault = true;
    m->out_old = m->out;
}

static void valve_run(struct valve *v, bool open, int16_t setpos, int16_t rate)
{
    int16_t target, old_pos;

    target = open ? setpos : 0;
    old_pos = v->pos;
    v->pos = step(v->pos, target, rate);
    v->is_open = v->pos >= 980;
    v->is_closed = v->pos <= 20;
    v->moving = v->pos != old_pos;
}

static void total_run(struct total *t, float flow, bool reset)
{
    if (reset) {
        t->total = 0;
        t->rest = 0.0f;
    }
    t->rest = t->rest + clamp(flow, 0.0f, 1000.0f) * 0.01f;
    if (t->rest >= 1.0f) {
        t->total += (int32_t)t->rest;
        t->rest = t->rest - (float)(int32_t)t->rest;
    }
}

void scan(void)
{
    int i, k;
    int32_t sum_t, sum_pos, n;
    float sum_v;

    scan_no++;

    /* new raw values for some cards */
    for (i = 1; i <= 6; i++) {
        seed = seed * 1664525u + 1013904223u;
        k = (seed / 65536) % 60;
        raw[k] = (seed / 256) % 29000;
    }

    sum_t = 0;
    sum_pos = 0;
    sum_v = 0.0f;
    n = 0;

    for (i = 0; i < 60; i++) {
        analog_run(&ai[i], raw[i], 0.0f, 150.0f, 100.0f);
        sum_v = sum_v + ai[i].value;
        if (ai[i].alarm)
            n++;
    }

    for (i = 0; i < 60; i++) {
        motor_run(&mot[i], ai[i].alarm, mot[i].out && raw[i] % 16 != 3,
                  !ai[i].broken, scan_no % 100 == 0);
        if (mot[i].fault)
            n += 100;
        sum_t += mot[i].starts + mot[i].run_scans;
    }

    for (i = 0; i < 50; i++) {
        valve_run(&vlv[i], mot[i].out, 1000 - i, 15);
        sum_pos += vlv[i].pos;
        if (vlv[i].moving)
            n += 10000;
    }

    for (i = 0; i < 30; i++) {
        total_run(&tot[i], ai[i].value, scan_no % 1000 == 0);
        sum_t += tot[i].total;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n + (uint32_t)sum_t
                      + (uint32_t)sum_pos + (uint32_t)(int32_t)sum_v);
}
