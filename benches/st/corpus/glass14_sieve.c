#include "st.h"
#include <stdbool.h>
#include <string.h>

#define MAXN 3000

static bool composite[MAXN + 1];
static int tick;

void scan(void)
{
    tick = (tick + 1) % 1000;
    int limit = 2000 + tick;

    memset(composite, 0, (size_t)limit + 1);
    for (int i = 2; i * i <= limit; i++) {
        if (composite[i])
            continue;
        for (int k = i * i; k <= limit; k += i)
            composite[k] = true;
    }

    int count = 0, last = 0;
    int32_t sum = 0;
    for (int i = 2; i <= limit; i++) {
        if (!composite[i]) {
            count++;
            sum += i;
            last = i;
        }
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + count * 7 + last));
}
