/* 100 batch orders in an array of structures: updated, searched and sorted by priority. */
#include <stdbool.h>
#include "st.h"

#define ORDERS 100

typedef struct {
    int16_t product;
    float temp_sp;
    int32_t amount;
} recipe_t;

typedef struct {
    int32_t id;
    int16_t prio, state;
    int32_t done;
    float temp;
    recipe_t recipe;
    bool hold;
} order_t;

typedef struct {
    int16_t waiting, active, finished;
    int32_t produced;
    float max_temp;
    int32_t max_temp_id;
} stat_t;

static order_t orders[ORDERS];
static stat_t stat;
static int32_t next_id, seed = 1234;
static bool init;

static int32_t rnd(int32_t range)
{
    seed = seed * 171 % 30269;
    return seed % range;
}

/* higher priority first, then the older order */
static inline bool before(const order_t *a, const order_t *b)
{
    return a->prio != b->prio ? a->prio > b->prio : a->id < b->id;
}

static int find_order(const order_t *list, int32_t id)
{
    for (int i = 0; i < ORDERS; i++)
        if (list[i].id == id)
            return i;
    return -1;
}

static void order_step(order_t *o, stat_t *s)
{
    switch (o->state) {
    case 0: /* waiting */
        s->waiting++;
        if (!o->hold && o->prio > 3)
            o->state = 1;
        break;
    case 1: /* heat up */
        s->active++;
        o->temp += (o->recipe.temp_sp - o->temp) * 0.125f;
        if (o->temp > o->recipe.temp_sp - 2.0f)
            o->state = 2;
        break;
    case 2: /* produce */
        s->active++;
        if (!o->hold) {
            o->done += 5 + o->prio;
            s->produced += 5 + o->prio;
        }
        if (o->done >= o->recipe.amount) {
            o->done = o->recipe.amount;
            o->state = 3;
        }
        break;
    default:
        s->finished++;
        o->temp *= 0.98f;
        break;
    }
    if (o->temp > s->max_temp) {
        s->max_temp = o->temp;
        s->max_temp_id = o->id;
    }
}

static int sort_orders(order_t *list)
{
    int moves = 0;

    for (int i = 1; i < ORDERS; i++) {
        if (!before(&list[i], &list[i - 1]))
            continue;
        order_t tmp = list[i];
        int j = i - 1;
        for (; j >= 0 && before(&tmp, &list[j]); j--) {
            list[j + 1] = list[j];
            moves++;
        }
        list[j + 1] = tmp;
    }
    return moves;
}

void scan(void)
{
    if (!init) {
        init = true;
        for (int i = 1; i <= ORDERS; i++)
            orders[i - 1] = (order_t){
                .id = ++next_id,
                .prio = i % 10,
                .temp = 20.0f,
                .recipe = { i % 7, 60.0f + (float)(i % 13) * 2.5f, 300 + i * 3 },
            };
    }

    stat = (stat_t){ 0 };
    for (int i = 0; i < ORDERS; i++)
        order_step(&orders[i], &stat);

    for (int i = 0; i < ORDERS; i++) {
        order_t *o = &orders[i];
        if (o->state == 3 && o->temp < 40.0f) {
            *o = (order_t){ .id = ++next_id, .temp = 20.0f };
            o->prio = rnd(10);
            o->recipe.product = next_id % 7;
            o->recipe.temp_sp = 60.0f + (float)(next_id % 13) * 2.5f;
            o->recipe.amount = 300 + rnd(400);
        }
    }

    for (int i = 0; i < 5; i++) {
        order_t *o = &orders[rnd(100)];
        o->prio = rnd(10);
        o->hold = rnd(4) == 0;
    }

    int moves = sort_orders(orders);

    int32_t found = 0;
    for (int i = 0; i < 10; i++) {
        int p = find_order(orders, next_id - i * 8);
        if (p >= 0)
            found += p + 1 + orders[p].done;
    }

    int32_t sum = 0;
    for (int i = 0; i < ORDERS; i++)
        sum += orders[i].done * (i + 1) + orders[i].state + orders[i].recipe.product;
    sum += found + moves + stat.waiting + stat.active * 2 + stat.finished * 3
        + stat.produced + stat.max_temp_id + (int32_t)(stat.max_temp * 10.0f) + orders[0].id;
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)sum);
}
