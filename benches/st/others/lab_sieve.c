/* Sieve of Eratosthenes up to 8190 */
#include <stdbool.h>
#include "st.h"

#define SIZE 8190

static bool is_prime[SIZE + 1];

void scan(void)
{
    int16_t i, k, count, last = 0;

    for (i = 2; i <= SIZE; i++)
        is_prime[i] = true;

    i = 2;
    while (i * i <= SIZE) {
        if (is_prime[i]) {
            for (k = i * i; k <= SIZE; k += i)
                is_prime[k] = false;
        }
        i++;
    }

    count = 0;
    for (i = 2; i <= SIZE; i++) {
        if (is_prime[i]) {
            count++;
            last = i;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count * 3 + last));
}
