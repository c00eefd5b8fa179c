#include <stdbool.h>
#include "st.h"

#define N 64

typedef enum { IDLE, MOVING, LOADING, DONE } CarrierState;

typedef struct { float x, y; } Point;

typedef struct {
    int16_t id;
    CarrierState state;
    Point pos;
    float speed;
    int32_t load;
    int16_t ticks;
    bool active;
} Carrier;

static Carrier carriers[N];
static bool ready;
static int32_t tick;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++) {
            carriers[i].id = i + 1;
            carriers[i].state = IDLE;
            carriers[i].speed = 0.5f + (float)(i + 1) * 0.03f;
            carriers[i].ticks = (i + 1) % 9;
        }
        ready = true;
    }

    for (int i = 0; i < N; i++) {
        Carrier *c = &carriers[i];
        switch (c->state) {
        case IDLE:
            if (++c->ticks >= 10) {
                c->ticks = 0;
                c->active = true;
                c->state = MOVING;
            }
            break;
        case MOVING:
            c->pos.x += c->speed;
            c->pos.y += c->speed * 0.25f;
            if (c->pos.x > 20.0f)
                c->state = LOADING;
            break;
        case LOADING:
            c->load += c->id + tick % 5;
            if (++c->ticks >= 6)
                c->state = DONE;
            break;
        case DONE:
            c->pos.x = 0.0f;
            c->pos.y = 0.0f;
            c->ticks = 0;
            c->active = false;
            c->load %= 500;
            c->state = IDLE;
            break;
        }
    }

    for (int i = 0; i < N - 1; i++) {
        if (carriers[i].load > carriers[i + 1].load) {
            Carrier tmp = carriers[i];
            carriers[i] = carriers[i + 1];
            carriers[i + 1] = tmp;
        }
    }

    int32_t sum = 0, total = 0;
    int active = 0;
    for (int i = 0; i < N; i++) {
        const Carrier *c = &carriers[i];
        total += c->load;
        if (c->active)
            active++;
        sum += c->id * (i + 1) + (int32_t)((c->pos.x + c->pos.y) * 100.0f) + c->ticks;
    }
    tick++;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)total * 3u
                      + (uint32_t)active);
}
