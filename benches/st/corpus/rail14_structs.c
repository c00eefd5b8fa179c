#include <math.h>
#include <stdbool.h>
#include "st.h"

enum phase { WAITING, WASHING, RINSING, DONE };

struct axle { int16_t load; float temp; };

struct vehicle {
    int32_t id;
    enum phase phase;
    float speed, pos;
    int16_t timer;
    int32_t washes;
    bool dirty;
    struct axle axle[4];
};

static struct vehicle fleet[80];
static bool init;
static int32_t tick;

static void vehicle_step(struct vehicle *v)
{
    switch (v->phase) {
    case WAITING:
        v->speed = 0.0f;
        if ((tick + v->id * 7) % 40 == 0) {
            v->phase = WASHING;
            v->timer = 0;
            v->dirty = true;
        }
        break;
    case WASHING:
        v->speed = 0.5f;
        if (++v->timer >= 25)
            v->phase = RINSING;
        break;
    case RINSING:
        v->speed = 0.75f;
        v->timer -= 2;
        if (v->timer <= 0) {
            v->phase = DONE;
            v->dirty = false;
            v->washes++;
        }
        break;
    case DONE:
        v->speed = 2.0f;
        if (v->pos > 50.0f) {
            v->pos = 0.0f;
            v->phase = WAITING;
        }
        break;
    }
    v->pos += v->speed;
    for (int k = 0; k < 4; k++) {
        struct axle *a = &v->axle[k];
        a->load = (int16_t)((a->load + k * 3 + 1) % 900);
        a->temp = a->temp * 0.95f + v->speed + (float)a->load * 0.01f;
    }
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 80; i++) {
            fleet[i].id = 1000 + i;
            for (int k = 0; k < 4; k++)
                fleet[i].axle[k].load = (int16_t)((i * 37) % 500 + k);
        }
        init = true;
    }
    tick++;
    for (int i = 0; i < 80; i++)
        vehicle_step(&fleet[i]);

    int32_t n = tick % 79;
    struct vehicle spare = fleet[n];
    fleet[n] = fleet[n + 1];
    fleet[n + 1] = spare;

    int32_t washing = 0, hottest = 0;
    float max_temp = -1.0f;
    uint32_t load = 0;
    for (int i = 0; i < 80; i++) {
        const struct vehicle *v = &fleet[i];
        if (v->dirty)
            washing++;
        for (int k = 0; k < 4; k++) {
            load += (uint32_t)v->axle[k].load;
            if (v->axle[k].temp > max_temp) {
                max_temp = v->axle[k].temp;
                hottest = v->id;
            }
        }
        load = load * 3u + (uint32_t)v->washes + (uint32_t)lrintf(v->pos * 4.0f) + (uint32_t)v->id;
    }
    check = (int32_t)((uint32_t)check * 31u + load + (uint32_t)washing * 17u + (uint32_t)hottest
                      + (uint32_t)lrintf(max_temp * 100.0f));
}
