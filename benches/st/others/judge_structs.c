/* An order book: update records, search by number, sum by state, sort by due date. */
#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t number;
    int32_t due;
    float quantity;
    int16_t line;
    int16_t state;
    bool urgent;
} Order;

static bool first = true;
static int32_t seed = 4711;
static Order orders[64];
static int32_t per_line[8];

void scan(void)
{
    int32_t i, j, k, wanted, found, urgent_count, sum;
    float total;
    Order tmp;

    if (first) {
        first = false;
        for (i = 0; i < 64; i++) {
            seed = (seed * 2053 + 13849) % 65536;
            orders[i].number = 1000 + i;
            orders[i].due = seed;
            orders[i].quantity = (float)(seed % 100);
            orders[i].line = (int16_t)(i % 8);
        }
    }

    /* update */
    for (i = 0; i < 64; i++) {
        orders[i].quantity = orders[i].quantity - 0.5f;
        if (orders[i].quantity <= 0.0f) {
            seed = (seed * 2053 + 13849) % 65536;
            orders[i].quantity = (float)(seed % 100 + 1);
            orders[i].due = seed;
            orders[i].line = (int16_t)(seed % 8);
            orders[i].state = 0;
        } else if (orders[i].quantity < 10.0f) {
            orders[i].state = 2;
        } else {
            orders[i].state = 1;
        }
        orders[i].urgent = orders[i].due < 8000 && orders[i].state != 2;
    }

    /* search: sixteen orders by their numbers get a new date */
    sum = 0;
    for (k = 0; k < 16; k++) {
        seed = (seed * 2053 + 13849) % 65536;
        wanted = 1000 + seed / 1024;
        found = -1;
        for (i = 0; i < 64; i++) {
            if (orders[i].number == wanted) {
                found = i;
                break;
            }
        }
        if (found >= 0) {
            orders[found].due = (orders[found].due + seed) % 65536;
            sum += found;
        }
    }

    /* insertion sort by due date */
    for (i = 1; i < 64; i++) {
        tmp = orders[i];
        j = i - 1;
        while (j >= 0 && orders[j].due > tmp.due) {
            orders[j + 1] = orders[j];
            j--;
        }
        orders[j + 1] = tmp;
    }

    /* report */
    total = 0.0f;
    urgent_count = 0;
    for (i = 0; i < 8; i++)
        per_line[i] = 0;
    for (i = 0; i < 64; i++) {
        total += orders[i].quantity;
        if (orders[i].urgent)
            urgent_count++;
        per_line[orders[i].line] += orders[i].state + 1;
    }
    for (i = 0; i < 8; i++)
        sum += per_line[i] * (i + 1);
    sum += (int32_t)total + urgent_count * 5 + orders[0].number + orders[63].due;
    check = (check % 1000003) * 31 + sum;
}
