#include "st.h"
static uint8_t flags[2001];
static int32_t scans;
static int count_primes(int limit, uint8_t *comp)
{
    int n = 0;
    for (int i = 2; i <= limit; i++)
        comp[i] = 0;
    int i = 2;
    do {
        if (!comp[i]) {
            n++;
            for (int j = i + i; j <= limit; j += i)
                comp[j] = 1;
        }
        i++;
    } while (i <= limit);
    return n;
}
void scan(void)
{
    check += count_primes(1900 + scans % 100, flags);
    scans++;
}
