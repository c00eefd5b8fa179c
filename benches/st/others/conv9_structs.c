#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define UNITS 24
#define QUEUE 16
#define DESTS 6

enum state { EMPTY, WAITING, MOVING, ARRIVED };

struct unit {
    int32_t id;
    float weight;
    int16_t height, dest, prio;
    enum state state;
    bool blocked;
    int32_t stamp;
};

struct order {
    int32_t unit_id;
    int16_t dest, prio;
};

struct stat {
    int16_t count, blocked, max_height;
    float weight;
    int32_t heaviest;
};

static bool init_done;
static int32_t scan_no;
static uint32_t seed = 777;
static struct unit store[UNITS], sorted[UNITS];
static struct order queue[QUEUE];
static int head, tail, used;
static struct stat stats[DESTS];
static int32_t lost;

static int32_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (int32_t)(seed >> 16);
}

static struct unit *find_unit(int32_t id)
{
    for (int i = 0; i < UNITS; i++)
        if (store[i].id == id)
            return &store[i];
    return NULL;
}

static void add(uint32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + v);
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < UNITS; i++) {
            int n = i + 1;
            store[i].id = 5000 + n * 3;
            store[i].dest = (int16_t)(1 + n % 6);
            store[i].weight = 10.0f + 1.5f * (float)n;
            store[i].height = (int16_t)(400 + n * 20);
            store[i].state = WAITING;
        }
        init_done = true;
    }
    scan_no = (int32_t)((uint32_t)scan_no + 1u);

    for (int k = 0; k < 2; k++) {
        int32_t r = next_random();
        struct unit *u = &store[r % UNITS];
        u->weight = (float)(r % 1000) * 0.05f;
        u->height = (int16_t)(300 + r % 900);
        u->dest = (int16_t)(1 + r % 6);
        u->prio = (int16_t)(r % 11);
        u->state = WAITING;
        u->stamp = scan_no;
        u->blocked = r % 9 == 0;
    }

    struct unit *u = find_unit(5003 + next_random() % 75);
    if (u) {
        if (used < QUEUE && !u->blocked) {
            queue[tail] = (struct order){ u->id, u->dest, u->prio };
            tail = (tail + 1) % QUEUE;
            used++;
            u->state = MOVING;
        } else {
            lost++;
        }
    }

    if (scan_no % 4 == 0 && used > 0) {
        struct order o = queue[head];
        head = (head + 1) % QUEUE;
        used--;
        u = find_unit(o.unit_id);
        if (u) {
            u->state = ARRIVED;
            u->dest = (int16_t)(1 + (o.dest + o.prio) % 6);
        }
    }

    memset(stats, 0, sizeof stats);
    float total = 0.0f, best = -1.0f;
    for (int i = 0; i < UNITS; i++) {
        const struct unit *v = &store[i];
        struct stat *s = &stats[v->dest - 1];
        s->count++;
        s->weight += v->weight;
        if (v->blocked)
            s->blocked++;
        if (v->height > s->max_height)
            s->max_height = v->height;
        if (v->weight > best) {
            best = v->weight;
            s->heaviest = v->id;
        }
        if (v->state == MOVING)
            total += v->weight;
    }

    memcpy(sorted, store, sizeof sorted);
    for (int i = 1; i < UNITS; i++) {
        struct unit tmp = sorted[i];
        int k = i - 1;
        while (k >= 0) {
            if (sorted[k].prio > tmp.prio ||
                (sorted[k].prio == tmp.prio && sorted[k].stamp <= tmp.stamp))
                break;
            sorted[k + 1] = sorted[k];
            k--;
        }
        sorted[k + 1] = tmp;
    }

    for (int i = 0; i < DESTS; i++) {
        add((uint32_t)(stats[i].count * 100 + stats[i].blocked));
        add((uint32_t)(stats[i].max_height + stats[i].heaviest));
        add((uint32_t)lrintf(stats[i].weight * 10.0f));
    }
    for (int i = 0; i < UNITS; i++)
        add((uint32_t)sorted[i].id);
    add((uint32_t)lrintf(total * 10.0f) + (uint32_t)lost + (uint32_t)used);
}
