#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX_LIMIT 2047

static bool crossed[MAX_LIMIT + 1];
static int limit = 1500;

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    limit += 7;
    if (limit > 2000) limit -= 500;

    int top = limit < MAX_LIMIT ? limit : MAX_LIMIT;
    memset(crossed, 0, (size_t)top + 1);

    for (int n = 2; n * n <= top; n++)
        if (!crossed[n])
            for (int m = n * n; m <= top; m += n)
                crossed[m] = true;

    int primes = 0, twins = 0, gap = 0, last = 2;
    int32_t total = 0;
    for (int n = 2; n <= top; n++) {
        if (crossed[n]) continue;
        primes++;
        total += n;
        if (n - last == 2) twins++;
        if (n - last > gap) gap = n - last;
        last = n;
    }
    add(total);
    add(primes);
    add(twins);
    add(gap);
    add(last);
}
