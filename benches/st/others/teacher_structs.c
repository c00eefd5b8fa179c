#include <stdbool.h>
#include <xmmintrin.h>
#include "st.h"

#define PARTS 64

typedef enum { PART_FREE, PART_RAW, PART_MACHINED, PART_CHECKED, PART_SCRAP } part_state_t;

typedef struct {
    int16_t x, y;
} position_t;

typedef struct {
    int32_t id;
    part_state_t state;
    int16_t priority;
    position_t place;
    float weight;
    bool urgent;
} part_t;

typedef struct {
    int16_t raw, machined, checked, scrap;
    float weight_sum;
    part_t heaviest;
} statistics_t;

/* Rounds to the nearest, halves to even (no libm here, so no lrintf). */
static int32_t real_to_dint(float x)
{
    return _mm_cvtss_si32(_mm_set_ss(x));
}

static uint32_t random_state = 4711;

static int16_t next_random(void)
{
    random_state = random_state * 1103515245u + 12345u;
    return (int16_t)((random_state / 65536u) % 1000u);
}

/* Index of the part, -1 if it is not there. */
static int16_t find_part(const part_t *store, int32_t id)
{
    for (int i = 0; i < PARTS; i++)
        if (store[i].id == id)
            return (int16_t)i;
    return -1;
}

static part_state_t next_state(part_state_t state, int16_t chance)
{
    switch (state) {
    case PART_FREE:
        return PART_RAW;
    case PART_RAW:
        return chance > 300 ? PART_MACHINED : state;
    case PART_MACHINED:
        if (chance > 900)
            return PART_SCRAP;
        if (chance > 400)
            return PART_CHECKED;
        return state;
    case PART_CHECKED:
    case PART_SCRAP:
        return PART_FREE;
    }
    return state;
}

/* Insertion sort: highest priority first. */
static int32_t sort_store(part_t *store)
{
    int32_t moves = 0;
    for (int i = 1; i < PARTS; i++) {
        part_t part = store[i];
        int k = i - 1;
        while (k >= 0 && store[k].priority < part.priority) {
            store[k + 1] = store[k];
            moves++;
            k--;
        }
        store[k + 1] = part;
    }
    return moves;
}

static void statistics(const part_t *store, statistics_t *result)
{
    static const statistics_t empty;
    *result = empty;
    for (int i = 0; i < PARTS; i++) {
        switch (store[i].state) {
        case PART_RAW:
            result->raw++;
            break;
        case PART_MACHINED:
            result->machined++;
            break;
        case PART_CHECKED:
            result->checked++;
            break;
        case PART_SCRAP:
            result->scrap++;
            break;
        default:
            break;
        }
        result->weight_sum += store[i].weight;
        if (store[i].weight > result->heaviest.weight)
            result->heaviest = store[i];
    }
}

static part_t store[PARTS];
static statistics_t stat;
static int32_t next_id = 1;

void scan(void)
{
    for (int i = 0; i < PARTS; i++) {
        part_t *p = &store[i];
        int16_t value = next_random();
        p->state = next_state(p->state, value);
        if (p->state == PART_FREE) {
            p->id = next_id++;
            p->priority = value % 100;
            p->weight = (float)value * 0.5f;
            p->urgent = value > 950;
        } else {
            p->place.x = (int16_t)((p->place.x + 3) % 120);
            p->place.y = (int16_t)((p->place.y + p->place.x) % 80);
            if (p->urgent)
                p->priority++;
        }
    }

    check += sort_store(store);

    for (int i = 1; i <= 8; i++) {
        int16_t found = find_part(store, next_id - i * 9);
        if (found >= 0) {
            check += store[found].place.x + found;
            store[found].weight += 0.5f;
        }
    }

    statistics(store, &stat);
    check += stat.raw + stat.machined * 3 + stat.checked * 5 + stat.scrap * 7
           + real_to_dint(stat.weight_sum) + stat.heaviest.id;
}
