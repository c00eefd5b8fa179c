/* 32x32 product, int16_t elements, int32_t sums */
#include <stdbool.h>
#include "st.h"

static int16_t a[32][32], b[32][32];
static int32_t c[32][32];
static int16_t n;
static bool first = true;

void scan(void)
{
    int i, j, k;
    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (int16_t)(i * 3 - j);
                b[i][j] = (int16_t)(j * 5 - i * 2);
            }
    }
    n = (n + 1) % 32;
    a[n][31 - n] += 7;

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            int32_t sum = 0;
            for (k = 0; k < 32; k++)
                sum += (int32_t)a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    for (i = 0; i < 32; i++)
        check = check * 31 + c[i][31 - i] + c[i][n];
}
