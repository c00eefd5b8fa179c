/* Arrays of structures: parts that move, are measured, classified, sorted */
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define PARTS 64
#define DT 0.01f

typedef struct { float x, y, z; } Vec3;
typedef enum { SMALL, MEDIUM, LARGE } PartClass;
typedef struct {
    int32_t id;
    Vec3 pos, vel;
    int16_t weight;
    bool good;
    PartClass kind;
    int16_t meas[4];
} Part;
typedef struct { int16_t count; int32_t weight; float reach; int32_t last; } Stat;

static Part parts[PARTS];
static Stat stats[3];
static bool init_done;
static uint32_t seed = 31;
static int32_t scan_no;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < PARTS; i++) {
            parts[i].id = 1000 + i;
            parts[i].vel.x = (float)(i % 7) - 3.0f;
            parts[i].vel.y = (float)(i % 5) * 0.5f;
            parts[i].vel.z = 0.25f;
            parts[i].weight = i * 37 % 64;
        }
        init_done = true;
    }

    int slot = ++scan_no % 4;

    for (int i = 0; i < PARTS; i++) {
        Part *p = &parts[i];
        seed = seed * 1664525u + 1013904223u;
        p->pos.x += p->vel.x * DT;
        p->pos.y += p->vel.y * DT;
        p->pos.z += p->vel.z * DT;
        if (fabsf(p->pos.x) > 1.0f)
            p->vel.x = -p->vel.x;
        if (p->pos.y > 2.0f || p->pos.y < 0.0f)
            p->vel.y = -p->vel.y;
        if (p->pos.z > 0.5f)
            p->pos.z = 0.0f;
        p->meas[slot] = seed / 65536 % 100;
        int total = 0;
        for (int k = 0; k < 4; k++)
            total += p->meas[k];
        p->good = total > 120;
        p->kind = total < 150 ? SMALL : total < 220 ? MEDIUM : LARGE;
    }

    parts[seed / 256 % 64].weight = seed / 65536 % 500;
    for (int i = 0; i < PARTS - 1; i++)
        if (parts[i].weight > parts[i + 1].weight) {
            Part spare = parts[i];
            parts[i] = parts[i + 1];
            parts[i + 1] = spare;
        }

    memset(stats, 0, sizeof stats);
    const Part *heavy = &parts[0];
    for (int i = 0; i < PARTS; i++) {
        const Part *p = &parts[i];
        Stat *st = &stats[p->kind];
        if (p->good) {
            st->count++;
            st->weight += p->weight;
            st->last = p->id;
        }
        float reach = p->pos.x + p->pos.y;
        if (reach > st->reach)
            st->reach = reach;
        if (p->weight > heavy->weight)
            heavy = p;
    }

    uint32_t hash = heavy->id;
    for (int k = 0; k < 3; k++) {
        hash = hash * 31 + stats[k].count;
        hash = hash * 31 + stats[k].weight;
        hash = hash * 31 + stats[k].last;
        hash = hash * 31 + (int32_t)(stats[k].reach * 1000.0f);
    }
    for (int i = 0; i < PARTS; i++)
        hash = hash * 31 + parts[i].id + (int32_t)(parts[i].pos.z * 1000.0f);
    check = (int32_t)hash;
}
