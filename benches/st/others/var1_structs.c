#include <stdbool.h>
#include "st.h"
typedef struct { int32_t id; int16_t product, amount; int32_t due; int16_t prio; bool used; } order_t;
typedef struct { int16_t count; order_t front; int32_t dropped; order_t buf[32]; int16_t head, tail; } queue_t;
static void order_queue(queue_t *q, bool push, bool pop, const order_t *item)
{
    if (pop && q->count > 0) {
        q->front = q->buf[q->head];
        q->head = (int16_t)((q->head + 1) % 32);
        q->count--;
    }
    if (push) {
        if (q->count < 32) {
            q->buf[q->tail] = *item;
            q->tail = (int16_t)((q->tail + 1) % 32);
            q->count++;
        } else {
            q->dropped++;
        }
    }
}
static queue_t q;
static order_t desk[48], history[64];
static int16_t hist_pos;
static int32_t t, next_id;
static uint32_t seed = 99;
void scan(void)
{
    for (int16_t n = 0; n < 16; n++) {
        order_t o;
        t++;
        seed = (seed * 1103515245u + 12345u) % 2147483648u;
        next_id = (next_id + 1) % 1000000;
        o.id = next_id;
        o.product = (int16_t)((seed / 1024) % 20);
        o.amount = (int16_t)((seed / 32768) % 50 + 1);
        o.due = t + (int32_t)((seed / 65536) % 100);
        o.prio = (int16_t)((seed / 4096) % 5);
        o.used = true;
        order_queue(&q, true, n % 2 == 0 || q.count > 20, &o);

        int16_t free = -1;
        for (int16_t i = 0; i < 48; i++) {
            if (!desk[i].used) {
                free = i;
                break;
            }
        }
        if (free >= 0 && q.front.used)
            desk[free] = q.front;

        int16_t best = -1;
        for (int16_t i = 0; i < 48; i++) {
            if (desk[i].used) {
                if (best < 0)
                    best = i;
                else if (desk[i].prio > desk[best].prio
                         || (desk[i].prio == desk[best].prio && desk[i].due < desk[best].due))
                    best = i;
            }
        }
        if (best >= 0) {
            desk[best].amount -= 15;
            if (desk[best].amount <= 0) {
                history[hist_pos] = desk[best];
                hist_pos = (int16_t)((hist_pos + 1) % 64);
                desk[best].used = false;
            }
        }
    }
    int32_t sum = 0;
    for (int16_t i = 0; i < 64; i++)
        sum += history[i].id % 1000 + history[i].product * history[i].prio - history[i].amount;
    if (t > 1000000)
        t = 0;
    check = (check % 100003) * 3 + sum + q.count;
}
