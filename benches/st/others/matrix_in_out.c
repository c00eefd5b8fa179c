#include <stdint.h>
#include "st.h"

static int32_t scans;
static int16_t a[1024], b[1024], c[1024];

static void matmul(const int16_t *x, const int16_t *y, int16_t *z)
{
    for (int row = 0; row < 32; row++)
        for (int col = 0; col < 32; col++) {
            z[row * 32 + col] = 0;
            for (int k = 0; k < 32; k++)
                z[row * 32 + col] += x[row * 32 + k] * y[k * 32 + col];
        }
}

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 1024; i++) {
            a[i] = i % 11 - 5;
            b[i] = i % 13 - 6;
        }
    scans++;
    a[scans % 1024] = scans % 17;
    matmul(a, b, c);
    for (int i = 0; i < 1024; i += 3)
        check += c[i];
    check %= 1000000;
}
