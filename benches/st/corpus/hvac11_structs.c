/* Forty rooms on six air handling units: arrays of structures */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

#define ROOMS 40
#define UNITS 6
#define HISTORY 32
#define ENTRIES 4

struct program_entry {
    int16_t start, end;
    float setpoint;
};

struct time_program {
    struct program_entry entries[ENTRIES];
    int16_t active;             /* 0: none, else number of the entry */
    float setpoint_night;
};

struct room {
    int16_t unit;
    bool occupied, window_open;
    float temperature, setpoint, air_quality, valve;
    struct time_program program;
    int32_t operating_seconds;
    uint16_t status, alarms;
};

struct unit {
    int16_t room_count;
    float max_demand, average_temperature, worst_air_quality;
    float supply_temperature, fan_speed;
    uint16_t status;
};

struct history_entry {
    int16_t room, minute;
    float temperature;
    uint16_t alarms;
};

static struct room rooms[ROOMS];
static struct unit units[UNITS];
static struct history_entry history[HISTORY];
static int history_index;
static int minute;
static bool initialized;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline float maxf(float a, float b)
{
    return a > b ? a : b;
}

static void init(void)
{
    for (int i = 0; i < ROOMS; i++) {
        struct room *r = &rooms[i];
        int n = i + 1;

        r->unit = (int16_t)(i % UNITS);
        r->temperature = 17.0f + (float)n * 0.1f;
        r->air_quality = 400.0f + (float)n * 5.0f;
        r->program.setpoint_night = 16.0f + (float)(n % 3) * 0.5f;
        for (int e = 1; e <= ENTRIES; e++) {
            struct program_entry *p = &r->program.entries[e - 1];
            p->start = (int16_t)(e * 300 + n * 3 - 200);
            p->end = (int16_t)(e * 300 + n * 5 - 50);
            p->setpoint = 19.5f + (float)e * 0.75f;
        }
    }
}

static void time_program_step(struct room *r)
{
    struct time_program *p = &r->program;

    r->setpoint = p->setpoint_night;
    p->active = 0;
    for (int e = 0; e < ENTRIES; e++) {
        if (minute >= p->entries[e].start && minute < p->entries[e].end) {
            r->setpoint = p->entries[e].setpoint;
            p->active = (int16_t)(e + 1);
            break;
        }
    }
}

static void room_step(struct room *r, const struct unit *u, int number, float outside)
{
    time_program_step(r);
    r->occupied = r->program.active > 0;
    r->window_open = (minute + number * 17) % 240 < 15;

    r->valve = r->window_open ? 0.0f : clampf(0.0f, (r->setpoint - r->temperature) * 40.0f, 100.0f);
    r->temperature = r->temperature
                     + r->valve * 0.004f
                     + (u->supply_temperature - r->temperature) * u->fan_speed * 0.0001f
                     - (r->temperature - outside) * 0.01f;
    if (r->occupied)
        r->air_quality = r->air_quality + 9.0f - u->fan_speed * 0.1f;
    else
        r->air_quality -= (r->air_quality - 400.0f) * 0.05f;
    if (r->valve > 0.0f)
        r->operating_seconds += 60;

    r->status = (uint16_t)(r->occupied << 0 | r->window_open << 1
                | (r->valve > 0.0f) << 2 | (r->valve >= 100.0f) << 3);
    r->alarms = (uint16_t)((r->temperature < 14.0f) << 0 | (r->air_quality > 1000.0f) << 1
                | (r->window_open && outside < 0.0f) << 2);
}

void scan(void)
{
    if (!initialized) {
        init();
        initialized = true;
    }

    minute = (minute + 1) % 1440;
    float outside = 8.0f - (float)abs(minute - 840) * 0.02f;
    uint32_t sum = (uint32_t)check;

    for (int i = 0; i < UNITS; i++) {
        units[i].room_count = 0;
        units[i].max_demand = 0.0f;
        units[i].average_temperature = 0.0f;
        units[i].worst_air_quality = 0.0f;
    }

    int coldest = 0;
    for (int i = 0; i < ROOMS; i++) {
        struct room *r = &rooms[i];
        struct unit *u = &units[r->unit];

        room_step(r, u, i + 1, outside);

        u->room_count++;
        u->average_temperature += r->temperature;
        u->max_demand = maxf(u->max_demand, r->setpoint - r->temperature);
        u->worst_air_quality = maxf(u->worst_air_quality, r->air_quality);

        if (r->temperature < rooms[coldest].temperature)
            coldest = i;

        sum = sum * 31u + r->status + r->alarms * 16u
              + (uint32_t)(int32_t)lrintf(r->temperature * 100.0f) + (uint32_t)r->operating_seconds;
    }

    for (int i = 0; i < UNITS; i++) {
        struct unit *u = &units[i];

        u->average_temperature /= (float)u->room_count;
        u->supply_temperature = clampf(16.0f, 18.0f + u->max_demand * 2.0f, 30.0f);
        u->fan_speed = clampf(20.0f, (u->worst_air_quality - 500.0f) * 0.2f, 100.0f);
        u->status = (uint16_t)((u->fan_speed > 20.0f) << 0 | (u->max_demand > 1.0f) << 1);
        sum = sum * 31u + (uint32_t)(int32_t)lrintf(u->average_temperature * 100.0f) + u->status;
    }

    history[history_index] = (struct history_entry){
        .room = (int16_t)(coldest + 1),
        .minute = (int16_t)minute,
        .temperature = rooms[coldest].temperature,
        .alarms = rooms[coldest].alarms,
    };
    history_index = (history_index + 1) % HISTORY;

    int n = minute % (ROOMS - 1);
    struct time_program saved = rooms[n].program;
    rooms[n].program = rooms[n + 1].program;
    rooms[n + 1].program = saved;

    check = (int32_t)(sum * 31u + (uint32_t)history[history_index].room
                      + (uint32_t)(int32_t)lrintf(history[history_index].temperature * 10.0f));
}
