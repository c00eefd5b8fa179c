#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX_N 3000

static int32_t scan_no;
static bool is_prime[MAX_N + 1];

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    int limit = MAX_N - (scan_no % 100) * 10;
    scan_no = (int32_t)((uint32_t)scan_no + 1u);

    is_prime[0] = is_prime[1] = false;
    memset(&is_prime[2], true, (size_t)(limit - 1));

    for (int i = 2; i * i <= limit; i++)
        if (is_prime[i])
            for (int k = i * i; k <= limit; k += i)
                is_prime[k] = false;

    int count = 0, sum = 0, last = 2, twins = 0, max_gap = 0;
    for (int i = 2; i <= limit; i++) {
        if (is_prime[i]) {
            int gap = i - last;
            count++;
            sum += i;
            if (gap == 2)
                twins++;
            if (gap > max_gap)
                max_gap = gap;
            last = i;
        }
    }

    add(count);
    add(sum);
    add(twins);
    add(max_gap);
    add(last);
}
