/* Prime sieve, limit moves a little from scan to scan */
#include <stdbool.h>
#include "st.h"

#define MAX_PRIME 4095

static int32_t diScan;
static bool axComposite[MAX_PRIME + 1];

void scan(void)
{
    int32_t diLimit, diCount, diSum, diLast = 0, i, k;

    diScan = diScan + 1;
    diLimit = MAX_PRIME - (diScan % 64);
    for (i = 0; i <= diLimit; i++)
        axComposite[i] = false;

    for (i = 2; i * i <= diLimit; i++) {
        if (!axComposite[i]) {
            for (k = i * i; k <= diLimit; k += i)
                axComposite[k] = true;
        }
    }

    diCount = 0;
    diSum = 0;
    for (i = 2; i <= diLimit; i++) {
        if (!axComposite[i]) {
            diCount++;
            diSum += i;
            diLast = i;
        }
    }
    check = check * 5 + diCount + diSum - diLast;
}
