#include <stdint.h>
#include "st.h"

enum state { IDLE, LOADING, WORKING, DONE };
struct position { int16_t x, y, z; };
struct order {
    int32_t id;
    int16_t priority;
    float weights[4];
    struct position pos;
};
struct machine {
    enum state st;
    struct order current;
    struct order queue[5];
    int16_t ticks;
    float total;
};

static int32_t scans;
static struct machine plant[200];

static void shift(struct machine *m)
{
    m->current = m->queue[0];
    for (int k = 0; k < 4; k++)
        m->queue[k] = m->queue[k + 1];
    m->queue[4] = m->current;
    m->queue[4].id = m->current.id + 1;
}

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 200; i++)
            for (int k = 0; k < 5; k++) {
                struct order *o = &plant[i].queue[k];
                o->id = i * 100 + k;
                o->priority = (i * 7 + k * 3) % 10;
                o->weights[0] = k;
                o->weights[3] = 0.5f;
                o->pos.x = k;
            }
    scans++;
    int32_t sum = 0;
    for (int i = 0; i < 200; i++) {
        struct machine *m = &plant[i];
        switch (m->st) {
        case IDLE:
            if ((scans + i) % 3 == 0)
                m->st = LOADING;
            break;
        case LOADING:
            shift(m);
            m->ticks = m->current.priority;
            m->st = WORKING;
            break;
        case WORKING:
            m->current.pos.x++;
            m->current.pos.y = m->current.pos.x * 2;
            m->total = m->total * 0.99f + m->current.weights[0] + m->current.weights[3];
            m->ticks--;
            if (m->ticks <= 0)
                m->st = DONE;
            break;
        case DONE:
            for (int k = 0; k < 4; k++)
                if (m->queue[k].priority > m->queue[k + 1].priority) {
                    struct order tmp = m->queue[k];
                    m->queue[k] = m->queue[k + 1];
                    m->queue[k + 1] = tmp;
                }
            m->st = IDLE;
            break;
        }
        sum += m->current.id + m->current.pos.y + (int32_t)m->total;
        for (int k = 0; k < 5; k++)
            sum += m->queue[k].priority * (k + 1);
    }
    check = (check + sum) % 1000000;
}
