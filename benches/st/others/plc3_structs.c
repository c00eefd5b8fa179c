#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t id;
    int16_t sku;
    float weight;
    int16_t prio;
    int16_t dest;
    bool blocked;
    int32_t age;
} pallet_t;

typedef struct {
    int16_t count;
    float weight;
    int32_t oldest;
} lane_t;

static bool init;
static int32_t n;
static pallet_t store[100], queue[50];
static lane_t lanes[8];

void scan(void)
{
    int16_t i, j, best, hits;
    pallet_t tmp;
    int32_t sum;

    if (!init) {
        for (i = 0; i < 100; i++) {
            store[i].id = 1000 + i;
            store[i].sku = i % 12;
            store[i].weight = 100.0f + (float)i * 1.5f;
            store[i].prio = (i * 17) % 50;
            store[i].dest = i % 8;
        }
        init = true;
    }

    n++;
    if (n >= 100000)
        n = 0;

    for (i = 0; i < 100; i++) {
        store[i].age++;
        store[i].prio = (store[i].prio + i % 7 + 1) % 50;
        store[i].blocked = (n + i) % 9 == 0;
        if (store[i].age > 500 + i) {
            store[i].age = 0;
            store[i].id += 100;
            if (store[i].id > 900000)
                store[i].id -= 890000;
            store[i].dest = (store[i].dest + 3) % 8;
        }
    }

    for (i = 0; i < 8; i++) {
        lanes[i].count = 0;
        lanes[i].weight = 0.0f;
        lanes[i].oldest = 0;
    }
    for (i = 0; i < 100; i++) {
        j = store[i].dest;
        lanes[j].count++;
        lanes[j].weight += store[i].weight;
        if (store[i].age > lanes[j].oldest)
            lanes[j].oldest = store[i].age;
    }

    best = -1;
    hits = 0;
    for (i = 0; i < 100; i++) {
        if (!store[i].blocked && store[i].sku == n % 12) {
            hits++;
            if (best < 0)
                best = i;
            else if (store[i].prio > store[best].prio)
                best = i;
        }
    }

    for (i = 0; i < 50; i++)
        queue[i] = store[i * 2];
    for (i = 1; i < 50; i++) {
        tmp = queue[i];
        j = i - 1;
        while (j >= 0) {
            if (queue[j].prio <= tmp.prio)
                break;
            queue[j + 1] = queue[j];
            j--;
        }
        queue[j + 1] = tmp;
    }

    sum = hits;
    if (best >= 0)
        sum += store[best].id;
    for (i = 0; i < 8; i++)
        sum += lanes[i].count + (int32_t)lanes[i].weight + lanes[i].oldest;
    for (i = 0; i < 50; i++)
        sum = (int32_t)((uint32_t)sum + (uint32_t)queue[i].id * (uint32_t)i + (uint32_t)queue[i].prio);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
