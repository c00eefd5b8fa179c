#include "st.h"
#include <stdbool.h>

#define N 8192

static bool composite[N + 1];

void scan(void)
{
    int32_t i, j, count = 0, sum = 0;

    for (i = 0; i <= N; i++)
        composite[i] = false;
    for (i = 2; i * i <= N; i++) {
        if (!composite[i]) {
            for (j = i * i; j <= N; j += i)
                composite[j] = true;
        }
    }
    for (i = 2; i <= N; i++) {
        if (!composite[i]) {
            count++;
            sum += i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)count + (uint32_t)sum);
}
