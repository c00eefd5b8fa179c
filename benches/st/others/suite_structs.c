/* Orders in an array of structures: updated, searched and sorted. */
#include <stdbool.h>
#include "st.h"

#define COUNT 100

enum state { IDLE, RUNNING, BLOCKED };

struct order {
    int32_t number;
    int16_t priority;
    int16_t pieces;
    float weight;
    enum state status;
    bool done;
};

static struct order orders[COUNT];
static int32_t seed = 5;
static bool started;

static bool greater(const struct order *a, const struct order *b)
{
    return a->priority > b->priority || (a->priority == b->priority && a->number > b->number);
}

void scan(void)
{
    int best = 0, found = 0;
    int32_t wanted, pieces = 0, sum = 0;
    float total = 0.0f;

    if (!started) {
        for (int i = 0; i < COUNT; i++) {
            orders[i].number = 1001 + i;
            orders[i].priority = (i + 1) % 17;
            orders[i].weight = 1.5f;
        }
        started = true;
    }

    /* update */
    for (int i = 0; i < COUNT; i++) {
        struct order *o = &orders[i];

        seed = (seed * 1103 + 12345) % 65536;
        switch (o->status) {
        case IDLE:
            if (seed % 3 == 0) {
                o->status = RUNNING;
                o->done = false;
            }
            break;
        case RUNNING:
            o->pieces += 3;
            o->weight = o->weight * 0.75f + 0.5f;
            if (o->pieces > 60) {
                o->pieces = 0;
                o->done = true;
                o->status = IDLE;
                o->weight = 20.0f;
                o->priority = seed % 50;
            } else if (seed % 10 == 0) {
                o->status = BLOCKED;
            }
            break;
        case BLOCKED:
            if (seed % 4 == 0) {
                o->status = RUNNING;
                o->priority++;
            }
            break;
        }
    }

    /* search: the order with a number, and the heaviest one */
    wanted = 1001 + seed % COUNT;
    for (int i = 0; i < COUNT; i++)
        if (orders[i].number == wanted) {
            found = i;
            break;
        }
    for (int i = 0; i < COUNT; i++) {
        if (orders[i].weight > orders[best].weight)
            best = i;
        total += orders[i].weight;
        pieces += orders[i].pieces;
        if (orders[i].done)
            sum += i + 1;
    }

    /* give the found order the first place, then sort by priority and number */
    orders[found].priority = 0;
    for (int i = 1; i < COUNT; i++) {
        struct order hold = orders[i];
        int j = i - 1;

        while (j >= 0 && greater(&orders[j], &hold)) {
            orders[j + 1] = orders[j];
            j--;
        }
        orders[j + 1] = hold;
    }

    for (int i = 0; i < COUNT; i++)
        sum += orders[i].number * (i + 1) % 1009 + orders[i].priority;
    check = (check * 31 + sum + (found + 1) + 3 * (best + 1) + pieces + (int32_t)(total * 10.0f)) % 1000003;
}
