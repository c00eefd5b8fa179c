#include <stdbool.h>
#include "st.h"

#define TOP 8000

static bool composite[TOP + 1];
static int32_t last;

void scan(void)
{
    int32_t i, j, count;

    for (i = 0; i <= TOP; i++)
        composite[i] = false;

    for (i = 2; i * i <= TOP; i++) {
        if (!composite[i]) {
            for (j = i * i; j <= TOP; j += i)
                composite[j] = true;
        }
    }

    count = 0;
    for (i = 2; i <= TOP; i++) {
        if (!composite[i]) {
            count++;
            last = i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count + last));
}
