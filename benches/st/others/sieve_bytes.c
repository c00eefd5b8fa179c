#include <stdint.h>
#include <stdbool.h>
#include "st.h"

static bool flags[8191];
static int32_t scans;

static int sieve(int limit, int32_t *total)
{
    int primes = 0;
    *total = 0;
    for (int i = 0; i <= limit; i++)
        flags[i] = true;
    for (int i = 0; i <= limit; i++) {
        if (flags[i]) {
            int prime = i + i + 3;
            for (int k = i + prime; k <= limit; k += prime)
                flags[k] = false;
            primes++;
            *total += prime;
        }
    }
    return primes;
}

void scan(void)
{
    int32_t total;
    scans++;
    int primes = sieve(4000 + scans % 100, &total);
    check = (check + primes + total) % 999983;
}
