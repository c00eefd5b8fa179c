/* 32x32 product of float matrices */
#include <stdbool.h>
#include "st.h"

static float a[32][32], b[32][32], c[32][32];
static int16_t n;
static bool first = true;

void scan(void)
{
    int i, j, k;
    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)(i * 3 - j) * 0.1f;
                b[i][j] = (float)(j * 5 - i * 2) * 0.01f;
            }
    }
    n = (n + 1) % 32;
    a[n][31 - n] = a[n][31 - n] * 0.5f + 1.0f;

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            float sum = 0.0f;
            for (k = 0; k < 32; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    float trace = 0.0f;
    for (i = 0; i < 32; i++)
        trace = trace + c[i][i] + c[i][n];
    check = check * 31 + (int32_t)(trace * 10.0f);
}
