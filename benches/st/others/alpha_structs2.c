/* Alarm list: raise, acknowledge and clear alarms, sort the display list */
#include <stdbool.h>
#include "st.h"

typedef struct { int16_t id, prio, state, area; int32_t stamp; float value; } Alarm;
typedef struct { int16_t id, prio, area; } TagInfo;

#define SLOTS 64
#define TAGS 200

static bool first = true;
static int32_t cycle;
static uint32_t seed = 2024;
static Alarm list[SLOTS], view[SLOTS];
static TagInfo tags[TAGS];

void scan(void)
{
    int i, j, k, n;
    int16_t per_area[8];
    if (first) {
        for (i = 0; i < TAGS; i++) {
            tags[i].id = 100 + i * 7;
            tags[i].prio = i * 5 % 4 + 1;
            tags[i].area = i % 8;
        }
        first = false;
    }
    cycle++;

    for (k = 0; k < 8; k++) {
        int lo, hi, mid, slot, free_slot;
        int16_t id;
        bool active;
        seed = seed * 1664525u + 1013904223u;
        id = 100 + (int16_t)(seed / 65536u % 200u) * 7;
        active = seed / 16777216u % 3u != 0;

        lo = 0;
        hi = TAGS - 1;
        mid = 0;
        while (lo <= hi) {
            mid = (lo + hi) / 2;
            if (tags[mid].id == id)
                break;
            else if (tags[mid].id < id)
                lo = mid + 1;
            else
                hi = mid - 1;
        }

        slot = -1;
        free_slot = -1;
        for (i = 0; i < SLOTS; i++) {
            if (list[i].state == 0) {
                if (free_slot < 0) free_slot = i;
            } else if (list[i].id == id) {
                slot = i;
                break;
            }
        }

        if (active) {
            if (slot >= 0) {
                list[slot].state = 1;
                list[slot].value += 0.5f;
            } else if (free_slot >= 0) {
                Alarm *a = &list[free_slot];
                a->id = id;
                a->prio = tags[mid].prio;
                a->area = tags[mid].area;
                a->state = 1;
                a->stamp = cycle;
                a->value = 1.0f;
            }
        } else if (slot >= 0) {
            if (list[slot].state == 2)
                list[slot].state = 0;
            else
                list[slot].state = 3;
        }
    }

    if (cycle % 5 == 0) {
        j = cycle / 5 % 8;
        for (i = 0; i < SLOTS; i++) {
            if (list[i].area == j) {
                if (list[i].state == 1)
                    list[i].state = 2;
                else if (list[i].state == 3)
                    list[i].state = 0;
            }
        }
    }

    n = 0;
    for (i = 0; i < 8; i++)
        per_area[i] = 0;
    for (i = 0; i < SLOTS; i++) {
        if (list[i].state != 0) {
            view[n++] = list[i];
            per_area[list[i].area]++;
        }
    }
    for (i = 1; i < n; i++) {
        Alarm tmp = view[i];
        j = i - 1;
        while (j >= 0) {
            if (view[j].prio < tmp.prio || (view[j].prio == tmp.prio && view[j].stamp >= tmp.stamp))
                break;
            view[j + 1] = view[j];
            j--;
        }
        view[j + 1] = tmp;
    }

    for (i = 0; i < n; i++)
        check = (int32_t)((uint32_t)check * 7u + (uint32_t)view[i].id + (uint32_t)view[i].stamp + (uint32_t)view[i].state);
    check = (int32_t)((uint32_t)check + (uint32_t)n + (uint32_t)(per_area[3] * 100) + (uint32_t)(int32_t)view[0].value);
}
