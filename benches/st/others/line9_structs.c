/* Tracking of cartons: pool with free list, queue by priority, sorting and statistics */
#include "st.h"
#include <stdbool.h>

#define POOL 64
#define NONE (-1)
#define SHIPMENT 16

enum carton_state { CARTON_FREE, CARTON_QUEUED, CARTON_PACKED, CARTON_REJECTED };

struct dimensions { int16_t length, width, height; };

struct carton {
    int32_t id;
    enum carton_state state;
    int16_t priority;
    int32_t weight;
    struct dimensions dim;
    int16_t next;
};

struct pool {
    struct carton items[POOL];
    int free_head, queue_head, used;
};

struct statistics {
    int count;
    int32_t weight, volume, heaviest, lightest;
};

struct shipment {
    struct carton list[SHIPMENT];
    int count;
    bool full;
    int32_t checksum;
};

static struct pool pool;
static struct shipment shipment;
static struct statistics stat;
static struct carton carton, leaving;
static uint32_t seed = 4711;
static int32_t next_id;
static bool started;

static int32_t next_random(void)
{
    seed = seed * 1103515245u + 12345u;
    return (int32_t)(seed >> 16 & 0x7FFF);
}

static int32_t volume(const struct dimensions *d)
{
    return d->length * d->width * d->height;
}

static void init_pool(struct pool *p)
{
    for (int i = 0; i < POOL; i++) {
        p->items[i].state = CARTON_FREE;
        p->items[i].next = (int16_t)(i + 1);
    }
    p->items[POOL - 1].next = NONE;
    p->free_head = 0;
    p->queue_head = NONE;
    p->used = 0;
}

static bool enqueue(struct pool *p, const struct carton *c)
{
    int slot = p->free_head;
    if (slot == NONE)
        return false;
    struct carton *s = &p->items[slot];
    p->free_head = s->next;
    *s = *c;
    s->state = CARTON_QUEUED;
    int prev = NONE, cur = p->queue_head;
    while (cur != NONE && p->items[cur].priority >= c->priority) {
        prev = cur;
        cur = p->items[cur].next;
    }
    s->next = (int16_t)cur;
    if (prev == NONE)
        p->queue_head = slot;
    else
        p->items[prev].next = (int16_t)slot;
    p->used++;
    return true;
}

static bool dequeue(struct pool *p, struct carton *c)
{
    int slot = p->queue_head;
    if (slot == NONE)
        return false;
    struct carton *s = &p->items[slot];
    *c = *s;
    p->queue_head = s->next;
    s->state = CARTON_FREE;
    s->next = (int16_t)p->free_head;
    p->free_head = slot;
    p->used--;
    return true;
}

static void pool_statistics(const struct pool *p, struct statistics *out)
{
    struct statistics s = { .lightest = 100000 };
    for (int i = 0; i < POOL; i++) {
        const struct carton *c = &p->items[i];
        if (c->state == CARTON_QUEUED) {
            s.count++;
            s.weight += c->weight;
            s.volume = (int32_t)((uint32_t)s.volume + (uint32_t)volume(&c->dim));
            if (c->weight > s.heaviest)
                s.heaviest = c->weight;
            if (c->weight < s.lightest)
                s.lightest = c->weight;
        }
    }
    *out = s;
}

static void ship(struct shipment *s, const struct carton *c)
{
    s->list[s->count] = *c;
    s->list[s->count].state = CARTON_PACKED;
    s->count++;
    s->full = s->count >= SHIPMENT;
    if (!s->full)
        return;
    for (int i = 1; i < SHIPMENT; i++) {
        struct carton item = s->list[i];
        int j = i - 1;
        while (j >= 0 && s->list[j].weight > item.weight) {
            s->list[j + 1] = s->list[j];
            j--;
        }
        s->list[j + 1] = item;
    }
    uint32_t sum = 0;
    for (int i = 0; i < SHIPMENT; i++)
        sum = sum * 7u + (uint32_t)s->list[i].id + (uint32_t)s->list[i].weight;
    s->checksum = (int32_t)sum;
    s->count = 0;
}

static void add_check(uint32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + v);
}

void scan(void)
{
    if (!started) {
        init_pool(&pool);
        started = true;
    }

    for (int n = 0; n < 6; n++) {
        next_id = (int32_t)((uint32_t)next_id + 1u);
        carton.id = next_id;
        carton.priority = (int16_t)(next_random() % 8);
        carton.weight = 200 + next_random() % 5000;
        carton.dim.length = (int16_t)(100 + next_random() % 300);
        carton.dim.width = (int16_t)(80 + next_random() % 200);
        carton.dim.height = (int16_t)(50 + next_random() % 150);
        if (!enqueue(&pool, &carton))
            check = (int32_t)((uint32_t)check + 1u);
    }

    for (int n = 0; n < 5; n++) {
        if (dequeue(&pool, &leaving)) {
            ship(&shipment, &leaving);
            if (shipment.full)
                add_check((uint32_t)shipment.checksum);
            add_check((uint32_t)leaving.id);
        }
    }

    pool_statistics(&pool, &stat);
    add_check((uint32_t)stat.count + (uint32_t)stat.weight);
    add_check((uint32_t)stat.volume + (uint32_t)stat.heaviest - (uint32_t)stat.lightest);
}
