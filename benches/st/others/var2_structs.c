#include <stdbool.h>
#include "st.h"
typedef struct { int32_t code; int16_t bin; float weight, length; int16_t qty; uint16_t flags; } part_t;
static bool less(const part_t *a, const part_t *b)
{
    if (a->bin != b->bin)
        return a->bin < b->bin;
    return a->code < b->code;
}
static int32_t shell_sort(part_t *list, int16_t n)
{
    int32_t moves = 0;
    for (int16_t gap = n / 2; gap > 0; gap /= 2) {
        for (int16_t i = gap; i < n; i++) {
            part_t tmp = list[i];
            int16_t j = i;
            while (j >= gap && less(&tmp, &list[j - gap])) {
                list[j] = list[j - gap];
                j = (int16_t)(j - gap);
                moves++;
            }
            list[j] = tmp;
        }
    }
    return moves;
}
/* 1-based, 0 = not there */
static int16_t find_part(const part_t *list, int16_t bin, int32_t code)
{
    int16_t lo = 1, hi = 64;
    while (lo <= hi) {
        int16_t mid = (int16_t)((lo + hi) / 2);
        const part_t *p = &list[mid - 1];
        if (p->bin == bin && p->code == code)
            return mid;
        if (p->bin < bin || (p->bin == bin && p->code < code))
            lo = (int16_t)(mid + 1);
        else
            hi = (int16_t)(mid - 1);
    }
    return 0;
}
static part_t parts[64];
static bool ready;
static uint32_t seed = 31;
void scan(void)
{
    if (!ready) {
        for (int i = 1; i <= 64; i++) {
            part_t *p = &parts[i - 1];
            p->code = 1000 + (i * 37) % 64;
            p->bin = (int16_t)((i * 11) % 8);
            p->weight = (float)i * 0.5f;
            p->length = 100.0f - (float)i;
            p->qty = (int16_t)(i % 10);
        }
        ready = true;
    }
    for (int16_t k = 1; k <= 8; k++) {
        seed = seed * 1664525u + 1013904223u;
        part_t *p = &parts[(seed / 65536u) % 64u];
        p->bin = (int16_t)((seed / 4194304u) % 8u);
        p->qty = (int16_t)((p->qty + k) % 100);
        p->flags ^= (uint16_t)(1u << k);
    }
    int32_t moves = shell_sort(parts, 64);
    int32_t s = 0;
    for (int16_t k = 0; k < 16; k++) {
        int16_t i = find_part(parts, (int16_t)(k % 8), 1000 + k * 4);
        if (i > 0)
            s += parts[i - 1].qty * 3 + (int16_t)parts[i - 1].flags;
        s += i;
    }
    float weight = 0.0f;
    for (int i = 0; i < 64; i++)
        weight = weight + parts[i].weight * (float)parts[i].qty + parts[i].length * 0.125f;
    check = (check % 100003) * 3 + s + moves + (int32_t)weight;
}
