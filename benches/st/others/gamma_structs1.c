/* Product tracking on an inspection conveyor: 300 records */
#include <stdbool.h>
#include "st.h"

#define N 300

enum ProdState { PS_EMPTY, PS_INFEED, PS_SCAN, PS_WEIGH, PS_ACCEPT, PS_REJECT, PS_DONE };

typedef struct {
    enum ProdState state;
    int32_t id;
    int32_t pos;
    int16_t length;
    int16_t weight;
    bool code_ok;
    bool metal;
    float temp;
} Product;

static Product prod[N];
static int32_t next_id;
static int16_t infeed;
static int32_t scan_no, good, bad;

void scan(void)
{
    scan_no++;
    int16_t speed = 260 + (int16_t)(scan_no % 40);

    infeed++;
    if (infeed >= 2) {
        infeed = 0;
        int16_t slot = -1;
        for (int16_t i = 0; i < N; i++) {
            if (prod[i].state == PS_EMPTY) {
                slot = i;
                break;
            }
        }
        if (slot >= 0) {
            Product *p = &prod[slot];
            next_id++;
            p->state = PS_INFEED;
            p->id = next_id;
            p->pos = 0;
            p->length = (int16_t)(next_id * 7 % 90) + 120;
            p->weight = 0;
            p->code_ok = false;
            p->metal = (next_id % 37) == 0;
            p->temp = 4.0f;
        }
    }

    int16_t on = 0;
    int32_t weight = 0;
    float max_temp = 0.0f;
    for (int16_t i = 0; i < N; i++) {
        Product *p = &prod[i];
        if (p->state == PS_EMPTY)
            continue;
        on++;
        p->pos += speed;
        p->temp = p->temp + (21.0f - p->temp) * 0.001f;
        if (p->temp > max_temp)
            max_temp = p->temp;
        switch (p->state) {
        case PS_INFEED:
            if (p->pos > 30000)
                p->state = PS_SCAN;
            break;
        case PS_SCAN:
            p->code_ok = (p->id % 11) != 3;
            if (p->pos > 60000)
                p->state = PS_WEIGH;
            break;
        case PS_WEIGH:
            p->weight = p->weight + (p->length * 4 - p->weight) / 4;
            if (p->pos > 90000) {
                if (p->code_ok && !p->metal && p->weight < 800)
                    p->state = PS_ACCEPT;
                else
                    p->state = PS_REJECT;
            }
            break;
        case PS_ACCEPT:
            if (p->pos > 150000) {
                good++;
                p->state = PS_DONE;
            }
            break;
        case PS_REJECT:
            if (p->pos > 110000) {
                bad++;
                p->state = PS_DONE;
            }
            break;
        default:
            p->state = PS_EMPTY;
            break;
        }
        weight += p->weight;
    }
    int32_t chk = weight + good * 3 + bad * 7 + on + (int32_t)(max_temp * 100.0f);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)chk);
}
