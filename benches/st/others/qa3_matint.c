#include "st.h"
#include <stdbool.h>

static bool first = true;
static int16_t cycle;
static int16_t a[32][32], b[32][32], c[32][32];

void scan(void)
{
    int i, j, k;
    uint32_t total = 0;

    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 19 - 9);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 23 - 11);
            }
    }
    for (j = 0; j < 32; j++)
        a[cycle][j] = (int16_t)((a[cycle][j] + 10 + j) % 19 - 9);
    cycle = (int16_t)((cycle + 1) % 32);

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            int16_t s = 0;
            for (k = 0; k < 32; k++)
                s = (int16_t)(s + a[i][k] * b[k][j]);
            c[i][j] = s;
        }
    }
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++)
            total = total * 3u + (uint32_t)(int32_t)c[i][j];
    check = (int32_t)((uint32_t)check * 31u + total);
}
