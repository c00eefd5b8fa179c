#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXN 4000

static bool composite[MAXN + 1];
static int limit = 3000;

void scan(void)
{
    memset(composite, 0, limit + 1);
    for (int i = 2; i * i <= limit; i++) {
        if (!composite[i]) {
            for (int j = i * i; j <= limit; j += i)
                composite[j] = true;
        }
    }

    int32_t count = 0, sum = 0;
    for (int i = 2; i <= limit; i++) {
        if (!composite[i]) {
            count++;
            sum += i;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)count);
    limit += 37;
    if (limit > MAXN)
        limit -= 1000;
}
