#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t id;
    int16_t prio;
    int16_t zone;
    float weight;
    bool active;
    int32_t stamp;
} Part;

typedef struct {
    int32_t count;
    float total;
    float heaviest;
    int32_t lastId;
} ZoneStat;

static int32_t scanNo;
static bool first = true;
static uint32_t seed = 4711;
static Part parts[192];
static ZoneStat zones[8];

void scan(void)
{
    int32_t i, j, z, wanted, found, acc;
    float sum;
    Part key;

    if (first) {
        for (i = 0; i < 192; i++) {
            parts[i].id = 1000 + i * 3;
            parts[i].prio = (int16_t)(i * 37 % 100);
            parts[i].zone = (int16_t)(i % 8);
            parts[i].weight = 1.0f + (float)i * 0.5f;
            parts[i].active = i % 5 != 0;
        }
        first = false;
    }

    scanNo++;

    for (i = 0; i < 16; i++) {
        seed = seed * 1664525u + 1013904223u;
        j = (int32_t)(seed / 65536 % 192);
        parts[j].prio = (int16_t)(seed / 4096 % 100);
        parts[j].active = !parts[j].active;
        parts[j].stamp = scanNo;
    }

    for (i = 0; i < 192; i++) {
        if (parts[i].active)
            parts[i].weight = parts[i].weight * 0.99f + 0.25f;
        else
            parts[i].weight = parts[i].weight + 0.125f;
        if (scanNo - parts[i].stamp > 40) {
            parts[i].zone = (int16_t)((parts[i].zone + 1) % 8);
            parts[i].stamp = scanNo;
        }
    }

    for (z = 0; z < 8; z++) {
        zones[z].count = 0;
        zones[z].total = 0.0f;
        zones[z].heaviest = 0.0f;
    }
    for (i = 0; i < 192; i++) {
        z = parts[i].zone;
        zones[z].count++;
        zones[z].total += parts[i].weight;
        if (parts[i].weight > zones[z].heaviest) {
            zones[z].heaviest = parts[i].weight;
            zones[z].lastId = parts[i].id;
        }
    }

    for (i = 1; i < 192; i++) {
        key = parts[i];
        j = i - 1;
        while (j >= 0) {
            if (parts[j].prio <= key.prio)
                break;
            parts[j + 1] = parts[j];
            j--;
        }
        parts[j + 1] = key;
    }

    acc = 0;
    for (i = 0; i < 10; i++) {
        wanted = 1000 + (scanNo + i * 7) % 200 * 3;
        found = -1;
        for (j = 0; j < 192; j++) {
            if (parts[j].id == wanted) {
                found = j;
                break;
            }
        }
        acc += found;
    }

    sum = 0.0f;
    for (z = 0; z < 8; z++) {
        acc += zones[z].count * (z + 1) + zones[z].lastId;
        sum = sum + zones[z].total + zones[z].heaviest;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(acc + (int32_t)sum + parts[0].id + parts[191].prio));
}
