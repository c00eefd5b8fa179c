#include "st.h"
#include <stdbool.h>
static int round_even(float x) { x += 12582912.0f; x -= 12582912.0f; return (int)x; }
struct item { short id; bool on; float value; int count; };
static struct item items[200];
static int scans;
void scan(void) {
    scans++;
    if (scans == 1)
        for (int i = 0; i < 200; i++) { items[i].id = i; items[i].value = i * 7 % 50; }
    for (int i = 0; i < 200; i++) {
        struct item *p = &items[i];
        p->on = (scans + p->id) % 3 == 0;
        if (p->on) { p->value = p->value * 0.9f + 5.0f; p->count++; }
        else p->value -= 0.5f;
    }
    for (int i = 0; i < 199; i++)
        if (items[i].value > items[i + 1].value) {
            struct item t = items[i];
            items[i] = items[i + 1];
            items[i + 1] = t;
        }
    int best = 0, n = 0;
    float sum = 0;
    for (int i = 0; i < 200; i++) {
        if (items[i].value > items[best].value) best = i;
        sum += items[i].value;
        n += items[i].count;
    }
    check = (check + round_even(sum) + items[best].id + items[0].id * 3 + n % 1000) % 1000000;
}
