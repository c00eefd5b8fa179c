/* Product tracking: buffer of 64 packs - update, search, sort, statistics per lane */
#include <stdbool.h>
#include "st.h"

#define NPACK 64
#define NLANE 8

typedef struct {
    int32_t id;
    int16_t lane;
    int16_t count;
    float weight;
    bool good;
    bool sealed;
    int32_t pos;
} Pack;

typedef struct {
    int16_t packs;
    int16_t rejects;
    float wsum;
    int32_t oldest;
} LaneStat;

static void sort_packs(Pack *p)
{
    int16_t i, j;

    /* insertion sort by position, then id; nearly sorted from scan to scan */
    for (i = 1; i < NPACK; i++) {
        Pack key = p[i];
        j = i - 1;
        while (j >= 0) {
            if (p[j].pos < key.pos || (p[j].pos == key.pos && p[j].id <= key.id))
                break;
            p[j + 1] = p[j];
            j--;
        }
        p[j + 1] = key;
    }
}

static Pack packs[NPACK];
static LaneStat lanes[NLANE];
static int32_t nextId = 1;
static bool ready;

void scan(void)
{
    int16_t i, k, best, hit;
    int32_t want, sum;

    if (!ready) {
        for (i = 0; i < NPACK; i++) {
            packs[i].id = nextId;
            packs[i].lane = i % 8;
            packs[i].weight = 250.0f + (float)((i * 37) % 50) * 0.1f;
            packs[i].good = true;
            packs[i].pos = ((i * 29) % 64) * 20;
            nextId++;
        }
        ready = true;
    }

    /* move the packs along */
    for (i = 0; i < NPACK; i++) {
        Pack *p = &packs[i];
        p->pos += 5 + p->lane;
        p->count = (p->count + 1) % 1000;
        p->sealed = p->pos > 400;
        p->good = p->weight >= 250.5f && p->weight < 254.5f;
        if (p->pos > 1500) {
            /* leaves the machine, a new one enters */
            p->id = nextId;
            p->pos -= 1500;
            p->count = 0;
            p->weight = 250.0f + (float)((nextId * 37) % 50) * 0.1f;
            nextId = nextId % 100000 + 1;
        }
    }

    sort_packs(packs);

    /* statistics per lane */
    for (k = 0; k < NLANE; k++) {
        lanes[k].packs = 0;
        lanes[k].rejects = 0;
        lanes[k].wsum = 0.0f;
        lanes[k].oldest = 0;
    }
    for (i = 0; i < NPACK; i++) {
        LaneStat *l = &lanes[packs[i].lane];
        l->packs++;
        l->wsum += packs[i].weight;
        if (!packs[i].good)
            l->rejects++;
        if (l->oldest == 0 || packs[i].id < l->oldest)
            l->oldest = packs[i].id;
    }

    /* search a pack by id, and the heaviest sealed one */
    want = nextId - 33;
    hit = -1;
    for (i = 0; i < NPACK; i++) {
        if (packs[i].id == want) {
            hit = i;
            break;
        }
    }
    best = 0;
    for (i = 1; i < NPACK; i++) {
        if (packs[i].sealed && packs[i].weight > packs[best].weight)
            best = i;
    }

    sum = packs[best].id + hit * 3 + packs[NPACK - 1].pos;
    for (k = 0; k < NLANE; k++)
        sum += lanes[k].oldest * (k + 1) + lanes[k].rejects + (int32_t)lanes[k].wsum + lanes[k].packs;
    check = (check * 3 + sum) % 10000019;
}
