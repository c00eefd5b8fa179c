/* The classic sieve: odd numbers 3 .. 16383 */
#include <stdbool.h>
#include "st.h"

#define SIZE 8190
static bool flags[SIZE + 1];

void scan(void)
{
    int32_t i, k, prime = 0, count = 0;
    for (i = 0; i <= SIZE; i++)
        flags[i] = true;
    for (i = 0; i <= SIZE; i++) {
        if (flags[i]) {
            prime = i + i + 3;
            for (k = i + prime; k <= SIZE; k += prime)
                flags[k] = false;
            count++;
        }
    }
    check = check * 31 + count + prime;
}
