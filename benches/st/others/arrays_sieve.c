#include <stdbool.h>
#include <string.h>
#include "st.h"

#define TOP 8192

static int32_t n;
static bool composite[TOP + 1];
static int32_t primes[1200];

void scan(void)
{
    memset(composite, 0, sizeof composite);
    for (int i = 2; i <= 90; i++)
        if (!composite[i])
            for (int k = i * i; k <= TOP; k += i) composite[k] = true;

    int count = 0;
    for (int i = 2; i <= TOP; i++)
        if (!composite[i]) primes[count++] = i;

    n++;
    check = (check * 31 + count + primes[(n * 37) % count]) % 1000003;
}
