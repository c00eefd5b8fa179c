/* An order list of 120 entries: update, search, totals, sort */
#include <stdbool.h>
#include "st.h"

#define ORDERS 120

struct order {
    int32_t id;
    int32_t due;
    int16_t prio;
    int16_t quantity;
    int16_t done;
    float weight;
    bool active;
};

static int find_order(const struct order *list, int32_t id)
{
    int i;

    for (i = 0; i < ORDERS; i++) {
        if (list[i].id == id)
            return i;
    }
    return -1;
}

static bool ready;
static struct order orders[ORDERS];
static int32_t tick;

void scan(void)
{
    struct order tmp;
    int i, j, at, best;
    int32_t sum;
    float load;

    if (!ready) {
        ready = true;
        for (i = 0; i < ORDERS; i++) {
            orders[i].id = 1000 + i;
            orders[i].due = 500 + (i * 137) % 400;
            orders[i].prio = (int16_t)(i % 5);
            orders[i].quantity = (int16_t)(10 + i % 23);
            orders[i].weight = 1.5f + (float)(i % 7) * 0.25f;
            orders[i].active = true;
        }
    }

    tick = (tick + 1) % 10000;

    /* update: time passes, pieces are made, finished orders come back as new ones */
    for (i = 0; i < ORDERS; i++) {
        struct order *o = &orders[i];

        if (o->active) {
            o->due--;
            if ((tick + o->id) % 8 == 0)
                o->done++;
            if (o->done >= o->quantity)
                o->active = false;
        } else {
            o->active = true;
            o->done = 0;
            o->due += 300;
            o->prio = (int16_t)((o->prio + 1) % 5);
        }
    }

    /* search by number: five requests of the operator panel */
    sum = 0;
    for (j = 1; j <= 5; j++) {
        at = find_order(orders, 1000 + (tick * 11 + j * 29) % 125);
        if (at >= 0)
            sum += orders[at].quantity - orders[at].done;
    }

    /* totals and most urgent order */
    load = 0.0f;
    best = 0;
    for (i = 0; i < ORDERS; i++) {
        if (orders[i].active) {
            load += orders[i].weight * (float)(orders[i].quantity - orders[i].done);
            if (orders[i].due < orders[best].due)
                best = i;
        }
    }
    sum += orders[best].id + (int32_t)load;

    /* insertion sort by priority, then due time */
    for (i = 1; i < ORDERS; i++) {
        tmp = orders[i];
        j = i - 1;
        while (j >= 0) {
            if (orders[j].prio < tmp.prio || (orders[j].prio == tmp.prio && orders[j].due <= tmp.due))
                break;
            orders[j + 1] = orders[j];
            j--;
        }
        orders[j + 1] = tmp;
    }
    sum += orders[0].id + orders[60].due;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
