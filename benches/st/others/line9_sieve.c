/* Prime sieve with statistics: count, sum, twins and the widest gap */
#include "st.h"
#include <stdbool.h>
#include <string.h>

#define BASE_LIMIT 1900

struct prime_stats {
    int count;
    int32_t sum;
    int twins, max_gap, largest;
};

static bool composite[2048];
static struct prime_stats stats;
static int extra;

static void sieve(bool *c, int limit)
{
    memset(c, 0, (size_t)limit + 1);
    c[0] = c[1] = true;
    for (int p = 2; p * p <= limit; p++) {
        if (!c[p]) {
            for (int m = p * p; m <= limit; m += p)
                c[m] = true;
        }
    }
}

static void prime_statistics(const bool *c, int limit, struct prime_stats *out)
{
    struct prime_stats s = { 0 };
    int last = 2;
    for (int n = 2; n <= limit; n++) {
        if (!c[n]) {
            s.count++;
            s.sum += n;
            int gap = n - last;
            if (gap == 2)
                s.twins++;
            if (gap > s.max_gap)
                s.max_gap = gap;
            last = n;
        }
    }
    s.largest = last;
    *out = s;
}

static void add_check(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    extra = (extra + 7) % 148;
    sieve(composite, BASE_LIMIT + extra);
    prime_statistics(composite, BASE_LIMIT + extra, &stats);
    add_check(stats.count);
    add_check(stats.sum);
    add_check(stats.twins);
    add_check(stats.max_gap);
    add_check(stats.largest);
}
