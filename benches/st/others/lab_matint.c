/* 32 x 32 matrix product, int16 factors, int32 result */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool ready;
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int16_t tick;

void scan(void)
{
    int i, j, k;
    int32_t sum;
    uint32_t fold;

    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 - j * 11) % 97;
            }
        }
        ready = true;
    }

    tick = (tick + 1) % 1000;
    a[tick % 32][tick / 32] = tick - 500;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0;
            for (k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
    }

    fold = 0;
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            fold = fold * 3u + (uint32_t)c[i][j];
    check = (int32_t)((uint32_t)check * 31u + fold);
}
