/* The classical sieve with 8191 flags (odd numbers from 3). */
#include "st.h"
#include <stdbool.h>

#define SIZE 8190

static bool flags[SIZE + 1];

void scan(void)
{
    int32_t count = 0;
    int32_t prime = 0;

    for (int32_t i = 0; i <= SIZE; i++)
        flags[i] = true;
    for (int32_t i = 0; i <= SIZE; i++) {
        if (flags[i]) {
            prime = i + i + 3;
            for (int32_t k = i + prime; k <= SIZE; k += prime)
                flags[k] = false;
            count++;
        }
    }
    check = (check + count + prime) % 1000000;
}
