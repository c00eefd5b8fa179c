#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXN 4000

static bool composite[MAXN + 1];
static int32_t n;

void scan(void)
{
    int limit, count = 0, sum = 0, last = 0;

    n++;
    limit = 3000 + (n * 37) % 1000;
    memset(composite, 0, (size_t)limit + 1);

    for (int i = 2; i * i <= limit; i++)
        if (!composite[i])
            for (int j = i * i; j <= limit; j += i)
                composite[j] = true;

    for (int i = 2; i <= limit; i++)
        if (!composite[i]) {
            count++;
            sum += i;
            last = i;
        }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count + sum + last));
}
