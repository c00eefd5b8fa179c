/* Tank farm: tanks, recipes and an event log as arrays of structures. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define TANKS 32
#define EVENTS 64
#define PHASES 5

enum phase { IDLE, FILLING, FERMENTING, COOLING, EMPTYING };

struct sensor {
    float value, filtered, min, max;
    bool alarm;
};

struct recipe {
    int32_t volume;
    float ferm, cold;
    int16_t scans;
};

struct tank {
    enum phase phase;
    int16_t recipe;
    int32_t volume;
    int16_t timer;
    struct sensor temp, press;
    int16_t hist[8];
    int16_t hist_pos;
    int32_t batch;
};

struct event {
    int32_t scan;
    int16_t tank;
    enum phase phase;
    float temp;
};

struct rank {
    int16_t tank;
    int32_t volume;
};

static const struct recipe recipes[4] = {
    {400, 10.0f, 1.0f, 60},
    {600, 12.0f, 2.0f, 80},
    {500, 20.0f, 4.0f, 50},
    {300, 16.0f, 3.0f, 40},
};
static struct tank tanks[TANKS];
static struct event events[EVENTS];
static struct rank ranks[TANKS];
static uint32_t seed = 99;
static int event_pos;
static bool init_done;
static int32_t scans;

static void init(void)
{
    for (int i = 0; i < TANKS; i++) {
        struct tank *t = &tanks[i];
        t->recipe = (int16_t)((i + 1) % 4);
        t->temp.filtered = 10.0f;
        t->temp.max = 18.0f + (float)((i + 1) % 5);
        t->press.max = 1.2f;
        ranks[i].tank = (int16_t)i;
    }
    init_done = true;
}

static void sensor_update(struct sensor *s, float value)
{
    s->value = value;
    s->filtered += 0.1f * (value - s->filtered);
    s->alarm = s->filtered < s->min || s->filtered > s->max;
}

/* Returns whether the phase has changed. */
static bool tank_phase(struct tank *t, const struct recipe *r, bool start)
{
    t->timer++;
    switch (t->phase) {
    case IDLE:
        if (start) {
            t->phase = FILLING;
            return true;
        }
        break;
    case FILLING:
        t->volume += 25;
        if (t->volume >= r->volume) {
            t->phase = FERMENTING;
            t->timer = 0;
            return true;
        }
        break;
    case FERMENTING:
        if (t->timer >= r->scans && !t->temp.alarm) {
            t->phase = COOLING;
            return true;
        }
        break;
    case COOLING:
        if (t->temp.filtered <= r->cold + 0.5f) {
            t->phase = EMPTYING;
            return true;
        }
        break;
    case EMPTYING:
        t->volume -= 40;
        if (t->volume <= 0) {
            t->volume = 0;
            t->batch++;
            t->phase = IDLE;
            return true;
        }
        break;
    }
    return false;
}

void scan(void)
{
    int phases[PHASES] = {0};

    if (!init_done)
        init();
    scans++;

    for (int i = 0; i < TANKS; i++) {
        struct tank *t = &tanks[i];
        const struct recipe *r = &recipes[t->recipe];

        seed = seed * 1664525u + 1013904223u;
        float noise = (float)(seed >> 24) * 0.01f - 1.28f;
        float target = t->phase == COOLING || t->phase == EMPTYING ? r->cold : r->ferm;
        sensor_update(&t->temp, target + noise);
        sensor_update(&t->press, (float)t->volume * 0.002f + noise * 0.1f);

        if (tank_phase(t, r, (seed >> 12) % 16 == 0)) {
            events[event_pos] = (struct event){scans, (int16_t)(i + 1), t->phase, t->temp.filtered};
            event_pos = (event_pos + 1) % EVENTS;
            if (t->phase == IDLE)
                t->recipe = (int16_t)((t->recipe + 1) % 4);
        }

        t->hist[t->hist_pos] = (int16_t)lrintf(t->temp.filtered * 10.0f);
        t->hist_pos = (int16_t)((t->hist_pos + 1) % 8);
        phases[t->phase]++;
    }

    for (int i = 0; i < TANKS; i++)
        ranks[i].volume = tanks[ranks[i].tank].volume;
    for (int i = 0; i < TANKS - 1; i++)
        if (ranks[i].volume < ranks[i + 1].volume) {
            struct rank swap = ranks[i];
            ranks[i] = ranks[i + 1];
            ranks[i + 1] = swap;
        }

    uint32_t sum = 0;
    for (int i = 0; i < TANKS; i++) {
        const struct tank *t = &tanks[i];
        sum = sum * 3u + (uint32_t)t->volume + (uint32_t)t->batch + (uint32_t)(ranks[i].tank + 1);
        if (t->temp.alarm || t->press.alarm)
            sum += 7;
        for (int k = 0; k < 8; k++)
            sum += (uint32_t)t->hist[k];
    }
    for (int k = 0; k < PHASES; k++)
        sum = sum * 33u + (uint32_t)phases[k];
    for (int k = 0; k < EVENTS; k++)
        sum += (uint32_t)events[k].scan * (uint32_t)events[k].tank;
    check = (int32_t)((uint32_t)check * 31u + sum);
}
