#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t id;
    int16_t weight;
    int16_t lane;
    float temp;
    int32_t prio;
    bool ready;
} pallet_t;

typedef struct {
    int16_t count;
    int32_t load;
    float temp_sum;
    int16_t heaviest;
} lane_t;

static bool first = true;
static uint32_t seed = 2024;
static pallet_t pal[64];
static lane_t lanes[8];

void scan(void)
{
    int i, j, k, found;
    int32_t wanted, n;
    pallet_t tmp;

    if (first) {
        first = false;
        for (i = 0; i < 64; i++) {
            pal[i].id = 1000 + i * 7;
            pal[i].weight = (int16_t)(100 + (i * 37) % 400);
            pal[i].lane = (int16_t)(i % 8);
            pal[i].temp = 20.0f;
        }
    }
    for (i = 0; i < 64; i++) {
        seed = seed * 1664525u + 1013904223u;
        pal[i].prio = (int32_t)(seed / 65536u) % 1000;
        pal[i].temp = pal[i].temp + 0.1f * ((float)pal[i].prio * 0.05f - pal[i].temp);
        pal[i].ready = pal[i].temp > 25.0f;
        if (pal[i].prio > 900)
            pal[i].lane = (int16_t)((pal[i].lane + 1) % 8);
    }
    for (i = 1; i < 64; i++) {
        tmp = pal[i];
        j = i - 1;
        while (j >= 0 && pal[j].prio > tmp.prio) {
            pal[j + 1] = pal[j];
            j--;
        }
        pal[j + 1] = tmp;
    }
    for (k = 0; k < 8; k++) {
        lanes[k].count = 0;
        lanes[k].load = 0;
        lanes[k].temp_sum = 0.0f;
        lanes[k].heaviest = 0;
    }
    for (i = 0; i < 64; i++) {
        k = pal[i].lane;
        lanes[k].count++;
        lanes[k].load += pal[i].weight;
        lanes[k].temp_sum += pal[i].temp;
        if (pal[i].weight > lanes[k].heaviest)
            lanes[k].heaviest = pal[i].weight;
    }
    n = 0;
    for (k = 0; k < 8; k++) {
        wanted = 1000 + 7 * (k * 9);
        found = -1;
        for (i = 0; i < 64; i++) {
            if (pal[i].id == wanted) {
                found = i;
                break;
            }
        }
        if (found >= 0) {
            n += found;
            if (pal[found].ready)
                n += 100;
        }
        n = n * 3 + lanes[k].count + lanes[k].load + (int32_t)lanes[k].temp_sum
            + lanes[k].heaviest;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
