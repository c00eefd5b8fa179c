/* Chapter 6: loops. Prime numbers for the scrambling of serial numbers. */
#include <stdbool.h>
#include "st.h"

#define MAX_LIMIT 6000

static bool is_prime[MAX_LIMIT + 1];
static int32_t scan_no;

void scan(void)
{
    int32_t limit, i, k, count, total;

    scan_no++;
    limit = MAX_LIMIT - (scan_no % 10) * 25;

    for (i = 2; i <= limit; i++)
        is_prime[i] = true;

    for (i = 2; i * i <= limit; i++) {
        if (is_prime[i]) {
            for (k = i * i; k <= limit; k += i)
                is_prime[k] = false;
        }
    }

    count = 0;
    total = 0;
    for (i = 2; i <= limit; i++) {
        if (is_prime[i]) {
            count++;
            total += i;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count + total));
}
