#include "st.h"
#include <stdbool.h>
#include <string.h>

struct result {
    int32_t count, sum, largest, twins;
};

static bool composite[2048]; /* flag i stands for 2 * i + 1 */
static int32_t scan_no;

static struct result sieve(int32_t limit)
{
    int32_t last = (limit - 1) / 2;
    memset(composite, 0, (size_t)last + 1);

    for (int32_t prime = 3; prime * prime <= limit; prime += 2) {
        if (composite[prime / 2])
            continue;
        for (int32_t k = prime * prime / 2; k <= last; k += prime)
            composite[k] = true;
    }

    struct result r = { .count = 1, .sum = 2, .largest = 2, .twins = 0 };
    for (int32_t i = 1; i <= last; i++) {
        if (composite[i])
            continue;
        int32_t prime = 2 * i + 1;
        if (prime - r.largest == 2)
            r.twins++;
        r.count++;
        r.sum += prime;
        r.largest = prime;
    }
    return r;
}

void scan(void)
{
    struct result r = sieve(3000 + scan_no % 1000);
    scan_no++;
    check = (int32_t)((uint32_t)check * 31u
                      + (uint32_t)(r.count + r.sum + r.largest * 7 + r.twins * 1001));
}
