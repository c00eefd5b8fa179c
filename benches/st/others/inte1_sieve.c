/* Sieve of Eratosthenes */
#include <stdbool.h>
#include "st.h"

#define LIMIT_N 6000

static bool composite[LIMIT_N + 1];

void scan(void)
{
    int32_t i, j, count, sum, last;

    for (i = 0; i <= LIMIT_N; i++)
        composite[i] = false;

    for (i = 2; i * i <= LIMIT_N; i++) {
        if (!composite[i]) {
            for (j = i * i; j <= LIMIT_N; j += i)
                composite[j] = true;
        }
    }

    count = 0;
    sum = 0;
    last = 0;
    for (i = 2; i <= LIMIT_N; i++) {
        if (!composite[i]) {
            count++;
            sum += i;
            last = i;
        }
    }

    check = (check + count + sum + last) % 1000003;
}
