/* Product of two 32x32 matrices of int16_t into one of int32_t */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool started;
static int16_t turn;
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];

void scan(void)
{
    int i, j, k;
    uint32_t fold;

    if (!started) {
        started = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        }
    }

    /* one row is measured anew in each scan */
    turn = (int16_t)((turn + 1) % 32);
    for (j = 0; j < N; j++)
        a[turn][j] = (int16_t)((a[turn][j] + j + 55) % 101 - 50);

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            int32_t sum = 0;
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
