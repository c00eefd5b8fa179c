#include "st.h"
static uint8_t flags[4001];
static int32_t scans;
void scan(void)
{
    for (int i = 2; i <= 4000; i++) flags[i] = 1;
    for (int i = 2; i * i <= 4000; i++)
        if (flags[i])
            for (int j = i * i; j <= 4000; j += i) flags[j] = 0;
    int count = 0;
    for (int i = 2; i <= 4000; i++) count += flags[i];
    check += count;
    scans++;
}
