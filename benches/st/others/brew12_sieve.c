/* Prime sieve over bottle numbers. */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "st.h"

#define MAX_NO 2500

struct sieve_result {
    int count, largest;
    int32_t sum;
};

static bool composite[MAX_NO + 1];
static int step;

static struct sieve_result sieve(int limit)
{
    struct sieve_result r = {0};

    memset(composite, 0, (size_t)limit + 1);
    for (int i = 2; i * i <= limit; i++)
        if (!composite[i])
            for (int j = i * i; j <= limit; j += i)
                composite[j] = true;

    for (int i = 2; i <= limit; i++)
        if (!composite[i]) {
            r.count++;
            r.largest = i;
            r.sum += i;
        }
    return r;
}

void scan(void)
{
    step = (step + 37) % 500;
    struct sieve_result r = sieve(2000 + step);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(r.sum + r.count * 1000 + r.largest));
}
