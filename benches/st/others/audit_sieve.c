/* The classic sieve: odd numbers from 3 to 16383 */
#include <stdbool.h>
#include "st.h"

#define SIZE 8190

static bool flags[SIZE + 1];

void scan(void)
{
    int32_t i, k, prime, count = 0;

    for (i = 0; i <= SIZE; i++)
        flags[i] = true;
    for (i = 0; i <= SIZE; i++) {
        if (flags[i]) {
            prime = i + i + 3;
            k = i + prime;
            while (k <= SIZE) {
                flags[k] = false;
                k += prime;
            }
            count++;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)count);
}
