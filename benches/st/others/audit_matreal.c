/* Product of two 32x32 matrices of float */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool started;
static int16_t turn;
static float a[N][N], b[N][N], c[N][N];

void scan(void)
{
    int i, j, k;
    float sum;

    if (!started) {
        started = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101) / 101.0f;
                b[i][j] = (float)((i * 5 + j * 11) % 97) / 97.0f - 0.5f;
            }
        }
    }

    /* one row is measured anew in each scan */
    turn = (int16_t)((turn + 1) % 32);
    for (j = 0; j < N; j++)
        a[turn][j] = 1.0f - a[turn][j] * 0.75f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0.0f;
            for (k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    sum = 0.0f;
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            sum += c[i][j];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 1000.0f)
                      + (uint32_t)(int32_t)(c[turn][5] * 10000.0f));
}
