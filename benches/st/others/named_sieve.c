#include "st.h"
#include <stdbool.h>
#define MAX_NUMBER 8000
static bool crossed[MAX_NUMBER + 1];
static int32_t scans;

void scan(void)
{
    scans++;
    int limit = MAX_NUMBER - scans % 16;
    for (int n = 2; n <= limit; n++)
        crossed[n] = false;
    for (int n = 2; n * n <= limit; n++)
        if (!crossed[n])
            for (int m = n * n; m <= limit; m += n)
                crossed[m] = true;
    int count = 0;
    int32_t sum = 0;
    for (int n = 2; n <= limit; n++)
        if (!crossed[n]) {
            count++;
            sum += n;
        }
    check = (check + sum + count) % 1000000;
}
