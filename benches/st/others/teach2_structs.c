/* Example 9: Structures. Order management of the bottling line. */
#include <stdbool.h>
#include "st.h"

#define ORDERS 64
#define RECIPES 8

struct recipe {
    float syrup; /* litres per bottle */
    float water;
    int16_t bottle_ml;
};

struct order {
    int32_t id;
    int16_t recipe;
    int16_t priority;
    int32_t due;
    int16_t quantity;
    int16_t done;
    bool finished;
    float syrup; /* used so far */
};

struct stat {
    int16_t orders;
    int32_t bottles;
    float syrup;
};

static struct order order[ORDERS];
static struct recipe recipe[RECIPES];
static struct stat stat[RECIPES];
static int32_t next_id = 1000;
static int32_t cycle;
static bool init;

/* true when order a has to be made before order b */
static bool before(const struct order *a, const struct order *b)
{
    return a->priority > b->priority || (a->priority == b->priority && a->due < b->due);
}

void scan(void)
{
    int i, j, r, best, found;
    int32_t wanted;
    struct order tmp;
    uint32_t c = (uint32_t)check;

    /* recipes and first orders */
    if (!init) {
        for (i = 0; i < RECIPES; i++) {
            recipe[i].syrup = 0.05f + (float)i * 0.01f;
            recipe[i].water = 0.4f + (float)i * 0.05f;
            recipe[i].bottle_ml = (int16_t)(330 + i * 90);
        }
        for (i = 0; i < ORDERS; i++) {
            int nr = i + 1;
            order[i].id = ++next_id;
            order[i].recipe = (int16_t)(nr * 5 % 8);
            order[i].priority = (int16_t)(nr * 11 % 10);
            order[i].due = nr * 379 % 5000;
            order[i].quantity = (int16_t)(20 + nr * 17 % 50);
        }
        init = true;
    }
    cycle = (cycle + 1) % 1000000;

    /* 1. production: eight lines work on the first eight orders */
    for (i = 0; i < 8; i++) {
        struct order *o = &order[i];
        if (!o->finished) {
            o->done = (int16_t)(o->done + 1 + (i + 1) % 3);
            o->syrup += recipe[o->recipe].syrup;
            if (o->done >= o->quantity)
                o->finished = true;
        }
    }

    /* 2. finished orders are replaced by new ones, the others grow older */
    for (i = 0; i < ORDERS; i++) {
        struct order *o = &order[i];
        if (o->finished) {
            next_id++;
            tmp.id = next_id;
            tmp.recipe = (int16_t)(next_id % 8);
            tmp.priority = (int16_t)(next_id * 7 % 10);
            tmp.due = cycle + 3000 + next_id * 13 % 2000;
            tmp.quantity = (int16_t)(20 + next_id * 17 % 50);
            tmp.done = 0;
            tmp.finished = false;
            tmp.syrup = 0.0f;
            *o = tmp;
        } else if (o->due < cycle && o->priority < 9) {
            o->priority++;
            o->due += 500;
        }
    }

    /* 3. sort by insertion: high priority first, then due time */
    for (i = 1; i < ORDERS; i++) {
        tmp = order[i];
        j = i - 1;
        while (j >= 0 && before(&tmp, &order[j])) {
            order[j + 1] = order[j];
            j--;
        }
        order[j + 1] = tmp;
    }

    /* 4. search: by number, and the largest open order */
    wanted = next_id - cycle % 40;
    found = 0;
    for (i = 0; i < ORDERS; i++) {
        if (order[i].id == wanted) {
            found = i + 1;
            break;
        }
    }
    best = 0;
    for (i = 1; i < ORDERS; i++) {
        if (order[i].quantity - order[i].done > order[best].quantity - order[best].done)
            best = i;
    }

    /* 5. statistics per recipe */
    for (r = 0; r < RECIPES; r++) {
        stat[r].orders = 0;
        stat[r].bottles = 0;
        stat[r].syrup = 0.0f;
    }
    for (i = 0; i < ORDERS; i++) {
        struct stat *s = &stat[order[i].recipe];
        int16_t open = (int16_t)(order[i].quantity - order[i].done);
        s->orders++;
        s->bottles += open;
        s->syrup += (float)open * recipe[order[i].recipe].syrup;
    }

    c = c * 31u + (uint32_t)(found * 100 + best + 1) + (uint32_t)order[0].id;
    for (r = 0; r < RECIPES; r++)
        c = c * 31u + (uint32_t)stat[r].bottles + (uint32_t)stat[r].orders
            + (uint32_t)(int32_t)(stat[r].syrup * 10.0f);
    check = (int32_t)c;
}
