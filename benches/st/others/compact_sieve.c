#include "st.h"
#include <stdbool.h>
#include <string.h>

static bool flags[8191];
static int32_t scans;

static int32_t sieve(bool *f, int32_t size)
{
    memset(f, true, size + 1);
    int32_t count = 0, hash = 0;
    for (int32_t i = 0; i <= size; i++) {
        if (f[i]) {
            int32_t prime = i + i + 3;
            for (int32_t k = i + prime; k <= size; k += prime)
                f[k] = false;
            count++;
            hash = (hash * 7 + prime) % 32749;
        }
    }
    return count + hash;
}

void scan(void)
{
    scans++;
    check = (check * 5 + sieve(flags, 8190 - scans % 100)) % 99991;
}
