#include <math.h>
#include <stdbool.h>
#include "st.h"

typedef enum { GEN_STOP, GEN_START, GEN_IDLE, GEN_LOAD, GEN_COOL } GenState;

static inline float scale(int16_t raw, float low, float high)
{
    return low + (float)raw * (high - low) / 27648.0f;
}

static inline int16_t clamp(int16_t low, int16_t x, int16_t high)
{
    if (x < low)
        x = low;
    return x > high ? high : x;
}

static inline int16_t ramp(int16_t act, int16_t target, int16_t step)
{
    int16_t x;
    if (act < target) {
        x = act + step;
        return x < target ? x : target;
    }
    x = act - step;
    return x > target ? x : target;
}

typedef struct {
    int16_t pos, old;
    bool opened, closed;
    int32_t moves;
} Valve;

typedef struct {
    float level;
    bool high, low;
    int16_t raw;
} Tank;

typedef struct {
    GenState state;
    int16_t rpm, power, cool;
} GenSet;

static void valve_run(Valve *v, bool open, bool close, int16_t step)
{
    if (open && !close)
        v->pos = ramp(v->pos, 1000, step);
    else if (close)
        v->pos = ramp(v->pos, 0, step);
    if (v->pos != v->old)
        v->moves++;
    v->old = v->pos;
    v->opened = v->pos >= 990;
    v->closed = v->pos <= 10;
}

static void tank_run(Tank *t, int16_t inflow, int16_t outflow)
{
    t->raw = clamp(0, t->raw + (inflow - outflow) / 8, 27648);
    t->level = scale(t->raw, 0.0f, 12.5f);
    t->high = t->level > 11.0f || (t->high && t->level > 10.5f);
    t->low = t->level < 1.0f || (t->low && t->level < 1.5f);
}

static void gen_run(GenSet *g, bool start, bool stop, int16_t load)
{
    switch (g->state) {
    case GEN_STOP:
        g->rpm = ramp(g->rpm, 0, 25);
        if (start && !stop)
            g->state = GEN_START;
        break;
    case GEN_START:
        g->rpm = ramp(g->rpm, 900, 40);
        if (g->rpm >= 900)
            g->state = GEN_IDLE;
        break;
    case GEN_IDLE:
        if (stop) {
            g->state = GEN_COOL;
            g->cool = 12;
        } else if (load > 50) {
            g->state = GEN_LOAD;
        }
        break;
    case GEN_LOAD:
        g->power = ramp(g->power, clamp(0, load, 850), 30);
        g->rpm = 900 - g->power / 40;
        if (stop || load < 20) {
            g->state = GEN_COOL;
            g->cool = 20;
        }
        break;
    case GEN_COOL:
        g->power = ramp(g->power, 0, 60);
        if (--g->cool <= 0)
            g->state = GEN_STOP;
        break;
    }
}

static Valve valve[80];
static Tank tank[80];
static GenSet gen[40];
static bool ready;
static int16_t scans;
static uint32_t crc;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 80; i++)
            tank[i].raw = 13824;
        ready = true;
    }
    scans = (scans + 1) % 3000;

    for (int i = 0; i < 80; i++) {
        int phase = (scans + i * 9) % 120;
        valve_run(&valve[i], phase < 55, phase > 65, 20 + i % 7);
        if (valve[i].opened)
            crc += 3;
        else if (valve[i].closed)
            crc += 5;
    }

    float levels = 0.0f;
    for (int i = 0; i < 80; i++) {
        tank_run(&tank[i], valve[i].pos, valve[79 - i].pos);
        levels += tank[i].level;
        if (tank[i].high || tank[i].low)
            crc += i;
    }

    for (int i = 0; i < 40; i++) {
        gen_run(&gen[i], (scans + i) % 50 == 0, (scans + 3 * i) % 170 == 0, valve[2 * i].pos);
        crc = crc * 3 + gen[i].rpm + gen[i].power;
        if (gen[i].state == GEN_LOAD)
            crc += 1;
    }

    crc = crc * 31 + (uint32_t)(int32_t)lrintf(levels * 10.0f);
    check = (int32_t)crc;
}
