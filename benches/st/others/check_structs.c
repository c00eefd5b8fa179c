/* An array of 100 structures: update, search and sort. */
#include <stdbool.h>
#include "st.h"

#define COUNT 100

typedef struct { float x, y; } position_t;

typedef struct {
    int32_t id;
    int16_t prio;
    bool moving;
    position_t pos, speed;
    int32_t age;
    float weight;
} pallet_t;

static int32_t scan_no;
static int32_t seed = 271;
static pallet_t pallets[COUNT];

static int find_id(const pallet_t *p, int32_t id)
{
    for (int i = 0; i < COUNT; i++)
        if (p[i].id == id)
            return i;
    return -1;
}

void scan(void)
{
    if (scan_no == 0)
        for (int i = 1; i <= COUNT; i++)
            pallets[i - 1] = (pallet_t){
                .id = 1000 + i,
                .prio = (int16_t)(i * 7 % 50),
                .pos = { (float)i, (float)(i * 3 % 100) },
                .speed = { (float)(i % 5) * 0.25f - 0.5f, (float)(i % 7) * 0.25f - 0.75f },
                .weight = (float)(i * 13 % 90) + 10.0f,
            };
    scan_no = (scan_no + 1) % 1000000 + 1;

    for (int i = 0; i < COUNT; i++) {
        pallet_t *p = &pallets[i];
        p->pos.x += p->speed.x;
        p->pos.y += p->speed.y;
        if (p->pos.x < 0.0f || p->pos.x > 100.0f)
            p->speed.x = -p->speed.x;
        if (p->pos.y < 0.0f || p->pos.y > 100.0f)
            p->speed.y = -p->speed.y;
        p->moving = p->speed.x != 0.0f || p->speed.y != 0.0f;
        p->age++;
    }

    int32_t sum = 0;
    for (int j = 1; j <= 10; j++) {
        seed = (seed * 4005 + 12345) % 65536;
        int found = find_id(pallets, 1001 + seed / 8 % 103);
        if (found >= 0) {
            pallet_t *p = &pallets[found];
            p->prio = (int16_t)(seed / 16 % 50);
            p->weight = p->weight * 0.75f + (float)(seed % 100) * 0.25f;
            p->age = 0;
        }
        sum += (found + 1) * j;
    }

    int oldest = 0;
    float heaviest = 0.0f;
    int32_t moving = 0;
    for (int i = 0; i < COUNT; i++) {
        if (pallets[i].age > pallets[oldest].age)
            oldest = i;
        if (pallets[i].weight > heaviest)
            heaviest = pallets[i].weight;
        if (pallets[i].moving)
            moving++;
    }
    sum += pallets[oldest].id + (int32_t)(heaviest * 10.0f) + moving;

    for (int i = 1; i < COUNT; i++) {
        pallet_t t = pallets[i];
        int j = i - 1;
        while (j >= 0 && pallets[j].prio > t.prio) {
            pallets[j + 1] = pallets[j];
            j--;
        }
        pallets[j + 1] = t;
    }

    for (int i = 0; i < COUNT; i++)
        sum += (pallets[i].id - 1000) * (i + 1) + (int32_t)(pallets[i].pos.x + pallets[i].pos.y);
    check = (check * 31 + sum) % 1000003;
}
