#include <stdbool.h>
#include "st.h"

static int32_t scanNo;
static bool flags[8192];

void scan(void)
{
    int32_t i, j, limit, count, last;

    scanNo++;
    limit = 8191 - scanNo % 16;
    for (i = 0; i <= limit; i++)
        flags[i] = true;
    flags[0] = false;
    flags[1] = false;
    i = 2;
    while (i * i <= limit) {
        if (flags[i]) {
            j = i * i;
            while (j <= limit) {
                flags[j] = false;
                j += i;
            }
        }
        i++;
    }
    count = 0;
    last = 0;
    for (i = 0; i <= limit; i++) {
        if (flags[i]) {
            count++;
            last = i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count + last));
}
