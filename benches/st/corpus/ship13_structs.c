#include <math.h>
#include <stdbool.h>
#include "st.h"

#define TANKS 40
#define SENSORS 4
#define EVENTS 64

typedef struct { int16_t low, high, hyst; } Limits;

typedef struct {
    int16_t raw;
    float value;
    bool low, high;
    Limits lim;
} Sensor;

typedef struct {
    int32_t id;
    bool in_use;
    Sensor sens[SENSORS];
    float volume;
    int32_t trips;
} Tank;

typedef struct {
    int32_t stamp, tank;
    int16_t sensor;
    bool high;
    float value;
} Event;

static Tank tank[TANKS];
static Event event[EVENTS];
static int head;
static bool ready;
static int32_t scans;
static uint32_t crc;

static void init(void)
{
    for (int i = 0; i < TANKS; i++) {
        tank[i].id = 100 + i;
        tank[i].in_use = i % 7 != 3;
        for (int s = 0; s < SENSORS; s++) {
            Sensor *p = &tank[i].sens[s];
            p->raw = (i * 31 + s * 257) % 1000;
            p->lim.low = 150 + s * 10;
            p->lim.high = 850 - s * 20;
            p->lim.hyst = 25;
        }
    }
}

void scan(void)
{
    if (!ready) {
        init();
        ready = true;
    }
    scans++;

    for (int i = 0; i < TANKS; i++) {
        Tank *t = &tank[i];
        if (!t->in_use)
            continue;
        t->volume = 0.0f;
        for (int s = 0; s < SENSORS; s++) {
            Sensor *p = &t->sens[s];
            p->raw = (p->raw + 3 + s * 2) % 1000;
            p->value = (float)p->raw * 0.025f;
            t->volume += p->value;

            bool high_old = p->high, low_old = p->low;
            if (p->raw > p->lim.high)
                p->high = true;
            else if (p->raw < p->lim.high - p->lim.hyst)
                p->high = false;
            if (p->raw < p->lim.low)
                p->low = true;
            else if (p->raw > p->lim.low + p->lim.hyst)
                p->low = false;

            if ((p->high && !high_old) || (p->low && !low_old)) {
                event[head] = (Event){.stamp = scans, .tank = t->id, .sensor = s,
                                      .high = p->high, .value = p->value};
                head = (head + 1) % EVENTS;
                t->trips++;
            }
        }
    }

    int max = 0;
    float vmax = -1.0f, total = 0.0f;
    for (int i = 0; i < TANKS; i++) {
        total += tank[i].volume;
        if (tank[i].in_use && tank[i].volume > vmax) {
            vmax = tank[i].volume;
            max = i;
        }
        crc += (uint32_t)tank[i].trips * (uint32_t)(i + 1);
    }
    if (max != 0) {
        Tank swap = tank[0];
        tank[0] = tank[max];
        tank[max] = swap;
    }

    int32_t open = 0;
    for (int i = 0; i < EVENTS; i++) {
        if (scans - event[i].stamp < 20 && event[i].high)
            open += event[i].tank + event[i].sensor;
    }

    crc = crc * 31 + open + tank[0].id + (uint32_t)(int32_t)lrintf(total * 20.0f) +
          (uint32_t)(int32_t)lrintf(event[(head + EVENTS - 1) % EVENTS].value * 40.0f);
    check = (int32_t)crc;
}
