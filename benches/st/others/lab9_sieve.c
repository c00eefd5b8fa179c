/* BYTE sieve (Gilbreath): flags for odd numbers only, 2 * i + 3. */
#include <stdbool.h>
#include "st.h"

#define SIZE 4095

static bool flags[SIZE + 1];
static int32_t run;

void scan(void)
{
    int32_t i, k, prime, count = 0, last = 0, top;

    run = run + 1;
    top = SIZE - run % 16;
    for (i = 0; i <= top; i++)
        flags[i] = true;
    for (i = 0; i <= top; i++) {
        if (flags[i]) {
            prime = i + i + 3;
            k = i + prime;
            while (k <= top) {
                flags[k] = false;
                k = k + prime;
            }
            count = count + 1;
            last = prime;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count * 10000 + last));
}
