/* Sieve of Eratosthenes up to a limit that moves from scan to scan. */
#include <stdbool.h>
#include "st.h"

#define MAX_N 2000

static bool is_prime[MAX_N + 1];
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    int32_t n = MAX_N - (scan_no * 37) % 500;
    if (scan_no >= 100000)
        scan_no = 0;

    for (int32_t i = 0; i <= n; i++)
        is_prime[i] = true;
    is_prime[0] = false;
    is_prime[1] = false;

    for (int32_t i = 2; i * i <= n; i++) {
        if (is_prime[i]) {
            for (int32_t j = i * i; j <= n; j += i)
                is_prime[j] = false;
        }
    }

    uint32_t count = 0, sum = 0;
    for (int32_t i = 2; i <= n; i++) {
        if (is_prime[i]) {
            count++;
            sum += (uint32_t)i * count;
        }
    }

    check = (int32_t)(sum * 31u + count);
}
