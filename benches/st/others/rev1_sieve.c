/* Sieve of Eratosthenes up to 6000, then twins, the widest gap and a few Goldbach pairs. */
#include <stdbool.h>
#include "st.h"

#define TOP 6000

static bool composite[TOP + 1];
static int16_t round_no;

void scan(void)
{
    int16_t i, j;

    for (i = 2; i <= TOP; i++)
        composite[i] = false;
    i = 2;
    while (i * i <= TOP) {
        if (!composite[i]) {
            j = (int16_t)(i * i);
            while (j <= TOP) {
                composite[j] = true;
                j += i;
            }
        }
        i++;
    }

    int16_t primes = 0, twins = 0, gap = 0, last = 2;
    int32_t sum = 0;
    for (i = 2; i <= TOP; i++) {
        if (!composite[i]) {
            primes++;
            sum += i;
            if (i - last == 2) twins++;
            if (i - last > gap) gap = (int16_t)(i - last);
            last = i;
        }
    }

    /* number of ways to write an even number as the sum of two primes */
    round_no = (int16_t)((round_no + 1) % 100);
    int16_t even = (int16_t)(1000 + 2 * round_no);
    int16_t pairs = 0;
    for (i = 2; i <= even / 2; i++) {
        if (!composite[i] && !composite[even - i])
            pairs++;
    }

    check = (check * 31 + sum + primes + twins * 3 + gap * 5 + pairs) % 1000003;
}
