#include <stdint.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define N 8192
static int32_t scans;
static bool composite[N + 1];

void scan(void)
{
    scans++;
    memset(composite, 0, sizeof composite);
    for (int i = 2; i * i <= N; i++)
        if (!composite[i])
            for (int j = i * i; j <= N; j += i)
                composite[j] = true;
    int32_t count = 0;
    for (int i = 2; i <= N; i++)
        if (!composite[i])
            count++;
    check = (check + count + scans) % 1000000;
}
