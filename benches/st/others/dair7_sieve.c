#include "st.h"
#include <stdbool.h>
#include <string.h>

static bool prime[4001];
static int limit = 3000;

void scan(void)
{
    limit += 37;
    if (limit > 4000)
        limit -= 1000;

    prime[0] = prime[1] = false;
    memset(prime + 2, true, (size_t)(limit - 1));
    for (int i = 2; i * i <= limit; i++)
        if (prime[i])
            for (int k = i * i; k <= limit; k += i)
                prime[k] = false;

    int32_t count = 0, sum = 0, largest = 0;
    for (int i = 0; i <= limit; i++)
        if (prime[i]) {
            count++;
            sum += i;
            largest = i;
        }
    check = (int32_t)((uint32_t)check * 7u + (uint32_t)(count + sum + largest));
}
