#include <stdbool.h>
#include "st.h"

#define MAX_NUMBER 4000
#define MIN_NUMBER 3000

static bool is_prime[MAX_NUMBER + 1];
static int32_t limit = MIN_NUMBER;

void scan(void)
{
    is_prime[1] = false;
    for (int n = 2; n <= limit; n++)
        is_prime[n] = true;

    for (int n = 2; n * n <= limit; n++)
        if (is_prime[n])
            for (int m = n * n; m <= limit; m += n)
                is_prime[m] = false;

    int32_t count = 0, twins = 0, last = 0;
    for (int n = 2; n <= limit; n++) {
        if (is_prime[n]) {
            count++;
            if (n - last == 2)
                twins++;
            last = n;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count * 100 + twins + last));

    limit += 7;
    if (limit > MAX_NUMBER)
        limit = MIN_NUMBER;
}
