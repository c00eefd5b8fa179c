/* prime sieve up to 8191 */
#include <stdbool.h>
#include "st.h"

#define LIMIT_N 8191

static bool composite[LIMIT_N + 1];
static int32_t round_no;

void scan(void)
{
    int32_t i, j, count, sum;

    round_no++;
    for (i = 0; i <= LIMIT_N; i++)
        composite[i] = false;

    i = 2;
    while (i * i <= LIMIT_N) {
        if (!composite[i]) {
            j = i * i;
            while (j <= LIMIT_N) {
                composite[j] = true;
                j += i;
            }
        }
        i++;
    }

    count = 0;
    sum = 0;
    for (i = 2; i <= LIMIT_N; i++) {
        if (!composite[i]) {
            count++;
            sum += i;
        }
    }

    check = (int32_t)((uint32_t)check * 3u + (uint32_t)count + (uint32_t)sum + (uint32_t)round_no);
}
