/* Example 3: Sieve of Eratosthenes. */
#include <stdbool.h>
#include "st.h"

#define LIMIT_N 6000

static bool is_prime[LIMIT_N + 1];
static int16_t primes[1000];

void scan(void)
{
    int32_t n, m, sum;
    int16_t count, twins;

    /* 1. all numbers from 2 on are candidates */
    is_prime[0] = false;
    is_prime[1] = false;
    for (n = 2; n <= LIMIT_N; n++)
        is_prime[n] = true;

    /* 2. strike out the multiples */
    for (n = 2; n * n <= LIMIT_N; n++) {
        if (is_prime[n]) {
            for (m = n * n; m <= LIMIT_N; m += n)
                is_prime[m] = false;
        }
    }

    /* 3. collect the primes */
    count = 0;
    for (n = 2; n <= LIMIT_N; n++) {
        if (is_prime[n])
            primes[count++] = (int16_t)n;
    }

    /* 4. sum and twin primes */
    sum = primes[0];
    twins = 0;
    for (int i = 1; i < count; i++) {
        sum += primes[i];
        if (primes[i] - primes[i - 1] == 2)
            twins++;
    }

    /* count * 7 is an INT product: 783 * 7 fits */
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(count * 7) + (uint32_t)twins);
}
