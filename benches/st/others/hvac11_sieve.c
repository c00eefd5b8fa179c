/* Sieve of Eratosthenes with a limit that moves from scan to scan */
#include <stdbool.h>
#include "st.h"

#define MAXIMUM 2500

static bool is_prime[MAXIMUM + 1];
static int limit = 2000;

void scan(void)
{
    int count = 0, largest = 0;
    int32_t prime_sum = 0;

    limit += 7;
    if (limit > MAXIMUM)
        limit -= 500;

    for (int i = 2; i <= limit; i++)
        is_prime[i] = true;

    for (int i = 2; i * i <= limit; i++)
        if (is_prime[i])
            for (int m = i * i; m <= limit; m += i)
                is_prime[m] = false;

    for (int i = 2; i <= limit; i++) {
        if (is_prime[i]) {
            count++;
            prime_sum += i;
            largest = i;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(prime_sum + count * 1000 + largest));
}
