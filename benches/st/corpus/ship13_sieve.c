#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX_N 2000

static bool composite[MAX_N + 1];
static int16_t limit = 1500;
static uint32_t crc;

void scan(void)
{
    limit += 7;
    if (limit > MAX_N)
        limit -= 500;

    memset(composite, 0, limit + 1);

    for (int i = 2; i * i <= limit; i++) {
        if (!composite[i]) {
            for (int k = i * i; k <= limit; k += i)
                composite[k] = true;
        }
    }

    int count = 0, last = 0;
    for (int i = 2; i <= limit; i++) {
        if (!composite[i]) {
            count++;
            last = i;
        }
    }

    crc = crc * 31 + count * 2003 + last;
    check = (int32_t)crc;
}
