#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

typedef struct { int32_t x, y; } Vec;
typedef struct {
    Vec pos, vel;
    int16_t id, hits;
    bool alive;
    int32_t hist[4];
} Particle;

static Particle p[128];
static int32_t scans;
static uint32_t seed = 2024;

static int32_t dist(Vec a, Vec b) { return abs(a.x - b.x) + abs(a.y - b.y); }

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 128; i++) {
            seed = seed * 1664525u + 1013904223u;
            p[i].pos.x = seed / 65536 % 1000;
            seed = seed * 1664525u + 1013904223u;
            p[i].pos.y = seed / 65536 % 1000;
            p[i].vel.x = (int32_t)(seed / 256 % 21) - 10;
            p[i].vel.y = (int32_t)(seed / 8192 % 21) - 10;
            p[i].id = i;
            p[i].alive = true;
        }
    scans++;
    Vec centre = { 500, scans % 1000 };
    for (int i = 0; i < 128; i++) {
        Particle *q = &p[i];
        if (q->alive) {
            q->pos.x += q->vel.x;
            q->pos.y += q->vel.y;
            if (q->pos.x < 0 || q->pos.x > 1000) {
                q->vel.x = -q->vel.x;
                q->hits++;
            }
            if (q->pos.y < 0 || q->pos.y > 1000) {
                q->vel.y = -q->vel.y;
                q->hits++;
            }
            q->hist[scans % 4] = dist(q->pos, centre);
            q->alive = q->hits < 30;
        } else {
            q->hits = 0;
            q->alive = true;
        }
    }
    for (int i = 0; i < 127; i++)
        if (p[i].hist[0] > p[i + 1].hist[0]) {
            Particle tmp = p[i];
            p[i] = p[i + 1];
            p[i + 1] = tmp;
        }
    int32_t sum = 0;
    for (int i = 0; i < 128; i++)
        sum += p[i].pos.x * 3 + p[i].pos.y + p[i].hits * p[i].id + p[i].hist[1] - p[i].hist[2] + p[i].hist[3] * (i % 3);
    check = (check + sum) % 1000000;
}
