#include <stdbool.h>
#include "st.h"

static int16_t n;
static bool init;
static float a[32][32], b[32][32], c[32][32];

static float absf(float x)
{
    return x < 0.0f ? -x : x;
}

void scan(void)
{
    int16_t i, j, k;
    float sum, norm;

    if (!init) {
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)(i - j) * 0.125f;
                b[i][j] = (float)((i + 1) + 2 * (j + 1)) / 64.0f;
            }
        init = true;
    }

    n++;
    if (n >= 500)
        n = 0;
    for (i = 0; i < 32; i++)
        b[i][n % 32] = (float)(n - 10 * (i + 1)) * 0.01f;

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            sum = 0.0f;
            for (k = 0; k < 32; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    norm = 0.0f;
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++)
            norm += absf(c[i][j]);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)norm);
}
