/* Tag database: scale and limit check of 80 tags, search by number, alarm list sorted by priority */
#include <stdbool.h>
#include "st.h"

#define TAGS 80

struct tag {
    int16_t id;
    int16_t prio;
    int16_t raw;
    float value;
    float mn, mx;
    float lim_hi, lim_lo;
    bool alarm;
    bool acked;
    int32_t count;
    int32_t stamp;
};

struct alarm_entry {
    int16_t id;
    int16_t prio;
    int32_t stamp;
    float value;
};

static bool init;
static int32_t scan_no;
static struct tag tags[TAGS];
static struct alarm_entry list[TAGS];
static uint32_t seed = 12345;

void scan(void)
{
    int i, j, k, n_list, found, best;
    int16_t wanted;
    int32_t hits;
    bool state;
    float sum;
    struct alarm_entry entry;

    if (!init) {
        for (i = 0; i < TAGS; i++) {
            int n = i + 1;
            tags[i].id = 1000 + (n * 37) % 80;
            tags[i].prio = n % 4 + 1;
            tags[i].raw = 10000 + n * 50;
            tags[i].mn = 0.0f;
            tags[i].mx = 100.0f + (float)(n % 10) * 10.0f;
            tags[i].lim_hi = tags[i].mx * 0.75f;
            tags[i].lim_lo = tags[i].mx * 0.25f;
        }
        init = true;
    }

    scan_no++;

    /* telegrams: 10 new raw values, addressed by tag number */
    hits = 0;
    for (j = 0; j < 10; j++) {
        seed = seed * 1664525u + 1013904223u;
        wanted = 1000 + (seed / 65536) % 84;
        found = -1;
        for (i = 0; i < TAGS; i++) {
            if (tags[i].id == wanted) {
                found = i;
                break;
            }
        }
        if (found >= 0) {
            tags[found].raw = (seed / 1024) % 27648;
            tags[found].count++;
            hits += found + 1;
        }
    }

    /* scale, limits */
    sum = 0.0f;
    for (i = 0; i < TAGS; i++) {
        struct tag *t = &tags[i];
        t->value = t->mn + (float)t->raw * (t->mx - t->mn) / 27648.0f;
        state = t->value > t->lim_hi || t->value < t->lim_lo;
        if (state && !t->alarm) {
            t->stamp = scan_no;
            t->acked = false;
        }
        t->alarm = state;
        sum = sum + t->value;
    }

    /* operator acknowledges one tag per scan */
    k = scan_no % 80;
    tags[k].acked = true;

    /* alarm list, insertion sort: priority, then newest first */
    n_list = 0;
    for (i = 0; i < TAGS; i++) {
        if (tags[i].alarm && !tags[i].acked) {
            entry.id = tags[i].id;
            entry.prio = tags[i].prio;
            entry.stamp = tags[i].stamp;
            entry.value = tags[i].value;
            for (j = n_list - 1; j >= 0; j--) {
                if (list[j].prio < entry.prio
                    || (list[j].prio == entry.prio && list[j].stamp >= entry.stamp))
                    break;
                list[j + 1] = list[j];
            }
            list[j + 1] = entry;
            n_list++;
        }
    }

    /* tag with the most telegrams */
    best = 0;
    for (i = 1; i < TAGS; i++) {
        if (tags[i].count > tags[best].count)
            best = i;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(hits + n_list + best + 1 + (int32_t)sum));
    if (n_list > 0)
        check = (int32_t)((uint32_t)check + (uint32_t)(list[0].id * 7 + list[n_list - 1].id
                          + list[n_list - 1].stamp + (int32_t)list[0].value));
}
