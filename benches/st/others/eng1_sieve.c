/* Sieve of Eratosthenes up to 8191, count of primes and prime twins */
#include <stdbool.h>
#include "st.h"

#define MAX_N 8191

static bool composite[MAX_N + 1];

void scan(void)
{
    int32_t i, j;
    int16_t primes = 0, twins = 0;
    int32_t last = 0, sum = 0;

    for (i = 0; i <= MAX_N; i++)
        composite[i] = false;

    for (i = 2; i * i <= MAX_N; i++) {
        if (!composite[i]) {
            for (j = i * i; j <= MAX_N; j += i)
                composite[j] = true;
        }
    }

    for (i = 2; i <= MAX_N; i++) {
        if (!composite[i]) {
            primes++;
            if (i - last == 2)
                twins++;
            last = i;
            sum += i;
        }
    }
    check = (int32_t)((uint32_t)check * 7u + sum + primes + twins + last);
}
