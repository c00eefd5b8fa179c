#include <stdbool.h>
#include <string.h>
#include "st.h"

enum { N = 100 };
typedef enum { SMALL, MEDIUM, LARGE } Kind;
typedef struct {
    int32_t id;
    Kind kind;
    float position, speed;
    int16_t weight;
    bool rejected;
} Part;
typedef struct { int32_t count, weight; } Statistics;

static Part parts[N];
static int next_id;
static bool filled;

static void fill(void)
{
    for (int i = 0; i < N; i++) {
        parts[i].id = i;
        parts[i].position = (float)i * 0.5f;
        parts[i].speed = 0.1f + (float)(i % 7) * 0.05f;
        parts[i].weight = (int16_t)(i * 37 % 300);
    }
    next_id = N;
    filled = true;
}

void scan(void)
{
    if (!filled) fill();

    Statistics stats[3] = {{0}};
    int heaviest = 0, rejects = 0;
    for (int i = 0; i < N; i++) {
        Part *p = &parts[i];
        p->position += p->speed;
        if (p->position > 50.0f) {
            p->position = 0.0f;
            p->id = next_id;
            p->weight = (int16_t)(next_id * 53 % 300);
            next_id++;
        }
        p->kind = p->weight < 100 ? SMALL : p->weight < 200 ? MEDIUM : LARGE;
        stats[p->kind].count++;
        stats[p->kind].weight += p->weight;
        p->rejected = p->kind == LARGE && p->position > 25.0f;
        rejects += p->rejected;
        if (p->weight > parts[heaviest].weight) heaviest = i;
    }

    int k = (heaviest + 1) % N;
    Part spare = parts[heaviest];
    parts[heaviest] = parts[k];
    parts[k] = spare;

    int32_t result = stats[0].weight + 3 * stats[1].weight + 5 * stats[2].weight + stats[1].count
                     + rejects + spare.id + (int32_t)(spare.position * 100.0f);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)result);
}
