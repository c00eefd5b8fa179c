#include <stdbool.h>
#include <string.h>
#include "st.h"

#define HALF 2500

static bool composite[HALF];
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    int32_t top = HALF - scan_no % 10 * 50;

    memset(composite, 0, (size_t)top);

    for (int32_t p = 3; p * p <= 2 * top - 1; p += 2) {
        if (composite[p / 2])
            continue;
        for (int32_t k = p * p / 2; k < top; k += p)
            composite[k] = true;
    }

    int32_t count = 1, twins = 0, widest = 0, total = 2, last = 2;
    for (int32_t i = 1; i < top; i++) {
        if (composite[i])
            continue;
        int32_t p = 2 * i + 1;
        int32_t gap = p - last;
        if (gap == 2)
            twins++;
        if (gap > widest)
            widest = gap;
        count++;
        total += p;
        last = p;
    }

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + (uint32_t)count;
    sum = sum * 31 + (uint32_t)twins;
    sum = sum * 31 + (uint32_t)widest;
    sum = sum * 31 + (uint32_t)total;
    sum = sum * 31 + (uint32_t)last;
    check = (int32_t)sum;
}
