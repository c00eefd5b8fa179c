/* 200 calls of four kinds of blocks, which call functions */
#include <stdbool.h>
#include "st.h"

static int32_t clamp(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : x > high ? high : x;
}

static int32_t scale(int16_t raw, int32_t low, int32_t high)
{
    return clamp(low + raw * (high - low) / 4096, low, high);
}

static bool hysteresis(bool old, int32_t x, int32_t on, int32_t off)
{
    return old ? x > off : x >= on;
}

static uint32_t mix(uint32_t hash, uint32_t x)
{
    uint32_t h = 17 + hash;
    for (uint32_t round = 1; round <= 3; round++)
        h = h * 33 + x + round;
    return h;
}

struct analog { int32_t value; bool alarm; };
struct valve { int32_t position; bool moving; };
enum motor_state { IDLE, STARTING, RUNNING, TRIPPED };
struct motor { enum motor_state state; int16_t wait; int32_t starts; };
struct totalizer { int32_t remainder; };

static void analog_run(struct analog *a, int16_t raw, int32_t high)
{
    a->value = (a->value * 3 + scale(raw, -500, high)) / 4;
    a->alarm = hysteresis(a->alarm, a->value, high / 2, high / 3);
}

static void valve_run(struct valve *v, bool open, int32_t speed)
{
    int32_t old = v->position;
    v->position = clamp(open ? old + speed : old - speed, 0, 1000);
    v->moving = v->position != old;
}

static void motor_run(struct motor *m, bool run, bool trip)
{
    switch (m->state) {
    case IDLE:
        if (run && !trip) {
            m->state = STARTING;
            m->wait = 3;
        }
        break;
    case STARTING:
        if (--m->wait <= 0) {
            m->state = RUNNING;
            m->starts++;
        }
        break;
    case RUNNING:
        if (trip)
            m->state = TRIPPED;
        else if (!run)
            m->state = IDLE;
        break;
    case TRIPPED:
        if (!run && !trip)
            m->state = IDLE;
        break;
    }
}

static void totalizer_run(struct totalizer *t, int32_t flow, uint32_t *total)
{
    t->remainder += clamp(flow, 0, 5000);
    *total = mix(*total, (uint32_t)(t->remainder / 60));
    t->remainder %= 60;
}

static struct analog analogs[50];
static struct valve valves[50];
static struct motor motors[50];
static struct totalizer meters[50];
static int32_t tick;

void scan(void)
{
    tick++;
    uint32_t total = (uint32_t)tick;
    for (int i = 0; i < 50; i++) {
        int32_t number = i + 1;
        int16_t raw = (int16_t)((tick * 37 + number * number * 11) % 4096);
        analog_run(&analogs[i], raw, 3000 + number);
        valve_run(&valves[i], analogs[i].alarm, 10 + number);
        motor_run(&motors[i], valves[i].position > 300, raw > 4000);
        totalizer_run(&meters[i], valves[i].position * (int32_t)motors[i].state + analogs[i].value, &total);
    }
    check = (int32_t)((uint32_t)check * 31u + mix(total, (uint32_t)motors[6].starts));
}
