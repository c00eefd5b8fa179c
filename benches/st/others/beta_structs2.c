#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t id;
    int16_t priority;
    int16_t quantity;
    int32_t due;
    float cost;
    bool urgent;
} Job;

static bool before(const Job *a, const Job *b)
{
    if (a->priority != b->priority)
        return a->priority > b->priority;
    if (a->due != b->due)
        return a->due < b->due;
    return a->id < b->id;
}

static Job jobs[160];
static Job best[10];
static bool ready;
static uint32_t seed = 2024;

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int i = 0; i <= 159; i++) {
            jobs[i].id = i + 1;
            jobs[i].priority = i % 8;
            jobs[i].quantity = 10 + i;
            jobs[i].due = 10000 - i * 37;
            jobs[i].cost = 1.25f;
        }
    }

    /* some jobs change */
    for (int i = 1; i <= 30; i++) {
        seed = seed * 1103515245u + 12345u;
        int k = (seed / 65536u) % 160u;
        jobs[k].priority = (int16_t)((seed / 1024u) % 8u);
        jobs[k].due = (int32_t)((seed / 256u) % 20000u);
        jobs[k].quantity = (jobs[k].quantity + 3) % 500;
        jobs[k].cost = jobs[k].cost * 0.5f + (float)jobs[k].quantity;
        jobs[k].urgent = jobs[k].due < 2000;
    }

    /* insertion sort */
    for (int i = 1; i <= 159; i++) {
        Job current = jobs[i];
        int j = i - 1;
        while (j >= 0) {
            if (!before(&current, &jobs[j]))
                break;
            jobs[j + 1] = jobs[j];
            j--;
        }
        jobs[j + 1] = current;
    }

    /* take the best ones */
    int32_t sum = 0;
    float total = 0.0f;
    for (int i = 0; i <= 9; i++) {
        best[i] = jobs[i];
        best[i].quantity++;
        sum += best[i].id * (i + 1) + best[i].quantity;
        total += best[i].cost;
        if (best[i].urgent)
            sum += 1000;
    }
    check = (int32_t)((uint32_t)check * 5u + (uint32_t)sum + (uint32_t)(int32_t)total);
}
