/* prime sieve to a limit that changes from scan to scan (at most 8192), with sum, largest gap and search */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX 8192

static uint32_t seed = 12345;
static bool composite[MAX + 1];

static inline uint32_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed / 65536;
}

void scan(void)
{
    int32_t limit = MAX - (int32_t)(next_random() % 512);

    memset(composite, 0, (size_t)limit + 1);
    for (int32_t i = 2; i * i <= limit; i++) {
        if (composite[i])
            continue;
        for (int32_t k = i * i; k <= limit; k += i)
            composite[k] = true;
    }

    int32_t last = 2, gap = 0, count = 0, sum = 0;
    for (int32_t i = 2; i <= limit; i++) {
        if (composite[i])
            continue;
        count++;
        sum += i;
        if (i - last > gap)
            gap = i - last;
        last = i;
    }

    /* from random places down to the next prime */
    int32_t steps = 0;
    for (int n = 0; n < 20; n++) {
        int32_t probe = 3 + (int32_t)next_random() % (limit - 2);
        do {
            probe--;
            steps++;
        } while (composite[probe]);
        sum += probe;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count * 7 + sum + gap * 1000 + steps));
}
