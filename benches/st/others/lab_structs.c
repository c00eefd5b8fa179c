/* a list of 40 orders: update, search, sort, statistics per station */
#include <stdbool.h>
#include "st.h"

#define NO 40

struct position { int16_t x, y; };

struct order {
    int32_t id;
    int16_t prio;
    int16_t station;
    struct position pos;
    float weight;
    int32_t due;
    bool done;
};

struct station {
    int16_t count;
    int16_t late;
    float load;
    int32_t first_id;
};

static struct order orders[NO];
static struct station stations[8];
static uint32_t rnd = 99;
static int32_t next_id = 1000;
static bool init;

void scan(void)
{
    int i, j, s, found, heaviest;
    int32_t wanted;
    uint32_t sum;
    struct order tmp;

    if (!init) {
        init = true;
        for (i = 0; i < NO; i++) {
            orders[i].id = next_id++;
            orders[i].prio = ((i + 1) * 37) % 100;
            orders[i].station = (i + 1) % 8;
            orders[i].weight = 1.0f + (float)(i + 1) * 0.5f;
            orders[i].due = 50 + (i + 1) * 3;
        }
    }

    /* update */
    for (i = 0; i < NO; i++) {
        orders[i].due--;
        orders[i].pos.x += orders[i].station - 3;
        orders[i].pos.y++;
        if (orders[i].pos.x > 500 || orders[i].pos.x < -500)
            orders[i].pos.x = 0;
        if (orders[i].pos.y >= 200) {
            orders[i].pos.y = 0;
            orders[i].station = (orders[i].station + 1) % 8;
        }
        if (orders[i].due <= 0)
            orders[i].done = true;
    }

    /* replace finished orders */
    for (i = 0; i < NO; i++) {
        if (orders[i].done) {
            rnd = rnd * 1664525u + 1013904223u;
            orders[i].id = next_id++;
            orders[i].prio = (int16_t)((rnd / 65536) % 100);
            orders[i].due = 40 + (int32_t)((rnd / 1024) % 128);
            orders[i].weight = 1.0f + (float)((rnd / 4096) % 64) * 0.25f;
            orders[i].done = false;
        }
    }

    /* three orders get a new priority */
    for (j = 0; j < 3; j++) {
        rnd = rnd * 1664525u + 1013904223u;
        i = (int)((rnd / 65536) % 40);
        orders[i].prio = (orders[i].prio + 29) % 100;
    }

    /* insertion sort: priority, then id */
    for (i = 1; i < NO; i++) {
        tmp = orders[i];
        j = i - 1;
        while (j >= 0) {
            if (orders[j].prio < tmp.prio || (orders[j].prio == tmp.prio && orders[j].id < tmp.id))
                break;
            orders[j + 1] = orders[j];
            j--;
        }
        orders[j + 1] = tmp;
    }

    /* search by id */
    sum = 0;
    for (s = 1; s <= 8; s++) {
        wanted = next_id - s * 6;
        found = 0;
        for (i = 0; i < NO; i++) {
            if (orders[i].id == wanted) {
                found = i + 1;
                break;
            }
        }
        sum += (uint32_t)(found * s);
    }

    /* statistics */
    for (s = 0; s < 8; s++) {
        stations[s].count = 0;
        stations[s].late = 0;
        stations[s].load = 0.0f;
        stations[s].first_id = 0;
    }
    heaviest = 0;
    for (i = 0; i < NO; i++) {
        s = orders[i].station;
        stations[s].count++;
        stations[s].load += orders[i].weight;
        if (orders[i].due < 20)
            stations[s].late++;
        if (stations[s].first_id == 0)
            stations[s].first_id = orders[i].id;
        if (orders[i].weight > orders[heaviest].weight)
            heaviest = i;
    }

    for (s = 0; s < 8; s++)
        sum = sum * 3u + (uint32_t)(stations[s].count + stations[s].late * 5
              + (int32_t)(stations[s].load * 4.0f) + stations[s].first_id);
    for (i = 0; i < NO; i++)
        sum += (uint32_t)orders[i].id * (uint32_t)(i + 1) + (uint32_t)orders[i].pos.x;
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)(heaviest + 1));
}
