/* Arrays of structs: update all parts, search for the best, sort a copy by key. */
#include <stdbool.h>
#include "st.h"

#define N 64

typedef struct {
    int32_t id;
    int16_t prio;
    float weight;
    int32_t pos[3];
    bool active;
} part;

static part parts[N], sorted[N];
static uint32_t seed = 12345;
static bool init;

void scan(void)
{
    int32_t i, j, gap, n, best, found, sum, want;
    float heavy;
    part tmp;

    if (!init) {
        for (i = 0; i < N; i++) {
            parts[i].id = 1000 + (i * 37) % 64;
            parts[i].weight = (float)i * 1.5f;
            parts[i].active = true;
        }
        init = true;
    }

    /* update */
    for (i = 0; i < N; i++) {
        seed = seed * 1664525u + 1013904223u;
        parts[i].prio = (int16_t)(seed / 65536 % 1000);
        parts[i].weight = parts[i].weight * 0.99f + (float)parts[i].prio * 0.01f;
        parts[i].pos[0] = (parts[i].pos[0] + parts[i].prio) % 5000;
        parts[i].pos[1] = parts[i].pos[0] / 2;
        parts[i].pos[2] = parts[i].pos[2] + 1;
        parts[i].active = parts[i].prio > 250;
    }

    /* search */
    best = 0;
    heavy = 0.0f;
    for (i = 0; i < N; i++) {
        if (parts[i].active && parts[i].weight > heavy) {
            heavy = parts[i].weight;
            best = i;
        }
    }
    found = -1;
    want = 1000 + (int32_t)(seed / 65536 % 64);
    i = 0;
    while (found < 0 && i < N) {
        if (parts[i].id == want)
            found = i;
        i++;
    }

    /* shell sort of the active ones by priority, then id */
    n = 0;
    for (i = 0; i < N; i++) {
        if (parts[i].active) {
            sorted[n] = parts[i];
            n++;
        }
    }
    for (gap = 13; gap > 0; gap /= 3) {
        for (i = gap; i < n; i++) {
            tmp = sorted[i];
            j = i;
            while (j >= gap) {
                if (sorted[j - gap].prio < tmp.prio)
                    break;
                if (sorted[j - gap].prio == tmp.prio && sorted[j - gap].id <= tmp.id)
                    break;
                sorted[j] = sorted[j - gap];
                j -= gap;
            }
            sorted[j] = tmp;
        }
    }

    sum = 0;
    for (i = 0; i < n; i++)
        sum += (i + 1) * sorted[i].prio + sorted[i].pos[1];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + best * 100 + found + (int32_t)heavy));
}
