/* Batch records of the dairy: update, search, sort, copy and statistics */
#include <stdbool.h>
#include <string.h>
#include <math.h>
#include "st.h"

#define BATCHES 48

typedef enum { PROD_MILK, PROD_CREAM, PROD_YOGHURT, PROD_JUICE } product_t;
typedef enum { BATCH_FREE, BATCH_RUNNING, BATCH_DONE, BATCH_BLOCKED } batch_state;

typedef struct { float fat, ph, temp; } quality_t;

typedef struct {
    int32_t id;
    product_t product;
    batch_state state;
    int16_t tank;
    int32_t volume;
    quality_t quality;
    bool released;
} batch_t;

typedef struct {
    int32_t count, volume, min_vol, max_vol;
    float mean_fat, max_temp;
} stats_t;

static uint32_t noise = 2024;
static int32_t next_id = 1000;
static batch_t list[BATCHES], sorted[BATCHES];

static bool update_batch(batch_t *b, int32_t n, int32_t id)
{
    switch (b->state) {
    case BATCH_FREE:
        if (n < 200) {
            b->id = id;
            switch (n % 4) {
            case 0: b->product = PROD_MILK; break;
            case 1: b->product = PROD_CREAM; break;
            case 2: b->product = PROD_YOGHURT; break;
            default: b->product = PROD_JUICE; break;
            }
            b->state = BATCH_RUNNING;
            b->tank = (int16_t)(n % 12 + 1);
            b->volume = 0;
            b->quality.fat = 1.5f + (float)n * 0.01f;
            b->quality.ph = 6.7f;
            b->quality.temp = 4.0f;
            b->released = false;
            return true;
        }
        break;
    case BATCH_RUNNING:
        b->volume += 20 + n;
        b->quality.temp += (72.0f - b->quality.temp) * 0.1f;
        b->quality.ph -= 0.01f;
        if (b->volume > 4000)
            b->state = BATCH_DONE;
        else if (n == 255)
            b->state = BATCH_BLOCKED;
        break;
    case BATCH_DONE:
        b->quality.temp *= 0.9f;
        if (b->quality.temp < 8.0f) {
            b->released = true;
            b->state = BATCH_FREE;
        }
        break;
    case BATCH_BLOCKED:
        if (n < 40)
            b->state = BATCH_FREE;
        break;
    }
    return false;
}

static int find_batch(const batch_t *l, int32_t id)
{
    for (int i = 0; i < BATCHES; i++)
        if (l[i].id == id)
            return i;
    return -1;
}

static bool after(const batch_t *a, const batch_t *b)
{
    return a->volume > b->volume || (a->volume == b->volume && a->id > b->id);
}

static int32_t sort_batches(batch_t *l)
{
    int32_t moves = 0;

    for (int i = 1; i < BATCHES; i++) {
        batch_t item = l[i];
        int j = i - 1;
        while (j >= 0 && after(&l[j], &item)) {
            l[j + 1] = l[j];
            moves++;
            j--;
        }
        l[j + 1] = item;
    }
    return moves;
}

static stats_t statistics(const batch_t *l, product_t product)
{
    stats_t s = { .min_vol = 999999 };
    float fat = 0.0f;

    for (int i = 0; i < BATCHES; i++) {
        const batch_t *b = &l[i];
        if (b->product != product)
            continue;
        s.count++;
        s.volume += b->volume;
        if (b->volume < s.min_vol)
            s.min_vol = b->volume;
        if (b->volume > s.max_vol)
            s.max_vol = b->volume;
        if (b->quality.temp > s.max_temp)
            s.max_temp = b->quality.temp;
        fat += b->quality.fat;
    }
    s.mean_fat = s.count > 0 ? fat / (float)s.count : 0.0f;
    return s;
}

void scan(void)
{
    for (int i = 0; i < BATCHES; i++) {
        noise = noise * 1664525u + 1013904223u;
        if (update_batch(&list[i], (int32_t)(noise >> 24), next_id))
            next_id++;
    }

    uint32_t found = 0;
    for (int i = 1; i <= 10; i++)
        found = found * 3u + (uint32_t)find_batch(list, next_id - i * 5);

    memcpy(sorted, list, sizeof sorted);
    int32_t moves = sort_batches(sorted);

    stats_t milk = statistics(list, PROD_MILK);
    stats_t cream = statistics(list, PROD_CREAM);
    stats_t yoghurt = statistics(sorted, PROD_YOGHURT);
    stats_t juice = statistics(sorted, PROD_JUICE);

    uint32_t c = (uint32_t)check;
    c = c * 31u + found + (uint32_t)(moves + sorted[24].id + sorted[47].volume);
    c = c * 31u + (uint32_t)(milk.volume + cream.min_vol + yoghurt.max_vol + juice.count);
    c = c * 31u + (uint32_t)(int32_t)lrintf(milk.mean_fat * 1000.0f + cream.max_temp * 100.0f)
        + (uint32_t)(int32_t)lrintf(yoghurt.mean_fat * 1000.0f) + (uint32_t)sorted[40].tank;
    check = (int32_t)c;
}
