#include <stdbool.h>
#include <string.h>
#include "st.h"

static bool composite[3001];
static int limit = 2900;

void scan(void)
{
    if (++limit > 3000) limit = 2900;
    int n = limit, count = 0, last = 0;
    memset(composite, 0, sizeof composite);
    for (int i = 2; i <= n; i++) {
        if (composite[i]) continue;
        count++;
        last = i;
        for (int j = i * i; j <= n; j += i) composite[j] = true;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(count + last));
}
