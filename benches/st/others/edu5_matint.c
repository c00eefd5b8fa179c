#include <stdbool.h>
#include "st.h"

#define N 32
static int16_t a[N][N], b[N][N], c[N][N];
static int16_t n;
static bool filled;

void scan(void)
{
    if (!filled) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)(3 * i - 2 * j + 1);
                b[i][j] = (int16_t)(i + 5 * j - 40);
            }
        filled = true;
    }
    n = (int16_t)(n + 1);
    a[n % N][n % N] = n;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++) sum = (int16_t)(sum + a[i][k] * b[k][j]);
            c[i][j] = sum;
        }

    uint32_t total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) total = total * 3u + (uint32_t)c[i][j];
    check = (int32_t)((uint32_t)check * 31u + total);
}
