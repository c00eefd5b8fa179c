#include <stdbool.h>
#include <string.h>
#include "st.h"

#define CAPACITY 2000

struct sieve_result { int count, largest, max_gap, twins; };

static bool composite[CAPACITY + 1];
static int bound = 1000;

static struct sieve_result prime_sieve(int limit)
{
    struct sieve_result r = {0};

    memset(composite, 0, (size_t)limit + 1);
    composite[0] = composite[1] = true;
    for (int n = 2; n * n <= limit; n++)
        if (!composite[n])
            for (int m = n * n; m <= limit; m += n)
                composite[m] = true;

    int last = 2;
    for (int n = 2; n <= limit; n++) {
        if (composite[n])
            continue;
        r.count++;
        int gap = n - last;
        if (gap > r.max_gap)
            r.max_gap = gap;
        if (gap == 2)
            r.twins++;
        last = n;
    }
    r.largest = last;
    return r;
}

static inline void add(int v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

void scan(void)
{
    struct sieve_result r = prime_sieve(bound);
    add(r.count);
    add(r.largest);
    add(r.max_gap);
    add(r.twins);
    bound += 37;
    if (bound > 2000)
        bound -= 1000;
}
