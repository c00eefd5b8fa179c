/* 100 structures are updated, then sorted a little by 20 passes of bubble sort that swap whole structures. */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

typedef struct {
    int16_t id;
    int16_t rank;
    float weight;
    int16_t temp;
    bool active;
    int32_t hits;
    int16_t hist[4];
} part_t;

static part_t parts[100];
static bool started;
static int16_t turn;

static inline int16_t limit(int16_t lo, int16_t x, int16_t hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

void scan(void)
{
    if (!started) {
        started = true;
        for (int i = 0; i < 100; i++) {
            parts[i].id = i;
            parts[i].rank = (i * 37) % 100;
            parts[i].weight = 1.5f * (float)i;
        }
    }
    turn = (turn + 1) % 1000;

    for (int i = 0; i < 100; i++) {
        part_t *p = &parts[i];
        p->rank = (p->rank * 17 + p->id + turn) % 1000;
        p->temp = limit(-200, p->temp + p->rank % 7 - 3, 200);
        p->weight = p->weight * 0.98f + (float)p->temp * 0.05f;
        p->active = p->temp > 0;
        p->hits += p->active;
        if (p->hits > 100000)
            p->hits = 100000;
        for (int j = 3; j >= 1; j--)
            p->hist[j] = p->hist[j - 1];
        p->hist[0] = p->temp;
    }

    int32_t swaps = 0;
    for (int pass = 1; pass <= 20; pass++)
        for (int j = 0; j <= 99 - pass; j++)
            if (parts[j].rank > parts[j + 1].rank) {
                part_t swap = parts[j];
                parts[j] = parts[j + 1];
                parts[j + 1] = swap;
                swaps++;
            }

    for (int i = 0; i < 100; i++) {
        const part_t *p = &parts[i];
        check = (check * 31 + p->id + 3 * p->rank + p->hits + abs((int32_t)(p->weight * 10.0f))
            + p->active + abs(p->hist[0] - p->hist[3])) % 1000003;
    }
    check = (check * 31 + swaps) % 1000003;
}
