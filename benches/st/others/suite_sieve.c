/* Sieve of Eratosthenes: counts the primes up to a limit that changes from scan to scan. */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define SIZE 8192

static bool prime[SIZE + 1];
static int offset;

void scan(void)
{
    int top, count = 0;
    int32_t sum = 0;

    offset = (offset + 37) % 512;
    top = SIZE - offset;

    memset(prime + 2, true, top - 1);
    for (int i = 2; i * i <= top; i++)
        if (prime[i])
            for (int k = i * i; k <= top; k += i)
                prime[k] = false;

    for (int i = 2; i <= top; i++)
        if (prime[i]) {
            count++;
            sum += i;
        }

    check = (check * 31 + sum + count) % 1000003;
}
