#include "st.h"
struct item { uint8_t used; int16_t kind; int32_t weight; float price; };
static struct item items[100];
static int32_t scans;
static int16_t find_free(struct item *items, int16_t kind)
{
    for (int i = 0; i < 100; i++) {
        if (!items[i].used) return i;
        if (items[i].kind == kind && items[i].weight < 10) break;
    }
    return kind;
}
void scan(void)
{
    int at = find_free(items, scans % 7);
    items[at] = (struct item){ 1, scans % 5, scans % 1000, (float)(scans % 100) * 0.5f };
    int32_t total = 0; int16_t n = 0, best = -1;
    for (int i = 0; i < 100; i++) {
        if (!items[i].used) continue;
        if (items[i].kind == 3) {
            if (items[i].weight > 500) total += items[i].weight;
            else if (items[i].price > 20.0f) n++;
            else n += 2;
        } else if (items[i].kind == 4 && best < 0) best = i;
    }
    for (int i = 0; i < 100; i++)
        if (items[i].used && items[i].weight % 97 == 0 && scans % 3 == 0) { items[i].used = 0; break; }
    check += total + n + best;
    scans++;
}
