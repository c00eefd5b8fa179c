/* part tracking on a conveyor: move, search, sort by weight, count per lane */
#include <stdbool.h>
#include "st.h"

#define N 80

typedef struct {
    int32_t id;
    int16_t weight;
    int16_t lane;
    float x;
    float speed;
    int32_t age;
    bool good;
} part_t;

typedef struct {
    int16_t count;
    int16_t rejects;
    int32_t total;
    float front;
} lane_t;

static part_t parts[N];
static lane_t lanes[4];
static int32_t next_id = 1000;
static int32_t rnd = 4711;
static bool init_done;

void scan(void)
{
    int16_t i, j, idx, found, heavy;
    int32_t wanted;
    part_t key;

    if (!init_done) {
        for (i = 0; i < N; i++) {
            rnd = (rnd * 171 + 11213) % 53125;
            parts[i].id = next_id;
            parts[i].weight = (int16_t)(rnd % 900) + 100;
            parts[i].lane = i % 4;
            parts[i].x = (float)i * 12.5f;
            parts[i].speed = 2.0f + (float)(i % 7) * 0.25f;
            parts[i].good = true;
            next_id++;
        }
        init_done = true;
    }

    /* move the parts; those at the end leave and new ones come in */
    for (i = 0; i < N; i++) {
        parts[i].x += parts[i].speed;
        parts[i].age++;
        if (parts[i].x >= 1000.0f) {
            rnd = (rnd * 171 + 11213) % 53125;
            parts[i].id = next_id;
            parts[i].weight = (int16_t)(rnd % 900) + 100;
            parts[i].lane = (int16_t)(rnd % 4);
            parts[i].x = 0.0f;
            parts[i].age = 0;
            parts[i].good = rnd % 10 != 0;
            next_id++;
        }
    }

    /* insertion sort by weight */
    for (i = 1; i < N; i++) {
        key = parts[i];
        j = i - 1;
        while (j >= 0) {
            if (parts[j].weight <= key.weight)
                break;
            parts[j + 1] = parts[j];
            j--;
        }
        parts[j + 1] = key;
    }

    /* lane statistics */
    for (i = 0; i < 4; i++) {
        lanes[i].count = 0;
        lanes[i].rejects = 0;
        lanes[i].total = 0;
        lanes[i].front = 0.0f;
    }
    for (i = 0; i < N; i++) {
        idx = parts[i].lane;
        lanes[idx].count++;
        lanes[idx].total += parts[i].weight;
        if (!parts[i].good)
            lanes[idx].rejects++;
        if (parts[i].x > lanes[idx].front)
            lanes[idx].front = parts[i].x;
    }

    /* look for a part by number, and for the first one over 600 by halving */
    wanted = next_id - 1 - (rnd % 40);
    found = -1;
    for (i = 0; i < N; i++) {
        if (parts[i].id == wanted) {
            found = i;
            break;
        }
    }

    heavy = 0;
    j = N;
    while (heavy < j) {
        idx = (heavy + j) / 2;
        if (parts[idx].weight > 600)
            j = idx;
        else
            heavy = idx + 1;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(found + heavy));
    for (i = 0; i < 4; i++)
        check = (int32_t)((uint32_t)check * 7u + (uint32_t)(lanes[i].count + lanes[i].rejects * 3
                          + lanes[i].total + (int32_t)lanes[i].front));
    check = (int32_t)((uint32_t)check + (uint32_t)parts[rnd % 80].age);
}
