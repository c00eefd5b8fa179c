/* Product tracking on eight lanes: arrays of structures, shifted as the products leave */
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define LANES 8
#define PRODUCTS 16

typedef enum { INFEED, WEIGHED, SEALED, CHECKED } prod_state_t;

typedef struct {
    int32_t id;
    float pos, weight;
    int16_t length;
    prod_state_t state;
    bool reject, sealed;
} product_t;

typedef struct {
    int32_t good, reject;
    float average;
    int16_t in_state[4];
} lane_stat_t;

typedef struct {
    product_t product[PRODUCTS];
    int count;
    float speed;
    lane_stat_t stat;
} lane_t;

static lane_t lanes[LANES];
static bool initialised;
static int scan_no;
static int32_t next_id;

static void product_update(product_t *p, lane_stat_t *s, float speed)
{
    p->pos += speed;
    s->in_state[p->state]++;
    switch (p->state) {
    case INFEED:
        if (p->pos > 200.0f) {
            p->reject = p->weight < 480.0f || p->weight > 520.0f;
            s->average = s->average * 0.95f + p->weight * 0.05f;
            p->state = WEIGHED;
        }
        break;
    case WEIGHED:
        if (p->pos > 500.0f) {
            p->sealed = !p->reject;
            p->state = SEALED;
        }
        break;
    case SEALED:
        if (p->pos > 800.0f) {
            if (p->length > 145)
                p->reject = true;
            p->state = CHECKED;
        }
        break;
    case CHECKED:
        break;
    }
}

static void lane_update(lane_t *l, const product_t *new_product)
{
    memset(l->stat.in_state, 0, sizeof l->stat.in_state);
    for (int i = 0; i < l->count; i++)
        product_update(&l->product[i], &l->stat, l->speed);

    if (l->count > 0 && l->product[0].pos > 1000.0f) {
        if (l->product[0].reject || !l->product[0].sealed)
            l->stat.reject++;
        else
            l->stat.good++;
        l->count--;
        memmove(&l->product[0], &l->product[1], (size_t)l->count * sizeof l->product[0]);
    }

    if (new_product && l->count < PRODUCTS)
        l->product[l->count++] = *new_product;
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 1; i <= LANES; i++) {
            lanes[i - 1].speed = 9.0f + (float)i * 0.25f;
            lanes[i - 1].stat.average = 500.0f;
        }
    }
    scan_no = (scan_no + 1) % 5040;

    uint32_t sum = 0;
    for (int i = 1; i <= LANES; i++) {
        lane_t *l = &lanes[i - 1];
        if (scan_no % (6 + i % 4) == 0) {
            next_id = (next_id + 1) % 1000000;
            product_t p = {
                .id = next_id,
                .pos = (float)i,
                .weight = 475.0f + (float)((next_id * 7) % 50),
                .length = (int16_t)(130 + (next_id * 5) % 18),
                .state = INFEED,
            };
            lane_update(l, &p);
        } else {
            lane_update(l, NULL);
        }

        float pos_sum = 0.0f;
        int rejects = 0;
        for (int j = 0; j < l->count; j++) {
            pos_sum += l->product[j].pos;
            sum += (uint32_t)l->product[j].id;
            rejects += l->product[j].reject;
        }
        sum = sum * 31u + (uint32_t)lrintf(pos_sum + l->stat.average * 10.0f);
        sum += (uint32_t)(l->stat.good * 3 + l->stat.reject * 5 + rejects);
        for (int j = 0; j < 4; j++)
            sum = sum * 7u + (uint32_t)l->stat.in_state[j];
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
