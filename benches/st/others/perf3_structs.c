/* Parts on a conveyor: they move, are measured, are sorted by priority, and leave for new ones */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

enum status { FRESH, MEASURED, GOOD, BAD };
struct point { int32_t x, y; };
struct part {
    int32_t id;
    struct point place, speed;
    float weight;
    int16_t samples[4];
    int16_t priority;
    enum status status;
    bool urgent;
};
struct statistics { int32_t count; float weight; struct point last; };

#define PARTS 64

static struct part parts[PARTS];
static struct statistics stats[4];
static int32_t next_id;
static uint32_t seed;

static int32_t measure(struct part *p)
{
    int32_t sum = 0;
    for (int i = 0; i < 4; i++)
        sum += p->samples[i];
    p->weight = p->weight * 0.5f + (float)sum * 0.125f;
    p->status = p->weight > 200.0f ? BAD : p->weight > 90.0f ? GOOD : MEASURED;
    return sum;
}

void scan(void)
{
    for (int i = 0; i < 4; i++) {
        seed = seed * 1103515245u + 12345u;
        next_id++;
        parts[next_id % PARTS] = (struct part){
            .id = next_id,
            .speed = { 1 + next_id % 7, next_id % 3 - 1 },
            .priority = (int16_t)(abs((int32_t)seed / 65536) % 100),
            .urgent = next_id % 9 == 0,
        };
    }

    uint32_t sum = 0;
    for (int i = 0; i < PARTS; i++) {
        struct part *p = &parts[i];
        p->place.x += p->speed.x;
        p->place.y += p->speed.y;
        int16_t *s = &p->samples[p->place.x % 4];
        *s = (int16_t)(*s + p->priority);
        if (*s > 900)
            *s = 0;
        sum += (uint32_t)measure(p);
    }

    for (int i = 0; i < PARTS - 1; i++) {
        struct part *p = &parts[i], *q = p + 1;
        if (p->priority < q->priority || (q->urgent && !p->urgent)) {
            struct part held = *p;
            *p = *q;
            *q = held;
        }
    }

    for (int i = 0; i < 4; i++) {
        stats[i].count = 0;
        stats[i].weight = 0.0f;
    }
    for (int i = 0; i < PARTS; i++) {
        struct statistics *s = &stats[parts[i].status];
        s->count++;
        s->weight += parts[i].weight;
        s->last = parts[i].place;
    }
    for (int i = 1; i < 4; i++)
        sum = sum * 7 + (uint32_t)stats[i].count + (uint32_t)(int32_t)(stats[i].weight * 8.0f)
            + (uint32_t)stats[i].last.x - (uint32_t)stats[i].last.y;
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)parts[0].id);
}
