#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

enum { PALLETS = 64, ORDERS = 16, HISTORY = 32, KINDS = 4 };

enum kind { EMPTY, RAW, FINISHED, REJECTED };

struct point { int32_t x, y; };

struct pallet {
    int32_t id;
    enum kind kind;
    bool active;
    int16_t weight;
    struct point position, speed;
    int32_t age;
};

struct order {
    int32_t pallet, priority;
    struct point goal;
};

struct total { int32_t count, weight, oldest; };

static struct pallet pallets[PALLETS];
static struct pallet history[HISTORY];
static struct order orders[ORDERS];
static struct point crane = { 500, 300 };
static int slot;
static int32_t scan_no;
static bool initialised;

static int32_t distance(struct point a, struct point b)
{
    return abs(a.x - b.x) + abs(a.y - b.y);
}

static int32_t move_all(void)
{
    int32_t bounces = 0;
    for (int i = 0; i < PALLETS; i++) {
        struct pallet *p = &pallets[i];
        if (p->active) {
            p->position.x += p->speed.x;
            p->position.y += p->speed.y;
            if (p->position.x < 0 || p->position.x > 1000) {
                p->speed.x = -p->speed.x;
                bounces++;
            }
            if (p->position.y < 0 || p->position.y > 600) {
                p->speed.y = -p->speed.y;
                bounces++;
            }
        }
        p->age++;
    }
    return bounces;
}

static struct pallet *nearest_to(struct point place)
{
    int32_t best = 1000000;
    struct pallet *found = &pallets[0];
    for (int i = 0; i < PALLETS; i++) {
        if (!pallets[i].active)
            continue;
        int32_t d = distance(pallets[i].position, place);
        if (d < best) {
            best = d;
            found = &pallets[i];
        }
    }
    return found;
}

static int32_t sort_orders(void)
{
    int32_t moves = 0;
    for (int i = 1; i < ORDERS; i++) {
        struct order item = orders[i];
        int k = i;
        while (k > 0 && orders[k - 1].priority < item.priority) {
            orders[k] = orders[k - 1];
            k--;
            moves++;
        }
        orders[k] = item;
    }
    return moves;
}

static void initialise(void)
{
    for (int i = 0; i < PALLETS; i++) {
        pallets[i] = (struct pallet){
            .id = 1000 + i,
            .kind = (enum kind)(i % 4),
            .active = i % 7 != 3,
            .weight = (int16_t)(50 + i * 3),
            .position = { i * 15, i * 37 % 600 },
            .speed = { i % 9 - 4, i % 5 - 2 },
        };
    }
    for (int i = 0; i < ORDERS; i++) {
        orders[i].pallet = i * 4;
        orders[i].priority = i * 29 % 50;
    }
}

void scan(void)
{
    if (!initialised) {
        initialise();
        initialised = true;
    }

    uint32_t sum = (uint32_t)move_all();

    struct pallet *pick = nearest_to(crane);
    history[slot] = *pick;
    crane = pick->position;
    crane.x = (crane.x + 333) % 1000;
    pick->age = 0;
    pick->weight++;
    pick->kind = (enum kind)((pick->kind + 1) % KINDS);
    slot = (slot + 1) % HISTORY;

    for (int i = 0; i < ORDERS; i++)
        orders[i].priority += 1 + orders[i].pallet % 3;
    orders[0] = (struct order){ pick->id, scan_no * 7 % 40, crane };
    sum += (uint32_t)sort_orders();

    struct total totals[KINDS] = { { 0 } };
    for (int i = 0; i < PALLETS; i++) {
        struct total *t = &totals[pallets[i].kind];
        t->count++;
        t->weight += pallets[i].weight;
        if (pallets[i].age > t->oldest)
            t->oldest = pallets[i].age;
    }
    for (int i = 0; i < KINDS; i++)
        sum = sum * 3 + (uint32_t)(totals[i].count + totals[i].weight - totals[i].oldest);
    sum += (uint32_t)(history[slot].id + history[slot].position.x - orders[ORDERS - 1].goal.y
                      + orders[7].priority);
    scan_no++;
    check = (int32_t)((uint32_t)check * 31u + sum);
}
