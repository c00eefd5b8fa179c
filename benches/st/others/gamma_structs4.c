/* Tray buffer store: rack of 10 x 20 bins, queues as ring buffers of records */
#include <stdbool.h>
#include "st.h"

#define ROWS 10
#define COLS 20

typedef struct {
    int32_t id;
    int16_t article, qty;
    uint8_t flags;
    int32_t in;
} Tray;

typedef struct {
    bool used, locked;
    int16_t visits;
    Tray tray;
} Bin;

typedef struct {
    int16_t head, tail, count;
    Tray item[16];
} Queue;

typedef struct {
    int16_t trays;
    int32_t qty;
    int32_t oldest;
} ArticleStat;

static bool queue_put(Queue *q, Tray t)
{
    if (q->count >= 16)
        return false;
    q->item[q->head] = t;
    q->head++;
    if (q->head > 15)
        q->head = 0;
    q->count++;
    return true;
}

static bool queue_get(Queue *q, Tray *t)
{
    if (q->count <= 0)
        return false;
    *t = q->item[q->tail];
    q->tail++;
    if (q->tail > 15)
        q->tail = 0;
    q->count--;
    return true;
}

static bool init;
static Bin bins[ROWS][COLS];
static ArticleStat stat_[8];
static Queue in_q, out_q;
static Tray tray;
static int32_t next_, scan_no, stored, picked;

void scan(void)
{
    if (!init) {
        for (int r = 0; r < ROWS; r++)
            bins[r][6].locked = true;
        init = true;
    }
    scan_no++;

    for (int i = 1; i <= 2; i++) {
        next_++;
        tray.id = next_;
        tray.article = (int16_t)(next_ * 5 % 8);
        tray.qty = (int16_t)(next_ % 24) + 1;
        tray.flags = (uint8_t)(next_ % 4);
        tray.in = scan_no;
        if (!queue_put(&in_q, tray))
            next_--;
    }

    int16_t best = 32000, best_r = -1, best_c = 0;
    for (int16_t r = 0; r < ROWS; r++) {
        for (int16_t c = 0; c < COLS; c++) {
            const Bin *b = &bins[r][c];
            if (!b->used && !b->locked) {
                int16_t cost = (r + 1) * 3 + (c + 1) + b->visits % 16;
                if (cost < best) {
                    best = cost;
                    best_r = r;
                    best_c = c;
                }
            }
        }
    }
    if (best_r >= 0) {
        if (queue_get(&in_q, &tray)) {
            Bin *b = &bins[best_r][best_c];
            b->tray = tray;
            b->used = true;
            b->visits = (b->visits + 1) % 1000;
            stored++;
        }
    }

    for (int i = 0; i < 8; i++) {
        stat_[i].trays = 0;
        stat_[i].qty = 0;
        stat_[i].oldest = 2147483647;
    }
    for (int r = 0; r < ROWS; r++) {
        for (int c = 0; c < COLS; c++) {
            const Bin *b = &bins[r][c];
            if (b->used) {
                ArticleStat *s = &stat_[b->tray.article];
                s->trays++;
                s->qty += b->tray.qty;
                if (b->tray.in < s->oldest)
                    s->oldest = b->tray.in;
            }
        }
    }

    int16_t want = (int16_t)(scan_no / 3 % 8);
    if (stat_[want].trays > 10) {
        int32_t oldest = 2147483647;
        best_r = -1;
        for (int16_t r = 0; r < ROWS; r++) {
            for (int16_t c = 0; c < COLS; c++) {
                const Bin *b = &bins[r][c];
                if (b->used && b->tray.article == want) {
                    if (b->tray.in < oldest) {
                        oldest = b->tray.in;
                        best_r = r;
                        best_c = c;
                    }
                }
            }
        }
        if (best_r >= 0) {
            if (queue_put(&out_q, bins[best_r][best_c].tray)) {
                bins[best_r][best_c].used = false;
                picked++;
            }
        }
    }

    int32_t sum = 0;
    if (scan_no % 2 == 0) {
        while (out_q.count > 0) {
            if (queue_get(&out_q, &tray))
                sum += tray.id % 1000 + tray.qty + tray.flags;
        }
    }
    for (int i = 0; i < 8; i++)
        sum += stat_[i].trays * i + stat_[i].qty + stat_[i].oldest % 100;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)stored + (uint32_t)picked * 3u);
}
