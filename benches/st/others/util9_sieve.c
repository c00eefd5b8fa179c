#include <stdbool.h>
#include "st.h"

#define MAX 4000

static bool prime[MAX + 1];
static int32_t scans;

void scan(void)
{
    scans++;
    int32_t limit = MAX - scans % 500;
    for (int32_t i = 0; i <= limit; i++)
        prime[i] = true;
    prime[0] = prime[1] = false;
    for (int32_t i = 2; i * i <= limit; i++) {
        if (prime[i]) {
            for (int32_t j = i * i; j <= limit; j += i)
                prime[j] = false;
        }
    }
    int32_t count = 0, last = 0;
    for (int32_t i = 2; i <= limit; i++) {
        if (prime[i]) {
            count++;
            last = i;
        }
    }
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)(count * 5 + last));
}
