#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXN 4095

static bool composite[MAXN + 1];
static int limit = 3000;

void scan(void)
{
    limit += 37;
    if (limit > MAXN)
        limit -= 1096;
    memset(composite, 0, sizeof composite);
    for (int p = 2; p * p <= limit; p++)
        if (!composite[p])
            for (int k = p * p; k <= limit; k += p)
                composite[k] = true;

    int count = 0, max_gap = 0, last = 2;
    int32_t sum = 0;
    for (int p = 2; p <= limit; p++) {
        if (!composite[p]) {
            count++;
            sum += p;
            if (p - last > max_gap)
                max_gap = p - last;
            last = p;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + sum + count * 7 + max_gap);
}
