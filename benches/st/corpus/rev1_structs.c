/* Parcels on a sorter: move, renew, look up, count by destination, find the heaviest, sort by priority. */
#include <stdbool.h>
#include <string.h>
#include "st.h"

struct parcel { int32_t id; int16_t weight, dest, prio; float pos, speed; bool active; };
struct lane { int16_t count; int32_t weight; int16_t heaviest; };

static int32_t seed = 5;
static struct parcel parcels[128], list[128];
static struct lane lanes[8];
static int32_t next_id;

static int32_t sort(const struct parcel *from)
{
    memcpy(list, from, sizeof list);
    for (int i = 1; i < 128; i++) {
        struct parcel item = list[i];
        int j = i;
        while (j > 0) {
            if (list[j - 1].prio < item.prio || (list[j - 1].prio == item.prio && list[j - 1].id <= item.id))
                break;
            list[j] = list[j - 1];
            j--;
        }
        list[j] = item;
    }
    return list[0].id + list[63].id + list[127].id;
}

void scan(void)
{
    /* move; what has left the belt is replaced by a new parcel */
    for (int i = 0; i < 128; i++) {
        struct parcel *p = &parcels[i];
        if (p->active) {
            p->pos = p->pos + p->speed * 0.1f;
            if (p->pos > 50.0f) p->active = false;
        } else {
            seed = (seed * 1103 + 12345) % 65536;
            next_id = (next_id + 1) % 100000;
            p->id = next_id;
            p->weight = (int16_t)(seed % 3000);
            p->dest = (int16_t)(seed / 16 % 8);
            p->prio = (int16_t)(seed / 32 % 10);
            p->pos = 0.0f;
            p->speed = 5.0f + (float)(i % 9);
            p->active = true;
        }
    }

    /* statistics of the lanes */
    for (int k = 0; k < 8; k++) {
        lanes[k].count = 0;
        lanes[k].weight = 0;
        lanes[k].heaviest = 0;
    }
    for (int i = 0; i < 128; i++) {
        if (parcels[i].active) {
            struct lane *l = &lanes[parcels[i].dest];
            l->count++;
            l->weight += parcels[i].weight;
            if (parcels[i].weight > l->heaviest) l->heaviest = parcels[i].weight;
        }
    }

    /* look up ten parcels by number */
    int32_t sum = 0;
    for (int n = 0; n < 10; n++) {
        int32_t wanted = next_id - n * 9;
        int found = -1;
        for (int i = 0; i < 128; i++) {
            if (parcels[i].id == wanted) {
                found = i;
                break;
            }
        }
        sum += found;
    }

    int32_t result = sort(parcels);
    for (int k = 0; k < 8; k++)
        sum += lanes[k].weight + lanes[k].count * 3 + lanes[k].heaviest;
    check = (check * 31 + sum + result) % 1000003;
}
