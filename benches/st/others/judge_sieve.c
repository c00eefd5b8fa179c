/* Sieve of Eratosthenes up to 8191. */
#include "st.h"
#include <stdbool.h>

#define LIMIT_N 8191

static bool composite[LIMIT_N + 1];

void scan(void)
{
    int32_t i, k, count, last;

    for (i = 0; i <= LIMIT_N; i++)
        composite[i] = false;

    for (i = 2; i * i <= LIMIT_N; i++) {
        if (!composite[i]) {
            for (k = i * i; k <= LIMIT_N; k += i)
                composite[k] = true;
        }
    }

    count = 0;
    last = 0;
    for (i = 2; i <= LIMIT_N; i++) {
        if (!composite[i]) {
            count++;
            last = i;
        }
    }
    check = (check % 1000003) * 31 + count + last;
}
