/* Sieve of Eratosthenes over the odd numbers, flags[i] stands for 2*i+3. */
#include <stdbool.h>
#include "st.h"

#define SIZE 4096

static bool flags[SIZE];
static int32_t cyc;

void scan(void)
{
    int32_t i, k, prime, count = 0, last = 0;

    cyc++;
    for (i = 0; i < SIZE; i++)
        flags[i] = true;
    for (i = 0; i < SIZE; i++) {
        if (flags[i]) {
            prime = i + i + 3;
            for (k = i + prime; k < SIZE; k += prime)
                flags[k] = false;
            count++;
            last = prime;
        }
    }
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)(count * 10000 + last + cyc % 7));
}
