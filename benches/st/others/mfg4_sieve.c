#include <stdbool.h>
#include <string.h>
#include "st.h"

typedef struct { int32_t count, sum, largest, twins; } Result;

static bool field[4096];
static int32_t scans;

static Result sieve(bool *f, int32_t limit)
{
    memset(f, true, (size_t)limit + 1);
    f[0] = f[1] = false;
    for (int32_t i = 2; i * i <= limit; i++) {
        if (!f[i])
            continue;
        for (int32_t k = i * i; k <= limit; k += i)
            f[k] = false;
    }

    Result r = {0, 0, 0, 0};
    int32_t last = 0;
    for (int32_t i = 2; i <= limit; i++) {
        if (f[i]) {
            r.count++;
            r.sum += i;
            if (i - last == 2)
                r.twins++;
            last = i;
        }
    }
    r.largest = last;
    return r;
}

void scan(void)
{
    scans++;
    Result r = sieve(field, 3500 + scans % 596);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(r.count + r.sum + r.twins * 7 + r.largest));
}
