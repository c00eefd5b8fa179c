#include "st.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

#define SIZE 32
#define ARTICLES 8
#define QUEUE 16

enum order_state { WAITING, ACTIVE, FINISHED };

struct order {
    int32_t id;
    int16_t article, quantity, priority;
    float weight;
    enum order_state state;
};

struct summary {
    int16_t orders;
    int32_t pieces;
    float heaviest, load;
};

static struct { struct order buffer[QUEUE]; int read, write, count; } queue;
static struct order table[SIZE], sorted[SIZE];
static struct summary stats[ARTICLES];
static uint32_t seed = 99;
static int32_t next_id, scans;
static int slot;

static void queue_put(const struct order *o)
{
    if (queue.count == QUEUE)
        return;
    queue.buffer[queue.write] = *o;
    queue.write = (queue.write + 1) % QUEUE;
    queue.count++;
}

static bool queue_get(struct order *o)
{
    if (queue.count == 0)
        return false;
    *o = queue.buffer[queue.read];
    queue.read = (queue.read + 1) % QUEUE;
    queue.count--;
    return true;
}

static void sort_by_id(struct order *a, int n)
{
    for (int i = 1; i < n; i++) {
        struct order moved = a[i];
        int j = i - 1;
        while (j >= 0 && a[j].id > moved.id) {
            a[j + 1] = a[j];
            j--;
        }
        a[j + 1] = moved;
    }
}

static int find_id(const struct order *a, int n, int32_t wanted)
{
    int low = 0, high = n - 1;
    while (low <= high) {
        int middle = (low + high) / 2;
        if (a[middle].id == wanted)
            return middle;
        if (a[middle].id < wanted)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}

static void add_check(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

void scan(void)
{
    scans = (int32_t)((uint32_t)scans + 1);

    for (int i = 1; i <= 2; i++) {
        seed = seed * 1664525u + 1013904223u;
        next_id = (int32_t)((uint32_t)next_id + 1 + seed / 1073741824u);
        struct order fresh = {
            .id = next_id,
            .article = (int16_t)(seed / 65536u % 8),
            .quantity = (int16_t)(seed / 1048576u % 100 + 1),
            .priority = (int16_t)(seed / 16777216u % 10),
            .state = WAITING,
        };
        fresh.weight = (float)fresh.quantity * 0.25f + (float)fresh.article;
        queue_put(&fresh);
        if ((i == 1 || scans % 4 != 0) && queue_get(&table[slot]))
            slot = (slot + 1) % SIZE;
    }
    add_check(queue.count);

    for (int i = 0; i < SIZE; i++) {
        struct order *o = &table[i];
        switch (o->state) {
        case WAITING:
            if (o->priority > 6)
                o->state = ACTIVE;
            else
                o->priority++;
            break;
        case ACTIVE:
            o->quantity = (int16_t)(o->quantity - 9);
            if (o->quantity <= 0) {
                o->quantity = 0;
                o->state = FINISHED;
            }
            break;
        case FINISHED:
            break;
        }
    }

    memset(stats, 0, sizeof stats);
    for (int i = 0; i < SIZE; i++) {
        const struct order *o = &table[i];
        if (o->state == FINISHED)
            continue;
        struct summary *s = &stats[o->article];
        s->orders++;
        s->pieces += o->quantity;
        s->load += o->weight;
        if (o->weight > s->heaviest)
            s->heaviest = o->weight;
    }
    for (int i = 0; i < ARTICLES; i++) {
        add_check(stats[i].orders + stats[i].pieces);
        add_check((int32_t)lrintf((stats[i].load + stats[i].heaviest) * 4.0f));
    }

    memcpy(sorted, table, sizeof sorted);
    sort_by_id(sorted, SIZE);

    for (int i = 0; i < 8; i++) {
        int found = find_id(sorted, SIZE, (int32_t)((uint32_t)next_id - 20u - (uint32_t)i * 5u));
        add_check(found);
        if (found >= 0)
            check = (int32_t)((uint32_t)check + (uint32_t)(sorted[found].priority + sorted[found].quantity));
    }
}
