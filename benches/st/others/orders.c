#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "st.h"

#define ORDERS 40

typedef struct {
    int16_t material;
    float amount;
} Part;

typedef struct {
    int16_t id, used;
    Part parts[6];
} Recipe;

typedef struct {
    int number, due;
    int16_t priority, quantity;
    bool open;
    Recipe rec;
} Order;

static Recipe recipes[10];
static Order orders[ORDERS], archive[ORDERS];
static int scans, seed = 1, next_number;

static int find_order(const Order *list, int number)
{
    for (int i = 0; i < ORDERS; i++)
        if (list[i].number == number)
            return i;
    return -1;
}

static float weight(const Recipe *r)
{
    float sum = 0;
    for (int i = 0; i < r->used; i++)
        sum += r->parts[i].amount;
    return sum;
}

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 10; i++) {
            recipes[i].id = 100 + i;
            recipes[i].used = 2 + i % 5;
            for (int k = 0; k < 6; k++) {
                recipes[i].parts[k].material = (i * 3 + k) % 16;
                recipes[i].parts[k].amount = (float)(i + k) * 0.5f;
            }
        }
    scans++;

    for (int k = 0; k < 6; k++) {
        next_number++;
        seed = (seed * 1103 + 12345) % 65536;
        int pos = find_order(orders, next_number - 40);
        if (pos < 0)
            pos = find_order(orders, 0);
        Order *o = &orders[pos];
        o->number = next_number;
        o->priority = seed % 5;
        o->due = scans * 10 + seed % 400;
        o->quantity = 1 + seed % 9;
        o->open = true;
        o->rec = recipes[seed % 10];
    }

    memcpy(archive, orders, sizeof orders);

    for (int i = 1; i < ORDERS; i++) {
        Order current = orders[i];
        int k = i - 1;
        while (k >= 0 && (orders[k].priority > current.priority
                || (orders[k].priority == current.priority && orders[k].due > current.due))) {
            orders[k + 1] = orders[k];
            k--;
        }
        orders[k + 1] = current;
    }

    float stock[16] = {0}, total = 0;
    int pieces = 0;
    for (int i = 0; i < ORDERS; i++) {
        const Order *o = &orders[i];
        if (o->open) {
            total += weight(&o->rec) * (float)o->quantity;
            for (int k = 0; k < o->rec.used; k++)
                stock[o->rec.parts[k].material] += o->rec.parts[k].amount;
            pieces += o->quantity * i;
        }
        if (archive[i].number != o->number)
            pieces++;
    }
    orders[scans % 40].open = false;
    for (int i = 0; i < 16; i++)
        total += stock[i] * (float)i;
    check = (check * 31 + (int)total + pieces) % 1000003;
}
