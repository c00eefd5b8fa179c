#include <stdbool.h>
#include "st.h"

typedef struct {
    int32_t id, key, age;
    float weight, temp;
    int16_t grade, station;
    bool ok;
} Part;

static int32_t n;
static Part parts[100];

void scan(void)
{
    if (n == 0)
        for (int i = 0; i < 100; i++) {
            parts[i].id = i;
            parts[i].key = (i * 277) % 1009;
            parts[i].weight = 10.0f + (float)i * 0.25f;
            parts[i].temp = 20.0f;
            parts[i].station = i % 8;
        }

    for (int i = 0; i < 100; i++) {
        Part *p = &parts[i];
        p->age++;
        p->key = (p->key * 37 + p->id * 11 + n) % 9973;
        p->temp = p->temp * 0.95f + p->weight * 0.125f;
        p->station = (p->station + 1) % 8;
        p->ok = p->temp > 30.0f && p->station != 3;
        if (p->ok) p->grade = (p->grade + 1) % 50;
        else p->temp = p->temp + 1.5f;
    }

    for (int p = 0; p < 20; p++)
        for (int i = 0; i < 99 - p; i++)
            if (parts[i].key > parts[i + 1].key) {
                Part swap = parts[i];
                parts[i] = parts[i + 1];
                parts[i + 1] = swap;
            }

    int32_t acc = 0;
    for (int i = 0; i < 100; i++) {
        const Part *p = &parts[i];
        acc = p->key + p->id * 3 + p->grade + p->station + (int32_t)(p->temp * 8.0f) - acc;
        if (p->ok) acc += p->age % 97;
    }
    n++;
    check = (check * 31 + acc) % 1000003;
}
