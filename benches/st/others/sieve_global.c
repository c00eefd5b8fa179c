#include "st.h"
#include <stdbool.h>
#include <string.h>

enum { LIMIT_N = 8000 };
static bool composite[LIMIT_N + 1];
static int scans;

void scan(void)
{
    scans++;
    int top = LIMIT_N - scans % 100;
    memset(composite, 0, top + 1);
    for (int p = 2; p * p <= top; p++)
        if (!composite[p])
            for (int k = p * p; k <= top; k += p)
                composite[k] = true;
    int count = 0, last = 2, gap = 0;
    for (int k = 2; k <= top; k++) {
        if (!composite[k]) {
            count++;
            if (k - last > gap)
                gap = k - last;
            last = k;
        }
    }
    check = (check + count + last * 3 + gap) % 1000000;
}
