/* measuring points of the network: update, search, sort, copy, statistics */
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define N_POINTS 48
#define N_ZONES 6

typedef enum { OK, LOW, HIGH, FAULT } point_state_t;

typedef struct {
    int16_t id, zone;
    float value, min, max;
    int32_t count;
    point_state_t state;
    bool changed;
} meas_point_t;

typedef struct {
    int16_t n;
    float sum, low, high;
    int16_t alarms;
} zone_stat_t;

static meas_point_t points[N_POINTS], sorted[N_POINTS];
static zone_stat_t stat[N_ZONES];
static uint32_t seed = 777;
static int32_t scans;
static bool init;

static void update_point(meas_point_t *p, float new_value)
{
    point_state_t old = p->state;
    p->value += (new_value - p->value) * 0.3f;
    p->count++;
    if (p->value < p->min) p->min = p->value;
    if (p->value > p->max) p->max = p->value;
    if (new_value < 1.0f)
        p->state = FAULT;
    else if (p->value < 30.0f)
        p->state = LOW;
    else if (p->value > 70.0f)
        p->state = HIGH;
    else
        p->state = OK;
    p->changed = p->state != old;
}

/* 1.. if found, else 0 */
static int find_point(const meas_point_t *list, int16_t id)
{
    for (int i = 0; i < N_POINTS; i++)
        if (list[i].id == id)
            return i + 1;
    return 0;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N_POINTS; i++) {
            points[i].id = 1000 + ((i + 1) * 29) % 97;
            points[i].zone = (i + 1) % N_ZONES;
            points[i].value = 50.0f;
            points[i].min = 1000.0f;
            points[i].max = -1000.0f;
        }
        init = true;
    }
    scans++;
    int32_t changes = 0;
    for (int i = 0; i < N_POINTS; i++) {
        seed = seed * 1664525u + 1013904223u;
        update_point(&points[i], (float)((seed / 65536) % 1000) / 10.0f);
        if (points[i].changed)
            changes += i + 1;
    }

    memcpy(sorted, points, sizeof sorted);
    for (int i = N_POINTS - 1; i >= 1; i--) {
        bool swapped = false;
        for (int j = 0; j < i; j++) {
            if (sorted[j].value > sorted[j + 1].value) {
                meas_point_t tmp = sorted[j];
                sorted[j] = sorted[j + 1];
                sorted[j + 1] = tmp;
                swapped = true;
            }
        }
        if (!swapped)
            break;
    }

    for (int z = 0; z < N_ZONES; z++)
        stat[z] = (zone_stat_t){ .low = 9999.0f, .high = -9999.0f };
    for (int i = 0; i < N_POINTS; i++) {
        zone_stat_t *s = &stat[points[i].zone];
        s->n++;
        s->sum += points[i].value;
        if (points[i].value < s->low) s->low = points[i].value;
        if (points[i].value > s->high) s->high = points[i].value;
        switch (points[i].state) {
        case LOW:
        case HIGH:
            s->alarms++;
            break;
        case FAULT:
            s->alarms += 10;
            break;
        default:
            break;
        }
    }

    int32_t sum = 0;
    for (int i = 1; i <= 10; i++) {
        int pos = find_point(sorted, (int16_t)(1000 + (scans + i * 7) % 97));
        if (pos > 0)
            sum += pos * i + sorted[pos - 1].zone + 1;
        else
            sum += 500;
    }
    for (int z = 0; z < N_ZONES; z++) {
        float mean = stat[z].sum / (float)stat[z].n;
        sum += (int32_t)lrintf(mean * 10.0f) + (int32_t)lrintf((stat[z].high - stat[z].low) * 10.0f) + stat[z].alarms;
    }
    int32_t ids = (int16_t)(sorted[23].id * 3) + (int16_t)(sorted[47].id * 5);
    check = (int32_t)((uint32_t)check * 11u + (uint32_t)(sum + changes + sorted[0].id + ids + sorted[6].count));
}
