#include "st.h"
#include <stdbool.h>

enum motor_state { MOT_STOPPED, MOT_STARTING, MOT_RUNNING, MOT_FAULT };
struct scale { int16_t raw_min, raw_max; float eng_min, eng_max; };
struct analog { float value; bool high, high_high, wire; };
struct totalizer { int32_t litres; float rest; };
struct motor { enum motor_state state; int16_t starts, timer; int32_t hours; };

static struct analog ai[80];
static struct totalizer tot[60];
static struct motor mot[60];
static struct scale scaling = { 0, 27648, 0.0f, 150.0f };
static int32_t scans;

static float scale(int16_t raw, const struct scale *s)
{
    return (float)(int16_t)(raw - s->raw_min) / (float)(int16_t)(s->raw_max - s->raw_min)
           * (s->eng_max - s->eng_min) + s->eng_min;
}

static bool hyst(float in, float limit, float h, bool old)
{
    return old ? in > limit - h : in > limit;
}

static int16_t add_sat(int16_t a, int16_t b, int16_t max)
{
    int16_t s = (int16_t)(a + b);
    return s < max ? s : max;
}

static int32_t wrap(int32_t in, int32_t mod)
{
    return in >= mod ? in - mod : in;
}

static void analog_run(struct analog *a, int16_t raw, const struct scale *s)
{
    a->wire = raw < s->raw_min || raw > s->raw_max;
    if (!a->wire)
        a->value = a->value * 0.75f + scale(raw, s) * 0.25f;
    a->high = hyst(a->value, 90.0f, 3.0f, a->high);
    a->high_high = hyst(a->value, 110.0f, 2.0f, a->high_high);
}

static void totalizer_run(struct totalizer *t, float flow, bool reset)
{
    if (reset)
        t->litres = 0;
    t->rest += (flow > 0.0f ? flow : 0.0f) * 0.1f;
    int32_t whole = (int32_t)t->rest;
    t->rest -= (float)whole;
    t->litres = wrap(t->litres + whole, 100000);
}

static void motor_run(struct motor *m, bool start, bool stop, bool trip)
{
    switch (m->state) {
    case MOT_STOPPED:
        if (start && !stop) {
            m->state = MOT_STARTING;
            m->starts = add_sat(m->starts, 1, 30000);
            m->timer = 0;
        }
        break;
    case MOT_STARTING:
        m->timer = add_sat(m->timer, 1, 100);
        if (m->timer >= 5)
            m->state = MOT_RUNNING;
        break;
    case MOT_RUNNING:
        m->hours = wrap(m->hours + 1, 99999);
        if (stop)
            m->state = MOT_STOPPED;
        break;
    case MOT_FAULT:
        if (stop && !trip)
            m->state = MOT_STOPPED;
        break;
    }
    if (trip)
        m->state = MOT_FAULT;
}

void scan(void)
{
    int32_t sum = 0;
    scans++;
    for (int i = 0; i < 80; i++) {
        int32_t raw = (int32_t)((uint32_t)scans * 97u + (uint32_t)i * 1231u) % 28000;
        analog_run(&ai[i], (int16_t)raw, &scaling);
        if (ai[i].high) sum += 1;
        if (ai[i].high_high) sum += 3;
        if (ai[i].wire) sum += 5;
    }
    for (int i = 0; i < 60; i++) {
        totalizer_run(&tot[i], ai[i].value - 20.0f, (scans + i) % 5000 == 0);
        sum += tot[i].litres;
    }
    for (int i = 0; i < 60; i++) {
        int32_t phase = (scans + i * 13) % 103;
        motor_run(&mot[i], phase == 10, phase > 80, ai[i].high_high && phase == 50);
        sum += mot[i].hours + mot[i].starts;
        if (mot[i].state == MOT_FAULT) sum += 1000;
    }
    check = (int32_t)((uint32_t)check * 11u + (uint32_t)sum);
}
