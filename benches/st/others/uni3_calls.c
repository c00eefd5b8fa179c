/* 50 measuring points, each with four blocks: analog input, alarm, motor, totalizer = 200 block calls */
#include <stdbool.h>
#include "st.h"

#define POINTS 50

struct analog_in { float value; bool valid; };
struct alarm { bool hi_alarm, lo_alarm, old; int32_t count; };
struct motor { bool run; int32_t hours; int16_t state; };
struct totalizer { int32_t total; float part; };

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw / 27648.0f * (hi - lo);
}

static float clamp(float x, float mn, float mx)
{
    if (x < mn)
        return mn;
    if (x > mx)
        return mx;
    return x;
}

static bool hyst(float x, float on_at, float off_at, bool old)
{
    if (x >= on_at)
        return true;
    if (x <= off_at)
        return false;
    return old;
}

static int16_t next_state(int16_t state, bool start, bool stop, bool fault)
{
    switch (state) {
    case 0:
        if (start && !fault)
            return 1;
        break;
    case 1:
        return fault ? 9 : 2;
    case 2:
        if (fault)
            return 9;
        if (stop)
            return 3;
        break;
    case 3:
        return 0;
    case 9:
        if (!fault && stop)
            return 0;
        break;
    }
    return state;
}

static void analog_in(struct analog_in *b, int16_t raw, float lo, float hi, float tau)
{
    float x;

    b->valid = raw >= 0 && raw <= 27648;
    x = clamp(scale(raw, lo, hi), lo, hi);
    b->value = b->value + (x - b->value) * tau;
}

static void alarm_run(struct alarm *b, float x, float high, float low)
{
    b->hi_alarm = hyst(x, high, high - 2.0f, b->hi_alarm);
    b->lo_alarm = !hyst(x, low + 2.0f, low, !b->lo_alarm);
    if ((b->hi_alarm || b->lo_alarm) && !b->old)
        b->count++;
    b->old = b->hi_alarm || b->lo_alarm;
}

static void motor_run(struct motor *b, bool start, bool stop, bool fault)
{
    b->state = next_state(b->state, start, stop, fault);
    b->run = b->state == 1 || b->state == 2;
    if (b->run)
        b->hours++;
}

static void totalize(struct totalizer *b, float flow, bool enable)
{
    if (enable) {
        b->part = b->part + clamp(flow, 0.0f, 500.0f) * 0.01f;
        if (b->part >= 1.0f) {
            b->total += (int32_t)b->part;
            b->part = b->part - (float)(int32_t)b->part;
        }
    }
}

static int32_t tick;
static struct analog_in ai[POINTS + 1];
static struct alarm al[POINTS + 1];
static struct motor mo[POINTS + 1];
static struct totalizer tot[POINTS + 1];

void scan(void)
{
    int i;
    int16_t raw;
    uint32_t sum = 0;

    tick = (tick + 1) % 20000;
    for (i = 1; i <= POINTS; i++) {
        raw = (int16_t)((tick * 37 + i * 911) % 29000);
        analog_in(&ai[i], raw, -10.0f, 150.0f, 0.05f);
        alarm_run(&al[i], ai[i].value, 85.0f, 40.0f);
        motor_run(&mo[i], al[i].lo_alarm, al[i].hi_alarm, !ai[i].valid);
        totalize(&tot[i], ai[i].value, mo[i].run);
        sum += (uint32_t)(tot[i].total + al[i].count + mo[i].hours);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
