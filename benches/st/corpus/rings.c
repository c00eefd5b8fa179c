#include "st.h"
struct ring { int32_t x, total, high; int16_t pos; int32_t ring[64]; };
static struct ring r[40];
static int32_t scans;
static void step(struct ring *a)
{
    a->ring[a->pos++] = a->x;
    if (a->pos > 63) a->pos = 0;
    int32_t total = 0, high = a->ring[0];
    for (int k = 0; k < 64; k++) total += a->ring[k];
    for (int k = 1; k < 64; k++) if (a->ring[k] > high) high = a->ring[k];
    a->total = total; a->high = high;
}
void scan(void)
{
    for (int i = 0; i < 40; i++) {
        r[i].x = (scans * 31 + i) % 1009;
        step(&r[i]);
        check += r[i].total - r[i].high;
    }
    scans++;
}
