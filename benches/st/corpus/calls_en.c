#include "st.h"
struct counter { int32_t step, limit, count, rounds; uint8_t done; };
static struct counter cs[200];
static int32_t scans;
static void counter(struct counter *c)
{
    c->count += c->step;
    c->done = c->count >= c->limit;
    if (c->done) { c->count = 0; c->rounds++; }
}
static int32_t divide(int32_t a, int32_t b, int *eno)
{
    *eno = b != 0;
    return b == 0 ? 0 : a / b;
}
void scan(void)
{
    for (int i = 0; i < 200; i++) {
        if ((i + scans) % 4 != 0) { cs[i].step = i % 9 + 1; cs[i].limit = 100; counter(&cs[i]); }
        int ok;
        int32_t r = divide(cs[i].count * 100, scans % 8, &ok);
        if (ok) check += r;
        if (cs[i].done) check++;
    }
    scans++;
}
