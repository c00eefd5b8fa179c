#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXN 3000

static bool composite[MAXN + 1];
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    int32_t limit = 2000 + (int32_t)((uint32_t)scan_no * 37u) % 1000;

    memset(composite, 0, (size_t)limit + 1);
    for (int32_t n = 2; n * n <= limit; n++) {
        if (composite[n])
            continue;
        for (int32_t m = n * n; m <= limit; m += n)
            composite[m] = true;
    }
    int32_t count = 0, sum = 0, last = 0;
    for (int32_t n = 2; n <= limit; n++) {
        if (!composite[n]) {
            count++;
            sum += n;
            last = n;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + count * 7 + last));
}
