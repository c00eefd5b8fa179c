#include <stdbool.h>
#include <stdint.h>
#include "st.h"

typedef struct {
    uint16_t article;
    int16_t count;
    uint32_t stamp;
} Bin;

typedef struct {
    Bin bins[8];
    int16_t filled;
    int worth;
} Shelf;

typedef struct {
    uint16_t article;
    int16_t amount, next;
} Node;

typedef struct {
    Node nodes[33]; /* 0 ends the list */
    int head, tail, free, length;
    bool ready;
} Queue;

static Shelf hall[4][12];
static Queue waiting;
static uint32_t seed = 77, clock_now;
static int scans;

static void put(Queue *q, uint16_t article, int amount)
{
    if (!q->ready) {
        for (int i = 1; i <= 31; i++)
            q->nodes[i].next = i + 1;
        q->free = 1;
        q->ready = true;
    }
    if (q->free == 0) {
        int old = q->head;
        q->head = q->nodes[old].next;
        q->nodes[old].next = 0;
        q->free = old;
        q->length--;
    }
    int i = q->free;
    q->free = q->nodes[i].next;
    q->nodes[i] = (Node){ article, amount, 0 };
    if (q->tail == 0 || q->length == 0)
        q->head = i;
    else
        q->nodes[q->tail].next = i;
    q->tail = i;
    q->length++;
}

static bool keep(Shelf *s, uint16_t article, int change, uint32_t now)
{
    bool done = false;
    Bin *oldest = s->bins;
    for (Bin *b = s->bins; b < s->bins + 8; b++) {
        if (b->article == article) {
            int count = b->count + change;
            b->count = count < 0 ? 0 : count > 999 ? 999 : count;
            b->stamp = now;
            done = true;
            break;
        }
        if (b->stamp < oldest->stamp)
            oldest = b;
    }
    if (!done)
        *oldest = (Bin){ article, change > 1 ? change : 1, now };
    s->filled = 0;
    s->worth = 0;
    for (Bin *b = s->bins; b < s->bins + 8; b++)
        if (b->count > 0) {
            s->filled++;
            s->worth += b->count * (b->article % 50);
        }
    return done;
}

void scan(void)
{
    int bay = 0;
    scans++;
    for (int i = 1; i <= 40; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        clock_now++;
        bay = seed / 4 % 12;
        if (!keep(&hall[seed % 4][bay], seed % 30 + 1, (int)(seed % 21) - 8, clock_now))
            put(&waiting, seed % 30 + 1, i);
    }

    Shelf copy = hall[0][3];
    hall[0][3] = hall[3][bay];
    hall[3][bay] = copy;

    int ranking[48];
    Shelf *all = hall[0];
    for (int i = 0; i < 48; i++)
        ranking[i] = i;
    for (int i = 0; i < 10; i++) {
        int best = i;
        for (int j = i + 1; j < 48; j++)
            if (all[ranking[j]].worth > all[ranking[best]].worth)
                best = j;
        int swap = ranking[i];
        ranking[i] = ranking[best];
        ranking[best] = swap;
    }

    const Node *head = &waiting.nodes[waiting.head];
    int sum = head->article + head->amount + waiting.length;
    for (int i = 0; i < 10; i++)
        sum += ranking[i] * (i + 1);
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 12; b++)
            sum += hall[a][b].worth + hall[a][b].filled * b;
    check = (check * 31 + sum) % 1000003;
}
