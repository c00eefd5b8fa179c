/* Sieve of Eratosthenes, upper end moves a little from scan to scan */
#include <stdbool.h>
#include "st.h"

#define MAXN 6000

static bool isPrime[MAXN + 1];
static int32_t n = 5000;

void scan(void)
{
    int32_t i, j, count, last, gap;

    n += 37;
    if (n > MAXN)
        n = 5000;

    for (i = 2; i <= n; i++)
        isPrime[i] = true;

    for (i = 2; i * i <= n; i++) {
        if (isPrime[i]) {
            for (j = i * i; j <= n; j += i)
                isPrime[j] = false;
        }
    }

    count = 0;
    last = 2;
    gap = 0;
    for (i = 2; i <= n; i++) {
        if (isPrime[i]) {
            count++;
            if (i - last > gap)
                gap = i - last;
            last = i;
        }
    }
    check = (check * 5 + count * 100 + gap + last) % 1000003;
}
