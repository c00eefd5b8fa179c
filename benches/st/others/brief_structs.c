/* 64 records: update, search, statistics, sort */
#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t id;
    float weight;
    int16_t qty;
    int16_t prio;
    bool active;
} part;

static part parts[64];
static bool first = true;
static int32_t seed = 12345;

void scan(void)
{
    int32_t i, j;
    if (first) {
        first = false;
        for (i = 0; i < 64; i++) {
            parts[i].id = 1000 + i * 7;
            parts[i].weight = (float)i * 0.25f;
        }
    }

    /* update */
    for (i = 0; i < 64; i++) {
        seed = seed * 1103515245 + 12345;
        parts[i].prio = (int16_t)((seed / 65536) % 1000);
        parts[i].qty++;
        parts[i].active = parts[i].prio > 0;
        if (parts[i].qty > 100)
            parts[i].qty = 0;
    }

    /* search by id */
    int32_t found = 0;
    for (j = 0; j < 8; j++) {
        int32_t key = 1000 + j * 56;
        for (i = 0; i < 64; i++)
            if (parts[i].id == key) {
                found += i;
                break;
            }
    }

    /* totals of the active ones */
    float total = 0.0f;
    int32_t best = 0;
    for (i = 0; i < 64; i++)
        if (parts[i].active) {
            total += parts[i].weight * (float)parts[i].qty;
            if (parts[i].prio > parts[best].prio)
                best = i;
        }

    /* insertion sort by prio */
    for (i = 1; i < 64; i++) {
        part tmp = parts[i];
        for (j = i - 1; j >= 0 && parts[j].prio > tmp.prio; j--)
            parts[j + 1] = parts[j];
        parts[j + 1] = tmp;
    }

    check = check * 31 + found + best + parts[0].id + parts[63].id * 3
          + parts[32].prio + (int32_t)(total);
}
