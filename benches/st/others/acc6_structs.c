#include <stdbool.h>
#include "st.h"

typedef enum { RED, GREEN, BLUE, BLACK } color_t;
typedef struct { float x, y; } point_t;
typedef struct {
    int32_t id;
    int16_t kind;
    color_t color;
    point_t pos, speed;
    float weight;
    bool good;
    uint16_t passes;
} part_t;
typedef struct { int32_t count, bad; float weight; int32_t heaviest; } stat_t;

#define PARTS 120

static part_t parts[PARTS], history[16];
static stat_t stats[5];
static int32_t n;
static bool started;

static void init(void)
{
    static const color_t colors[4] = { RED, GREEN, BLUE, BLACK };
    for (int i = 1; i <= PARTS; i++)
        parts[i - 1] = (part_t){ .id = i, .kind = (int16_t)(i * 7 % 5), .color = colors[i % 4],
                                 .speed = { 0.5f + (float)i * 0.01f, 0.25f },
                                 .weight = 10.0f + (float)(i * 13 % 29), .good = true };
}

void scan(void)
{
    int32_t sum = 0;

    if (!started) {
        started = true;
        init();
    }
    n++;

    for (part_t *p = parts; p < parts + PARTS; p++) {
        p->pos.x += p->speed.x;
        p->pos.y += p->speed.y;
        if (p->pos.x > 100.0f) {
            p->pos.x -= 100.0f;
            p->passes++;
            p->weight *= 0.999f;
        }
        if (p->pos.y > 20.0f || p->pos.y < 0.0f)
            p->speed.y = -p->speed.y;
        p->good = p->weight > 15.0f && p->color != BLACK;
    }

    for (int i = 0; i < 5; i++)
        stats[i] = (stat_t){ .heaviest = -1 };
    for (int i = 0; i < PARTS; i++) {
        const part_t *p = &parts[i];
        stat_t *s = &stats[p->kind];
        s->count++;
        s->weight += p->weight;
        if (!p->good)
            s->bad++;
        if (s->heaviest < 0 || p->weight > parts[s->heaviest].weight)
            s->heaviest = i;
    }

    for (int i = 0; i < PARTS - 1; i++)
        if (parts[i].pos.x > parts[i + 1].pos.x) {
            part_t t = parts[i];
            parts[i] = parts[i + 1];
            parts[i + 1] = t;
        }

    history[n % 16] = parts[n % PARTS];

    for (int i = 0; i < 5; i++)
        sum += stats[i].count * 3 + stats[i].bad * 5 + parts[stats[i].heaviest].id + (int32_t)stats[i].weight;
    for (int i = 0; i < 16; i++)
        sum += history[i].id + history[i].passes;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
