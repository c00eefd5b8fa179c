/* Primes up to 8192. */
#include <stdbool.h>
#include "st.h"

#define LAST 8192

static bool prime[LAST + 1];

void scan(void)
{
    for (int32_t i = 2; i <= LAST; i++)
        prime[i] = true;

    for (int32_t i = 2; i * i <= LAST; i++)
        if (prime[i])
            for (int32_t k = i * i; k <= LAST; k += i)
                prime[k] = false;

    int32_t count = 0;
    for (int32_t i = 2; i <= LAST; i++)
        if (prime[i]) {
            count++;
            check = (check * 31 + i) % 1000003;
        }
    check = (check * 31 + count) % 1000003;
}
