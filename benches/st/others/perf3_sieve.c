/* The odd primes up to a limit that moves with each scan */
#include <stdbool.h>
#include <string.h>
#include "st.h"

static int32_t tick;
static bool composite[2048]; /* [i] stands for 2 * i + 1 */

void scan(void)
{
    tick = (tick + 1) % 500;
    int32_t limit = 1500 + tick;

    memset(composite, 0, (size_t)limit + 1);
    for (int32_t i = 1, p = 3; p * p <= 2 * limit + 1; i++, p += 2)
        if (!composite[i])
            for (int32_t k = (p * p - 1) / 2; k <= limit; k += p)
                composite[k] = true;

    int32_t count = 1, last = 2;
    for (int32_t i = 1; i <= limit; i++)
        if (!composite[i]) {
            count++;
            last = 2 * i + 1;
        }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count * 10000 + last));
}
