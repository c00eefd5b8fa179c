/* Chapter 8: structures. A table of 100 packages is updated, searched, totalled and sorted. */
#include <stdbool.h>
#include "st.h"

#define COUNT 100
#define LANES 6

typedef struct {
    int32_t id;
    int16_t lane;
    int16_t weight;
    float length;
    bool rejected;
    int32_t passes;
} Package;

typedef struct {
    int32_t packages;
    int32_t rejects;
    int32_t weight;
    float longest;
} LaneTotal;

static bool first = true;
static Package pack[COUNT];
static LaneTotal total[LANES];
static uint32_t seed = 777;

void scan(void)
{
    int i, j, found, heaviest;
    int32_t key, sum;
    Package held;

    if (first) {
        first = false;
        for (i = 0; i < COUNT; i++) {
            pack[i].id = 1000 + (i + 1) * 17;
            pack[i].lane = (i + 1) % LANES;
        }
    }

    /* update */
    for (i = 0; i < COUNT; i++) {
        seed = seed * 1664525u + 1013904223u;
        pack[i].weight = (int16_t)(seed / 65536u % 1000u);
        pack[i].length = (float)pack[i].weight * 0.25f + 10.0f;
        pack[i].rejected = pack[i].weight < 50 || pack[i].weight > 940;
        pack[i].passes++;
        if (pack[i].rejected)
            pack[i].lane = (pack[i].lane + 1) % LANES;
    }

    /* totals of the lanes */
    for (i = 0; i < LANES; i++) {
        total[i].packages = 0;
        total[i].rejects = 0;
        total[i].weight = 0;
        total[i].longest = 0.0f;
    }
    for (i = 0; i < COUNT; i++) {
        LaneTotal *t = &total[pack[i].lane];
        t->packages++;
        t->weight += pack[i].weight;
        if (pack[i].rejected)
            t->rejects++;
        if (pack[i].length > t->longest)
            t->longest = pack[i].length;
    }

    /* search by identity */
    sum = 0;
    for (j = 1; j <= 20; j++) {
        key = 1000 + j * 5 * 17;
        found = -1;
        for (i = 0; i < COUNT; i++) {
            if (pack[i].id == key) {
                found = i;
                break;
            }
        }
        if (found >= 0)
            sum += pack[found].weight + found + 1;
    }

    /* sort by weight */
    for (i = 1; i < COUNT; i++) {
        held = pack[i];
        j = i - 1;
        while (j >= 0 && pack[j].weight > held.weight) {
            pack[j + 1] = pack[j];
            j--;
        }
        pack[j + 1] = held;
    }

    heaviest = 0;
    for (i = 0; i < LANES; i++) {
        if (total[i].weight > total[heaviest].weight)
            heaviest = i;
        sum += total[i].packages * (i + 1) + total[i].rejects * 3 + total[i].weight + (int32_t)total[i].longest;
    }
    for (i = 0; i < COUNT; i++)
        sum += pack[i].id * (i + 1) + pack[i].passes;

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(heaviest + 1));
}
