/* Section table of a tunnel: 32 sections with sensors and fans, an event log
   and a ranking of the sections by need of air. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define SECTIONS 32
#define EVENTS 64

typedef enum { LV_NORMAL, LV_WARNING, LV_ALARM } level_t;

typedef struct {
    int16_t raw;
    float value, peak;
    bool fault;
} sensor_t;

typedef struct {
    bool on;
    int16_t speed;
    int32_t run_scans;
} fan_t;

typedef struct {
    int16_t id;
    sensor_t co, visibility;
    fan_t fan[2];
    level_t level;
    int32_t vehicles, changes;
} section_t;

typedef struct {
    int32_t scan_no;
    int16_t section;
    level_t level;
    float value;
} event_t;

typedef struct {
    int16_t section;
    int32_t need;
} rank_t;

static bool init_done;
static uint32_t seed = 2024;
static int32_t scan_no;
static section_t sections[SECTIONS];
static event_t event_log[EVENTS];
static int log_next;
static rank_t rank[SECTIONS];

static inline uint32_t next_random(uint32_t s)
{
    return s * 1664525u + 1013904223u;
}

static bool sensor_update(sensor_t *s, int16_t raw, float span)
{
    s->raw = raw;
    s->fault = raw < 50;
    if (!s->fault)
        s->value += ((float)raw / 1000.0f * span - s->value) * 0.25f;
    float decayed = s->peak * 0.999f;
    s->peak = decayed > s->value ? decayed : s->value;
    return s->fault;
}

static void fan_update(fan_t *f, bool on)
{
    f->on = on;
    if (on) {
        f->speed = (int16_t)(f->speed + 50 < 1000 ? f->speed + 50 : 1000);
        f->run_scans++;
    } else {
        f->speed = (int16_t)(f->speed - 30 > 0 ? f->speed - 30 : 0);
    }
}

void scan(void)
{
    uint32_t faults = 0;

    if (!init_done) {
        for (int i = 0; i < SECTIONS; i++)
            sections[i].id = (int16_t)(101 + i);
        init_done = true;
    }
    scan_no++;

    for (int i = 0; i < SECTIONS; i++) {
        section_t *s = &sections[i];

        /* Sensors */
        seed = next_random(seed);
        if (sensor_update(&s->co, (int16_t)((seed >> 16) % 1000), 200.0f))
            faults++;
        if (sensor_update(&s->visibility, (int16_t)((seed >> 12) % 1000), 15.0f))
            faults++;
        s->vehicles += (int32_t)((seed >> 8) % 4);

        /* Level, with an event when it changes */
        level_t level;
        if (s->co.value > 130.0f || s->visibility.value > 10.5f)
            level = LV_ALARM;
        else if (s->co.value > 110.0f || s->visibility.value > 9.0f)
            level = LV_WARNING;
        else
            level = LV_NORMAL;
        if (level != s->level) {
            s->level = level;
            s->changes++;
            event_log[log_next] = (event_t){
                .scan_no = scan_no,
                .section = s->id,
                .level = level,
                .value = s->co.value,
            };
            log_next = (log_next + 1) % EVENTS;
        }

        /* Fans */
        fan_update(&s->fan[0], s->level != LV_NORMAL);
        fan_update(&s->fan[1], s->level == LV_ALARM);
    }

    /* Ranking by need of air: insertion sort, greatest first */
    for (int i = 0; i < SECTIONS; i++) {
        rank_t entry = {
            .section = (int16_t)(i + 1),
            .need = (int32_t)lrintf(sections[i].co.value * 10.0f) + sections[i].fan[0].speed,
        };
        int j = i - 1;
        while (j >= 0 && rank[j].need < entry.need) {
            rank[j + 1] = rank[j];
            j--;
        }
        rank[j + 1] = entry;
    }

    /* Checksum */
    uint32_t sum = 17;
    for (int i = 0; i < SECTIONS; i++) {
        const section_t *s = &sections[i];
        sum = sum * 31u + (uint32_t)rank[i].section + (uint32_t)rank[i].need;
        sum = sum * 31u + (uint32_t)(int32_t)lrintf(s->visibility.peak * 100.0f);
        sum = sum * 31u + (uint32_t)s->vehicles + (uint32_t)s->changes;
        sum = sum * 31u + (uint32_t)s->fan[0].run_scans + (uint32_t)s->fan[1].speed;
    }
    for (int i = 0; i < EVENTS; i++) {
        sum = sum * 31u + (uint32_t)event_log[i].scan_no + (uint32_t)event_log[i].section;
        if (event_log[i].level == LV_ALARM && event_log[i].value > 120.0f)
            sum += 1;
    }
    check = (int32_t)(sum * 31u + faults);
}
