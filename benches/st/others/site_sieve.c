/* Prime numbers up to a limit that moves from scan to scan, by the sieve of Eratosthenes. */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX_NO 8192

struct result {
    int16_t count, largest, twins;
    int32_t sum;
};

static bool composite[MAX_NO + 1];
static struct result result;
static int16_t scan_no;

static void sieve(int limit, struct result *r)
{
    memset(composite, 0, (size_t)limit + 1);
    for (int n = 2; n * n <= limit; n++) {
        if (composite[n])
            continue;
        for (int k = n * n; k <= limit; k += n)
            composite[k] = true;
    }
    memset(r, 0, sizeof *r);
    int last = -10;
    for (int n = 2; n <= limit; n++) {
        if (composite[n])
            continue;
        r->count++;
        r->largest = n;
        r->sum += n;
        if (n - last == 2)
            r->twins++;
        last = n;
    }
}

void scan(void)
{
    if (++scan_no >= 100)
        scan_no = 0;
    sieve(MAX_NO - scan_no * 7, &result);
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)(result.sum + result.count + result.largest + result.twins));
}
