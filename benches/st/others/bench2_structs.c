/* Arrays of structs: update, search, count and sort 100 parts. */
#include "st.h"
#include <stdbool.h>

#define PARTS 100

typedef struct {
    int32_t id;
    float weight;
    int16_t station;
    int16_t state;
    int16_t prio;
    bool ok;
    int32_t age;
} part;

static part parts[PARTS];
static int32_t per_state[4];
static int32_t n;
static bool started;

void scan(void)
{
    int i, j;

    if (!started) {
        for (i = 0; i < PARTS; i++) {
            parts[i].id = 1000 + (i * 37) % 100;
            parts[i].weight = 10.0f + (float)(i % 13) * 0.75f;
            parts[i].station = i % 10;
            parts[i].state = i % 4;
            parts[i].prio = (i * 53) % 100;
            parts[i].ok = i % 6 != 0;
            parts[i].age = 0;
        }
        started = true;
    }

    n = (n + 1) % 10000;

    /* update */
    for (i = 0; i < 4; i++)
        per_state[i] = 0;
    for (i = 0; i < PARTS; i++) {
        part *p = &parts[i];
        p->age++;
        switch (p->state) {
        case 0:
            if (p->age > 10)
                p->state = 1;
            break;
        case 1:
            p->station++;
            if (p->station >= 10) {
                p->station = 0;
                p->state = 2;
            }
            break;
        case 2:
            p->weight += 0.25f;
            if (p->weight > 30.0f) {
                p->weight -= 20.0f;
                p->state = 3;
            }
            break;
        case 3:
            p->ok = !p->ok;
            p->age = 0;
            p->state = 0;
            break;
        }
        per_state[p->state]++;
    }

    /* find a part by its number */
    int32_t wanted = 1000 + (n * 7) % 100;
    int found = -1;
    for (i = 0; i < PARTS; i++) {
        if (parts[i].id == wanted) {
            found = i;
            break;
        }
    }

    /* the heaviest good part */
    int heaviest = -1;
    float max = 0.0f;
    for (i = 0; i < PARTS; i++) {
        if (parts[i].ok && parts[i].weight > max) {
            max = parts[i].weight;
            heaviest = i;
        }
    }

    /* new priorities for two parts, then sort by priority (insertion sort) */
    if (found >= 0)
        parts[found].prio = (int16_t)((n * 29) % 100);
    if (heaviest >= 0)
        parts[heaviest].prio = (int16_t)((n * 31) % 100);
    for (i = 1; i < PARTS; i++) {
        part hold = parts[i];
        for (j = i; j > 0 && parts[j - 1].prio > hold.prio; j--)
            parts[j] = parts[j - 1];
        parts[j] = hold;
    }

    int32_t sum = found + heaviest * 100 + (int32_t)(max * 10.0f);
    for (i = 0; i < 4; i++)
        sum += per_state[i] * (i + 1);
    for (i = 0; i < PARTS; i += 10)
        sum += parts[i].id + parts[i].station + parts[i].prio;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
