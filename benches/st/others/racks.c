#include "st.h"
#include <stdbool.h>
#include <stdint.h>

enum { ORDERS = 40, LINES = 4, ROWS = 6, COLS = 8 };
typedef struct { uint16_t article; int16_t qty; float price; } order_line;
typedef struct {
    uint32_t id;
    int prio;
    int32_t due;
    bool urgent;
    order_line lines[LINES];
    float value;
} order;
typedef struct { uint16_t article; int32_t stock; uint32_t picks; } bin;

static order orders[ORDERS], archive[10];
static bin rack[ROWS][COLS];
static int32_t scans, seed = 11;

static bool earlier(const order *a, const order *b)
{
    if (a->prio != b->prio)
        return a->prio > b->prio;
    if (a->due != b->due)
        return a->due < b->due;
    return a->id < b->id;
}

static int32_t sort(void)
{
    int32_t moves = 0;
    for (int gap = ORDERS / 2; gap > 0; gap /= 2)
        for (int i = gap; i < ORDERS; i++) {
            if (!earlier(&orders[i], &orders[i - gap]))
                continue;
            order moving = orders[i];
            int j = i;
            do {
                orders[j] = orders[j - gap];
                moves++;
                j -= gap;
            } while (j >= gap && earlier(&moving, &orders[j - gap]));
            orders[j] = moving;
        }
    return moves;
}

static bin *find_bin(uint16_t article)
{
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLS; j++)
            if (rack[i][j].article == article)
                return &rack[i][j];
    return 0;
}

static void init(void)
{
    for (int i = 1; i <= ORDERS; i++) {
        order *o = &orders[i - 1];
        o->id = 100 + i;
        for (int j = 1; j <= LINES; j++)
            o->lines[j - 1] = (order_line){ i * j % 48 + 1, (i + j) % 9 + 1, (float)(i * 3 + j) * 0.25f };
    }
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLS; j++) {
            rack[i][j].article = i * COLS + j + 1;
            rack[i][j].stock = 500;
        }
}

void scan(void)
{
    if (++scans == 1)
        init();
    for (int k = 0; k < 3; k++) {
        seed = (seed * 75 + 74) % 65537;
        order *o = &orders[seed % ORDERS];
        o->prio = seed % 7;
        o->due = scans + seed % 100;
        o->urgent = !o->urgent;
        o->lines[seed % LINES].qty = seed % 12 + 1;
    }
    int32_t moves = sort();
    float total = 0.0f;
    for (int i = 0; i < ORDERS; i++) {
        order *o = &orders[i];
        float value = 0.0f;
        for (int j = 0; j < LINES; j++)
            value += (float)o->lines[j].qty * o->lines[j].price;
        o->value = value;
        if (o->urgent)
            total += value;
    }
    int lo = 1, hi = ORDERS + 1;
    while (lo < hi) {
        int mid = (lo + hi) / 2;
        if (orders[mid - 1].prio > 3)
            lo = mid + 1;
        else
            hi = mid;
    }
    int32_t n = 0;
    for (int k = 0; k < LINES; k++) {
        const order_line *l = &orders[0].lines[k];
        bin *b = find_bin(l->article);
        if (b) {
            b->stock -= l->qty;
            b->picks++;
            if (b->stock < 0)
                b->stock += 500;
            n += b->stock + (int32_t)b->picks;
        }
    }
    archive[scans % 10] = orders[0];
    orders[0].prio = 0;
    orders[0].due += 50;
    for (int i = 0; i < 10; i++)
        n += (int32_t)archive[i].id + archive[i].lines[2].qty;
    check = (check * 3 + n + moves + lo + (int32_t)total) % 1000003;
}
