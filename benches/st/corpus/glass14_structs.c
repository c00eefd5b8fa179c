/* Tracking of panes through the lehr to the stackers */
#include "st.h"
#include <stdbool.h>
#include <string.h>

#define PANES 64

typedef enum { PRIME, SECOND, CULLET } grade_t;
typedef struct { int16_t x, y; } point_t;
typedef struct {
    int32_t id;
    point_t pos;
    float thickness;
    int16_t defects[4];
    grade_t quality;
    bool active;
} pane_t;
typedef struct { int32_t count; float weight; int32_t last_id; } stacker_t;

static pane_t panes[PANES];
static stacker_t stack[3];
static int32_t next_id;
static uint32_t seed = 12345;

void scan(void)
{
    uint32_t sum = 0;
    for (int i = 0; i < PANES; i++) {
        pane_t *p = &panes[i];
        if (!p->active) {
            seed = seed * 1664525u + 1013904223u;
            p->id = ++next_id;
            p->pos.x = 0;
            p->pos.y = (int16_t)(seed / 65536u % 300u);
            p->thickness = 4.0f + (float)(p->pos.y % 9) * 0.5f;
            memset(p->defects, 0, sizeof p->defects);
            p->active = true;
        } else {
            p->pos.x += 10 + p->pos.y % 7;
            int k = (p->pos.x + p->pos.y) % 16;
            if (k < 4)
                p->defects[k]++;
        }

        int bad = 0;
        for (int k = 0; k < 4; k++)
            bad += p->defects[k] * (k + 1);
        p->quality = bad < 12 ? PRIME : bad < 30 ? SECOND : CULLET;

        if (p->pos.x > 900) {
            stacker_t *s = &stack[p->quality];
            s->count++;
            s->weight = s->weight * 0.9f + p->thickness * 2.5f;
            s->last_id = p->id;
            p->active = false;
        }
        sum += (uint32_t)(p->pos.x + bad);
    }

    for (int i = 0; i < PANES - 1; i++) {
        if (panes[i].pos.x < panes[i + 1].pos.x) {
            pane_t tmp = panes[i];
            panes[i] = panes[i + 1];
            panes[i + 1] = tmp;
        }
        sum = sum * 3u + (uint32_t)panes[i].id;
    }

    for (int q = 0; q < 3; q++)
        sum = sum * 5u + (uint32_t)stack[q].count + (uint32_t)stack[q].last_id
              + (uint32_t)(int32_t)(stack[q].weight * 10.0f);
    check = (int32_t)((uint32_t)check * 31u + sum);
}
