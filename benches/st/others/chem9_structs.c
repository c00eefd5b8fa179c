#include <math.h>
#include <stdbool.h>
#include "st.h"

#define BATCHES 48
#define TOP 12
#define PRODUCTS 5

typedef enum { WAITING, FILLING, REACTING, DRAINING, FINISHED } state_t;

typedef struct { float temp, ph; } sample;

typedef struct {
    int32_t id;
    int16_t product, prio;
    state_t state;
    bool urgent;
    float qty;
    sample samples[4];
} batch;

typedef struct {
    int16_t count, finished;
    float total, lowest, highest, temp_sum;
} stat;

static batch archive[BATCHES];
static batch top[TOP];
static stat stats[PRODUCTS];
static int32_t next_id = 1000;
static int w;
static uint32_t seed = 31337;

static inline uint32_t mix(uint32_t sum, int32_t v) { return sum * 31 + (uint32_t)v; }

static bool before(const batch *a, const batch *b)
{
    return a->prio > b->prio || (a->prio == b->prio && a->qty >= b->qty);
}

void scan(void)
{
    uint32_t sum = (uint32_t)check;

    seed = seed * 1664525u + 1013904223u;
    batch *rec = &archive[w];
    rec->id = next_id++;
    rec->product = (int16_t)((seed >> 16) % PRODUCTS);
    rec->prio = (int16_t)((seed >> 20) % 100);
    rec->state = WAITING;
    rec->urgent = rec->prio > 90;
    rec->qty = (float)((seed >> 8) % 20000) * 0.125f;
    for (int i = 0; i < 4; i++) {
        rec->samples[i].temp = 20.0f + (float)(rec->prio + i);
        rec->samples[i].ph = 7.0f + (float)i * 0.25f;
    }
    w = (w + 1) % BATCHES;

    for (int i = 0; i < BATCHES; i++) {
        batch *b = &archive[i];
        if (b->id <= 0 || (int32_t)((uint32_t)b->id + (uint32_t)next_id) % 7 != 0)
            continue;
        switch (b->state) {
        case WAITING:
            b->state = FILLING;
            break;
        case FILLING:
            b->state = REACTING;
            b->samples[0].temp += 10.0f;
            break;
        case REACTING:
            b->state = DRAINING;
            b->samples[1] = b->samples[0];
            break;
        case DRAINING:
            b->state = FINISHED;
            break;
        case FINISHED:
            break;
        }
    }

    int32_t wanted = next_id - 1 - (int32_t)((seed >> 12) % 60);
    int found = -1;
    for (int i = 0; i < BATCHES; i++)
        if (archive[i].id == wanted) {
            found = i;
            break;
        }
    sum = mix(sum, found);

    for (int p = 0; p < PRODUCTS; p++)
        stats[p] = (stat){ .lowest = 1.0e6f };
    for (int i = 0; i < BATCHES; i++) {
        const batch *b = &archive[i];
        if (b->id <= 0)
            continue;
        stat *s = &stats[b->product];
        s->count++;
        s->finished += b->state == FINISHED;
        s->total += b->qty;
        if (b->qty < s->lowest)
            s->lowest = b->qty;
        if (b->qty > s->highest)
            s->highest = b->qty;
        for (int j = 0; j < 4; j++)
            s->temp_sum += b->samples[j].temp;
    }
    for (int p = 0; p < PRODUCTS; p++) {
        const stat *s = &stats[p];
        float mean = s->count > 0 ? s->temp_sum / (float)(4 * s->count) : 0.0f;
        sum = mix(sum, 0) + (uint32_t)(s->count * 50 + s->finished);
        sum = mix(sum, (int32_t)lrintf(s->total));
        sum = mix(sum, (int32_t)lrintf(s->highest - s->lowest));
        sum = mix(sum, (int32_t)lrintf(mean * 100.0f));
    }

    int n = 0;
    for (int i = 0; i < BATCHES; i++) {
        const batch *b = &archive[i];
        if (b->id <= 0 || b->state == FINISHED)
            continue;
        int j = n;
        while (j > 0 && !before(&top[j - 1], b)) {
            if (j < TOP)
                top[j] = top[j - 1];
            j--;
        }
        if (j < TOP) {
            top[j] = *b;
            if (n < TOP)
                n++;
        }
    }
    for (int i = 0; i < n; i++)
        sum = mix(sum, top[i].id) + top[i].urgent;
    check = (int32_t)sum;
}
