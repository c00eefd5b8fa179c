/* Prime sieve; the limit moves from scan to scan */
#include <stdbool.h>
#include "st.h"

#define MAX 3000

static bool prime[MAX + 1];
static int scan_no;

void scan(void)
{
    scan_no = (scan_no + 7) % 1000;
    int limit = MAX - scan_no;

    prime[0] = prime[1] = false;
    for (int i = 2; i <= limit; i++)
        prime[i] = true;

    for (int i = 2; i * i <= limit; i++)
        if (prime[i])
            for (int j = i * i; j <= limit; j += i)
                prime[j] = false;

    int count = 0, last = 0;
    int32_t sum = 0;
    for (int i = 0; i <= limit; i++) {
        if (prime[i]) {
            count++;
            last = i;
            sum += i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + count * 7 + last));
}
