/* The same work as sieve.st. */
#include "st.h"

static uint8_t prime[8192];

void scan(void)
{
    for (int32_t i = 0; i <= 8191; i++)
        prime[i] = 1;
    prime[0] = prime[1] = 0;
    for (int32_t i = 2; i * i <= 8191; i++)
        if (prime[i])
            for (int32_t k = i * i; k <= 8191; k += i)
                prime[k] = 0;
    int32_t count = 0;
    for (int32_t i = 0; i <= 8191; i++)
        count += prime[i];
    check += count;
}
