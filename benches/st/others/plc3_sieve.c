#include <stdbool.h>
#include "st.h"

#define MAXN 5000

static int32_t n;
static bool composite[MAXN + 1];

void scan(void)
{
    int32_t i, j, limit, count, last;

    n++;
    if (n >= 1000)
        n = 0;
    limit = MAXN - n;

    for (i = 0; i <= limit; i++)
        composite[i] = false;

    for (i = 2; i * i <= limit; i++) {
        if (!composite[i]) {
            for (j = i * i; j <= limit; j += i)
                composite[j] = true;
        }
    }

    count = 0;
    last = 0;
    for (i = 2; i <= limit; i++) {
        if (!composite[i]) {
            count++;
            last = i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)count + (uint32_t)last);
}
