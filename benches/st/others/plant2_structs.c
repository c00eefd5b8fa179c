#include <stdbool.h>
#include <string.h>
#include "st.h"

/* REAL_TO_DINT: to the nearest, halves to even (the bench links without -lm). */
static int32_t to_dint(float x)
{
    return (int32_t)((double)x + 0x1.8p52 - 0x1.8p52);
}

typedef enum { Q_NONE, Q_GOOD, Q_LIGHT, Q_HEAVY, Q_NO_LABEL } Quality;
typedef struct { int16_t length, width, height; } Dim;
typedef struct {
    int32_t id;
    int16_t recipe;
    float weight;
    Dim dim;
    bool label;
    Quality quality;
    int16_t station[4];
} Product;
typedef struct { float target, tol; Dim dim; int32_t count, reject; } Recipe;
typedef struct { int16_t code; int32_t id, scan; bool active, ack; } Alarm;

static Product belt[64];
static Recipe recipes[9]; /* 1..8 */
static Alarm alarms[32];
static int alarm_idx;
static bool init;
static int32_t nscan;
static uint32_t rnd = 4711;

static Quality judge(float weight, bool label, float target, float tol)
{
    if (!label) return Q_NO_LABEL;
    if (weight < target - tol) return Q_LIGHT;
    if (weight > target + tol) return Q_HEAVY;
    return Q_GOOD;
}

void scan(void)
{
    if (!init) {
        init = true;
        for (int i = 1; i <= 8; i++) {
            Recipe *r = &recipes[i];
            r->target = 100.0f + (float)i * 25.0f;
            r->tol = 4.0f + (float)i;
            r->dim = (Dim){ (int16_t)(200 + i * 10), (int16_t)(120 + i * 5), (int16_t)(40 + i) };
        }
    }
    nscan++;
    uint32_t sum = 0;

    if (belt[63].id != 0) {
        Recipe *r = &recipes[belt[63].recipe];
        r->count++;
        if (belt[63].quality != Q_GOOD) r->reject++;
    }
    memmove(&belt[1], &belt[0], 63 * sizeof belt[0]);

    rnd = rnd * 1664525u + 1013904223u;
    if ((rnd >> 16) % 8 == 0) {
        belt[0] = (Product){ 0 };
    } else {
        int k = (int)((rnd >> 20) % 8) + 1;
        belt[0] = (Product){
            .id = nscan,
            .recipe = (int16_t)k,
            .weight = recipes[k].target + (float)((rnd >> 8) % 256) * 0.1f - 12.8f,
            .dim = recipes[k].dim,
            .label = (rnd >> 12) % 16 != 3,
        };
    }

    for (int i = 0; i < 64; i++)
        if (belt[i].id != 0) {
            belt[i].station[i / 16] = (int16_t)(belt[i].station[i / 16] + i % 5);
            belt[i].weight *= 0.9995f;
        }

    Product *w = &belt[20];
    if (w->id != 0) {
        const Recipe *r = &recipes[w->recipe];
        w->quality = judge(w->weight, w->label, r->target, r->tol);
        if (w->quality != Q_GOOD) {
            Alarm *a = &alarms[alarm_idx];
            a->id = w->id;
            a->scan = nscan;
            a->active = true;
            a->ack = false;
            switch (w->quality) {
            case Q_LIGHT: a->code = 101; break;
            case Q_HEAVY: a->code = 102; break;
            case Q_NO_LABEL: a->code = 200; break;
            default: a->code = 999; break;
            }
            alarm_idx = (alarm_idx + 1) % 32;
        }
    }

    int open = 0;
    for (int i = 0; i < 32; i++) {
        Alarm *a = &alarms[i];
        if (!a->active) continue;
        if (nscan - a->scan > 80) a->active = false;
        else if (nscan - a->scan > 50) a->ack = true;
        if (!a->ack) {
            open++;
            sum += (uint32_t)a->code;
        }
    }

    float total = 0.0f;
    int32_t vol = 0;
    for (int i = 0; i < 64; i++) {
        const Product *p = &belt[i];
        total += p->weight;
        vol += p->dim.length * p->dim.width / 100 * p->dim.height;
        switch (p->quality) {
        case Q_GOOD: sum += 1; break;
        case Q_LIGHT:
        case Q_HEAVY: sum += 20; break;
        case Q_NO_LABEL: sum += 300; break;
        default: break;
        }
        sum += (uint32_t)(p->station[0] + p->station[3]);
    }
    for (int i = 1; i <= 8; i++)
        sum = sum * 3 + (uint32_t)(recipes[i].count - recipes[i].reject);
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)vol + (uint32_t)to_dint(total * 10.0f) + (uint32_t)open);
}
