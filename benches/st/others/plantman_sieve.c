/* lot numbers: prime sieve */
#include <stdbool.h>
#include "st.h"

#define LAST 8000

static bool Struck[LAST + 1];
static int32_t Count, LastPrime, Sum;

void scan(void)
{
    int32_t i, k;

    for (i = 0; i <= LAST; i++)
        Struck[i] = false;
    Count = 0;
    Sum = 0;
    Struck[0] = true;
    Struck[1] = true;
    i = 2;
    while (i * i <= LAST) {
        if (!Struck[i]) {
            k = i * i;
            while (k <= LAST) {
                Struck[k] = true;
                k = k + i;
            }
        }
        i = i + 1;
    }
    for (i = 2; i <= LAST; i++) {
        if (!Struck[i]) {
            Count = Count + 1;
            LastPrime = i;
            Sum = Sum + i % 10;
        }
    }
    check = (check + Count * 7 + LastPrime + Sum) % 1000000;
}
