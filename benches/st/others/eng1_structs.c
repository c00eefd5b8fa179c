/* pallet tracking: records in an array, update, search, sorted order queue, statistics */
#include <stdbool.h>
#include "st.h"

enum pallet_state { PAL_EMPTY, PAL_MOVING, PAL_WAITING, PAL_LOADING, PAL_LOCKED };

typedef struct {
    int16_t lane, place;
    float x;
} Pos;

typedef struct {
    int32_t id;
    enum pallet_state state;
    int16_t prio, dest, timer;
    float weight;
    Pos pos;
    bool hazard;
} Pallet;

typedef struct {
    int16_t count, best_prio, best_idx;
    float weight;
} DestStat;

#define PALS 200
#define QUEUE 64

static Pallet pal[PALS];
static Pallet queue[QUEUE];
static DestStat stat[8];
static int32_t arrivals;
static int16_t tick;
static bool init;

static void pallet_step(Pallet *p)
{
    switch (p->state) {
    case PAL_EMPTY:
        p->timer++;
        if (p->timer > 10) {
            p->state = PAL_MOVING;
            p->timer = 0;
            p->pos.x = 0.0f;
        }
        break;
    case PAL_MOVING:
        p->pos.x += 1.5f;
        if (p->pos.x >= 60.0f) {
            p->state = PAL_WAITING;
            arrivals++;
            p->pos.place = (p->pos.place + 1) % 10;
        }
        break;
    case PAL_WAITING:
        p->timer++;
        if (p->timer > 15 + p->prio % 8) {
            p->state = PAL_LOADING;
            p->timer = 0;
        }
        break;
    case PAL_LOADING:
        p->weight += 12.5f;
        if (p->weight > 400.0f) {
            p->weight = 20.0f;
            p->dest = (p->dest + 3) % 8;
            p->prio = (p->prio * 7 + tick) % 100;
            if (p->hazard && p->dest == 0)
                p->state = PAL_LOCKED;
            else
                p->state = PAL_EMPTY;
            p->timer = 0;
        }
        break;
    case PAL_LOCKED:
        p->timer++;
        if (p->timer > 30) {
            p->state = PAL_EMPTY;
            p->dest = 1;
            p->timer = 0;
        }
        break;
    }
}

void scan(void)
{
    int i, j, nqueue, found;
    int32_t wanted, sum;
    Pallet key;

    if (!init) {
        for (i = 0; i < PALS; i++) {
            pal[i].id = 10000 + i * 37;
            pal[i].state = PAL_MOVING;
            pal[i].prio = (i * 29) % 100;
            pal[i].dest = i % 8;
            pal[i].weight = 20.0f + (float)i;
            pal[i].pos.lane = i / 10;
            pal[i].pos.place = i % 10;
            pal[i].pos.x = (float)(i % 40) * 1.5f;
            pal[i].hazard = i % 9 == 0;
        }
        init = true;
    }
    tick = (tick + 1) % 1000;

    /* update */
    for (i = 0; i < PALS; i++)
        pallet_step(&pal[i]);

    /* statistics for each destination */
    for (i = 0; i < 8; i++) {
        stat[i].count = 0;
        stat[i].best_prio = -1;
        stat[i].best_idx = -1;
        stat[i].weight = 0.0f;
    }
    for (i = 0; i < PALS; i++) {
        DestStat *s = &stat[pal[i].dest];
        s->count++;
        s->weight += pal[i].weight;
        if (pal[i].prio > s->best_prio) {
            s->best_prio = pal[i].prio;
            s->best_idx = (int16_t)i;
        }
    }

    /* the waiting and loading pallets into the queue */
    nqueue = 0;
    for (i = 0; i < PALS; i++)
        if (pal[i].state == PAL_WAITING || pal[i].state == PAL_LOADING)
            if (nqueue < QUEUE)
                queue[nqueue++] = pal[i];

    /* sort by priority, then by number */
    for (i = 1; i < nqueue; i++) {
        key = queue[i];
        for (j = i - 1; j >= 0; j--) {
            if (queue[j].prio > key.prio || (queue[j].prio == key.prio && queue[j].id < key.id))
                break;
            queue[j + 1] = queue[j];
        }
        queue[j + 1] = key;
    }

    /* search of one pallet by its number */
    wanted = 10000 + (tick % 200) * 37;
    found = -1;
    for (i = 0; i < PALS; i++)
        if (pal[i].id == wanted) {
            found = i;
            break;
        }

    sum = 0;
    for (i = 0; i < 8; i++)
        sum += stat[i].count * (i + 1) + stat[i].best_idx + (int32_t)stat[i].weight;
    if (found >= 0)
        sum += pal[found].prio + pal[found].pos.place + pal[found].pos.lane;
    for (i = 0; i < nqueue; i++)
        sum += queue[i].id % 101 * i;
    check = (int32_t)((uint32_t)check * 31u + sum + arrivals % 1000);
}
