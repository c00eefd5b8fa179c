/* A table of 64 orders: update, search, totals by station, sort by priority */
#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t id;
    int16_t priority;
    int16_t station;
    float weight;
    bool active;
    int16_t quantity;
} Order;

typedef struct {
    int16_t orders;
    int32_t pieces;
    float weight;
    int32_t best_id;
} StationTotal;

static Order orders[64];
static StationTotal stations[8];
static uint32_t rnd = 4711;
static int32_t next_id = 1000;
static bool started;

void scan(void)
{
    int i, j, s, found;
    uint32_t acc;

    if (!started) {
        started = true;
        for (i = 0; i < 64; i++) {
            orders[i].id = next_id;
            orders[i].priority = (int16_t)((i * 29) % 64);
            orders[i].station = (int16_t)(i % 8);
            orders[i].weight = 1.5f + (float)i * 0.25f;
            orders[i].active = true;
            orders[i].quantity = (int16_t)(5 + i % 9);
            next_id++;
        }
    }

    /* update: work on all active orders; finished ones are replaced */
    for (i = 0; i < 64; i++) {
        Order *o = &orders[i];
        if (o->active) {
            o->quantity--;
            o->weight = o->weight * 0.98f;
            if (o->quantity <= 0)
                o->active = false;
        } else {
            rnd = rnd * 1103515245u + 12345u;
            o->id = next_id;
            next_id++;
            o->priority = (int16_t)((rnd / 65536u) % 100u);
            o->station = (int16_t)((rnd / 8192u) % 8u);
            o->quantity = (int16_t)(3 + (int16_t)((rnd / 1048576u) % 20u));
            o->weight = 2.0f + (float)o->quantity * 0.5f;
            o->active = true;
        }
    }

    /* totals by station */
    for (s = 0; s < 8; s++) {
        stations[s].orders = 0;
        stations[s].pieces = 0;
        stations[s].weight = 0.0f;
        stations[s].best_id = 0;
    }
    for (i = 0; i < 64; i++) {
        if (orders[i].active) {
            StationTotal *t = &stations[orders[i].station];
            t->orders++;
            t->pieces += orders[i].quantity;
            t->weight += orders[i].weight;
            if (orders[i].id > t->best_id)
                t->best_id = orders[i].id;
        }
    }

    /* insertion sort: highest priority first, then the older order */
    for (i = 1; i < 64; i++) {
        Order tmp = orders[i];
        j = i - 1;
        while (j >= 0) {
            if (orders[j].priority > tmp.priority)
                break;
            if (orders[j].priority == tmp.priority && orders[j].id <= tmp.id)
                break;
            orders[j + 1] = orders[j];
            j--;
        }
        orders[j + 1] = tmp;
    }

    /* search: where are the newest order and the best order of each station */
    found = -1;
    for (i = 0; i < 64; i++) {
        if (orders[i].id == next_id - 1) {
            found = i;
            break;
        }
    }
    acc = (uint32_t)found;
    for (s = 0; s < 8; s++) {
        for (i = 0; i < 64; i++) {
            if (orders[i].id == stations[s].best_id) {
                acc = acc * 3u + (uint32_t)i;
                break;
            }
        }
        acc += (uint32_t)(stations[s].pieces + stations[s].orders + (int32_t)(stations[s].weight * 10.0f));
    }

    check = (int32_t)((uint32_t)check * 31u + acc);
}
