#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXN 4200

static bool composite[MAXN + 1];
static int32_t nscan;

void scan(void)
{
    nscan++;
    int limit = 3900 + nscan % 300;
    memset(composite, 0, (size_t)limit + 1);
    for (int p = 2; p * p <= limit; p++)
        if (!composite[p])
            for (int j = p * p; j <= limit; j += p)
                composite[j] = true;
    int count = 0, last = 0;
    int32_t sum = 0;
    for (int i = 2; i <= limit; i++)
        if (!composite[i]) {
            count++;
            sum += i;
            last = i;
        }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + count * 7 + last));
}
