#include <stdbool.h>
#include <string.h>
#include "st.h"

#define TRACK 96
#define LANES 4

typedef struct { int16_t level, torque; float weight; } Measure;

typedef struct {
    int32_t id;
    uint8_t lane;
    bool capped, reject;
    Measure measure;
} Bottle;

typedef struct {
    int32_t count, reject, level;
    float weight;
    Bottle worst;
} Lane;

static Bottle track[TRACK], entry, leaving;
static Lane lanes[LANES];

static bool is_bad(const Bottle *b)
{
    return b->measure.level < 40 || b->measure.torque > 950 || !b->capped;
}

static void shift(void)
{
    leaving = track[TRACK - 1];
    memmove(&track[1], &track[0], (TRACK - 1) * sizeof track[0]);
    track[0] = entry;
}

static void process(void)
{
    for (int i = 0; i < TRACK; i++) {
        Bottle *b = &track[i];
        b->measure.level = (int16_t)(b->measure.level + 3);
        b->measure.weight = b->measure.weight * 0.75f + (float)b->measure.level;
        if (i % 32 == 20) {
            b->measure.torque = (int16_t)(b->measure.torque + 50);
            b->capped = b->measure.torque > 90;
        }
        b->reject = is_bad(b);
    }
}

static void statistics(void)
{
    memset(lanes, 0, sizeof lanes);
    for (int i = 0; i < TRACK; i++) {
        const Bottle *b = &track[i];
        Lane *l = &lanes[b->lane];
        l->count++;
        l->level += b->measure.level;
        l->weight += b->measure.weight;
        if (b->reject)
            l->reject++;
        if (b->measure.torque > l->worst.measure.torque)
            l->worst = *b;
    }
}

void scan(void)
{
    entry.id++;
    entry.lane = (uint8_t)((entry.id * 7 / 3) % 4);
    entry.measure.level = (int16_t)((entry.id * 53) % 101);
    entry.measure.torque = (int16_t)((entry.id * 331) % 997);
    entry.measure.weight = 0.5f;
    entry.capped = entry.id % 5 != 0;

    shift();
    process();
    statistics();

    uint32_t sum = (uint32_t)(leaving.id + leaving.measure.level);
    for (int k = 0; k < LANES; k++)
        sum = sum * 3u + (uint32_t)(lanes[k].count + lanes[k].reject * 5 + lanes[k].level
                                    + (int32_t)lanes[k].weight + lanes[k].worst.id);
    check = (int32_t)((uint32_t)check * 31u + sum + 1u);
}
