#include "st.h"
static int16_t data[65];
static int32_t seed = 12345;
void scan(void)
{
    for (int i = 1; i <= 64; i++) { seed = (seed * 1103 + 12345) % 65536; data[i] = (seed < 0 ? -seed : seed) % 1000; }
    for (int i = 1; i <= 63; i++) {
        int swapped = 0;
        for (int j = 1; j <= 64 - i; j++)
            if (data[j] > data[j + 1]) { int16_t t = data[j]; data[j] = data[j + 1]; data[j + 1] = t; swapped = 1; }
        if (!swapped) break;
    }
    check += data[1] + data[32] * 2 + data[64] * 3;
}
