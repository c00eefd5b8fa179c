/* Sieve of Eratosthenes to about 8192; the limit changes from scan to scan. */
#include <stdbool.h>
#include "st.h"

static int32_t scan_no;
static bool prime[8193];

void scan(void)
{
    int32_t limit = 7937 + scan_no % 256;
    scan_no++;

    for (int32_t i = 2; i <= limit; i++)
        prime[i] = true;

    for (int32_t i = 2; i * i <= limit; i++)
        if (prime[i])
            for (int32_t j = i * i; j <= limit; j += i)
                prime[j] = false;

    int32_t count = 0, sum = 0;
    for (int32_t i = 2; i <= limit; i++)
        if (prime[i]) {
            count++;
            sum += i;
        }

    check = (check * 31 + sum + count) % 1000003;
}
