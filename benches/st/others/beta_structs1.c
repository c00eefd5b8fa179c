#include "st.h"
#include <stdbool.h>

enum { N = 400 };
typedef enum { IDLE, MOVING, AT_STATION, MEASURED, REJECTED, FINISHED } PartState;
typedef struct { float length, width; bool valid; } Dimension;
typedef struct {
    int32_t id;
    PartState state;
    float position;
    float speed;
    int16_t dwell;
    int16_t station;
    Dimension dim;
} Part;

static Part parts[N];
static int32_t next_id, good, bad;
static uint32_t seed = 99;

void scan(void)
{
    int16_t released = 0;
    float pos_sum = 0.0f;
    for (int i = 0; i < N; i++) {
        Part *p = &parts[i];
        switch (p->state) {
        case IDLE:
            if (released < 6) {
                released++;
                next_id++;
                seed = seed * 1664525u + 1013904223u;
                p->id = next_id;
                p->position = 0.0f;
                p->speed = 4.0f + (float)(next_id % 7) * 0.5f;
                p->station = 1;
                p->dim.valid = false;
                p->dim.length = 90.0f + (float)((seed / 65536u) % 200u) * 0.1f;
                p->dim.width = 50.0f;
                p->state = MOVING;
            }
            break;
        case MOVING:
            p->position += p->speed;
            if (p->position >= (float)p->station * 100.0f) {
                p->dwell = 5 + p->station;
                p->state = AT_STATION;
            }
            break;
        case AT_STATION:
            p->dwell--;
            if (p->dwell <= 0) {
                if (p->station == 2) {
                    p->state = MEASURED;
                } else if (p->station == 4) {
                    p->state = FINISHED;
                } else {
                    p->station++;
                    p->state = MOVING;
                }
            }
            break;
        case MEASURED:
            p->dim.valid = true;
            p->dim.width += p->dim.length * 0.01f;
            if (p->dim.length > 107.0f || p->dim.length < 91.5f) {
                p->state = REJECTED;
            } else {
                p->station = 3;
                p->state = MOVING;
            }
            break;
        case REJECTED:
            bad++;
            p->state = IDLE;
            break;
        case FINISHED:
            if (p->dim.valid)
                good++;
            p->state = IDLE;
            break;
        }
        pos_sum += p->position;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)pos_sum + (uint32_t)good * 3u + (uint32_t)bad);
}
