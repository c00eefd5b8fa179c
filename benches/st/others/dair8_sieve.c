/* Sieve of Eratosthenes over the numbers 2..LIMIT */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define LIMIT 4000

typedef struct { int32_t count, largest, sum; } sieve_result;

static bool composite[LIMIT + 1];
static int32_t first;

static sieve_result sieve(int32_t start)
{
    sieve_result r = { 0, 0, 0 };

    memset(composite, 0, sizeof composite);
    composite[0] = composite[1] = true;
    for (int32_t n = 2; n * n <= LIMIT; n++)
        if (!composite[n])
            for (int32_t k = n * n; k <= LIMIT; k += n)
                composite[k] = true;

    for (int32_t n = start; n <= LIMIT; n++) {
        if (!composite[n]) {
            r.count++;
            r.largest = n;
            r.sum += n;
        }
    }
    return r;
}

void scan(void)
{
    sieve_result r = sieve(first);

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(r.count + r.largest * 3 + r.sum));
    first = (first + 7) % 1000;
}
