/* 32 x 32 matrix product, int16_t elements, int32_t result */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int16_t seed;
static bool first = true;

void scan(void)
{
    int16_t i, j, k;
    int32_t acc;

    if (first) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 - j * 11) % 97;
            }
        }
        first = false;
    }

    /* one row changes each scan */
    seed = (seed + 1) % 1000;
    for (j = 0; j < N; j++)
        a[seed % N][j] = seed - j * 9;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0;
            for (k = 0; k < N; k++)
                acc += (int32_t)a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    for (i = 0; i < N; i++)
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)c[i][(i + seed) % N] + (uint32_t)c[N - 1 - i][i]);
}
