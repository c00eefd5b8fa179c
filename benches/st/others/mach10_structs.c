#include <stdbool.h>
#include <string.h>
#include "st.h"

#define TABLE 32
#define RING 16

typedef enum { FREE, WAITING, RUNNING, FINISHED } OrderState;

typedef struct {
    int32_t id;
    int16_t priority, width;
    int32_t sheets, printed;
    float speed;
    OrderState state;
} Order;

typedef struct {
    int32_t count, sheets;
    int16_t maxWidth;
    float speedSum;
} Statistic;

typedef struct { Order ring[RING]; int rd, wr, count; } Queue;

static Order table[TABLE], sorted[TABLE];
static Statistic stat[4];
static Queue queue;
static uint32_t seed = 99;
static int32_t nextId = 1000;

static void queue_push(Queue *q, const Order *o)
{
    if (q->count >= RING) return;
    q->ring[q->wr] = *o;
    q->wr = (q->wr + 1) % RING;
    q->count++;
}

static bool queue_pop(Queue *q, Order *o)
{
    if (q->count == 0) return false;
    *o = q->ring[q->rd];
    q->rd = (q->rd + 1) % RING;
    q->count--;
    return true;
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    int32_t rnd = (int32_t)(seed >> 8);

    Order fresh = {
        .id = ++nextId,
        .priority = (int16_t)(rnd % 100),
        .width = (int16_t)(rnd % 700 + 300),
        .sheets = rnd % 500 + 100,
        .printed = 0,
        .speed = 8.0f + (float)(rnd % 64) * 0.25f,
        .state = WAITING,
    };

    int slot = -1;
    for (int i = 0; i < TABLE; i++)
        if (table[i].state == FREE) {
            slot = i;
            break;
        }
    if (rnd % 3 != 0) queue_push(&queue, &fresh);
    if (slot >= 0) queue_pop(&queue, &table[slot]);

    for (int i = 0; i < TABLE; i++) {
        Order *o = &table[i];
        switch (o->state) {
        case WAITING:
            if (o->priority > 20 || queue.count > 8) o->state = RUNNING;
            else o->priority++;
            break;
        case RUNNING:
            o->printed += (int32_t)o->speed;
            if (o->printed >= o->sheets) o->state = FINISHED;
            break;
        case FINISHED:
            o->state = FREE;
            break;
        default:
            break;
        }
    }

    memcpy(sorted, table, sizeof sorted);
    for (int i = 1; i < TABLE; i++) {
        Order tmp = sorted[i];
        int j = i - 1;
        while (j >= 0 && sorted[j].priority < tmp.priority) {
            sorted[j + 1] = sorted[j];
            j--;
        }
        sorted[j + 1] = tmp;
    }

    memset(stat, 0, sizeof stat);
    for (int i = 0; i < TABLE; i++) {
        const Order *o = &table[i];
        Statistic *s = &stat[o->state];
        s->count++;
        s->sheets += o->sheets - o->printed;
        if (o->width > s->maxWidth) s->maxWidth = o->width;
        s->speedSum += o->speed;
    }

    int32_t wanted = nextId - rnd % 40;
    int found = -1;
    for (int i = 0; i < TABLE; i++)
        if (sorted[i].id == wanted) {
            found = i;
            break;
        }

    for (int i = 0; i < 4; i++) {
        add(stat[i].count + stat[i].sheets + stat[i].maxWidth);
        add((int32_t)(stat[i].speedSum * 4.0f));
    }
    add(sorted[0].id + sorted[TABLE - 1].id + found);
    add(queue.count);
}
