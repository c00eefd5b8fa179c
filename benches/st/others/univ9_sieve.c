#include "st.h"
#include <stdbool.h>
#include <string.h>

#define MAX_LIMIT 2500

static bool composite[MAX_LIMIT + 1];
static int16_t primes[400];
static int step;
static int32_t number;

static struct stats { int count, twins, max_gap; int32_t sum; } stats;

static void sieve(int limit)
{
    memset(composite, 0, (size_t)limit + 1);
    for (int i = 2; i * i <= limit; i++)
        if (!composite[i])
            for (int k = i * i; k <= limit; k += i)
                composite[k] = true;

    struct stats s = {0};
    int last = 2;
    for (int i = 2; i <= limit; i++) {
        if (composite[i])
            continue;
        primes[s.count++] = (int16_t)i;
        s.sum += i;
        int gap = i - last;
        if (gap == 2)
            s.twins++;
        if (gap > s.max_gap)
            s.max_gap = gap;
        last = i;
    }
    stats = s;
}

static void add_check(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    sieve(2000 + step);
    step = (step + 7) % 500;

    add_check((uint32_t)stats.count);
    add_check((uint32_t)stats.twins);
    add_check((uint32_t)stats.max_gap);
    add_check((uint32_t)stats.sum);

    if (++number > 1000000)
        number = 1;
    int32_t rest = number, p = 2;
    uint32_t factors = 0;
    int index = 0;
    while (p * p <= rest && index < stats.count) {
        p = primes[index];
        if (rest % p == 0) {
            rest /= p;
            factors = factors * 7 + (uint32_t)p;
        } else {
            index++;
        }
    }
    add_check(factors * 3 + (uint32_t)rest);
}
