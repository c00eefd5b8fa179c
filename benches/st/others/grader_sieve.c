/* Sieve of Eratosthenes up to a limit that moves a little from scan to scan */
#include "st.h"
#include <stdbool.h>

#define MAXN 12000

static bool composite[MAXN + 1];
static int32_t round_no;

void scan(void)
{
    int32_t limit, i, j, count, last, sum;

    round_no = (round_no + 1) % 64;
    limit = MAXN - round_no * 5;

    for (i = 0; i <= limit; i++)
        composite[i] = false;
    composite[0] = true;
    composite[1] = true;

    i = 2;
    while (i * i <= limit) {
        if (!composite[i]) {
            for (j = i * i; j <= limit; j += i)
                composite[j] = true;
        }
        i++;
    }

    count = 0;
    sum = 0;
    last = 0;
    for (i = 2; i <= limit; i++) {
        if (!composite[i]) {
            count++;
            sum += i % 97;
            last = i;
        }
    }

    check = (check + count + sum + last) % 1000003;
}
