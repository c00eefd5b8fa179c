/* 32 x 32 matrix product in float */
#include "st.h"
#include <stdbool.h>
#include <math.h>

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int16_t row = 0;

void scan(void)
{
    int16_t i, j, k;
    float acc, norm;

    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)(i - j) / 16.0f;
                b[i][j] = (float)(((i + 1) * (j + 1)) % 13) * 0.125f - 0.5f;
            }
        }
        ready = true;
    }

    row = (row + 1) % N;
    for (j = 0; j < N; j++)
        a[row][j] = a[row][j] * 0.9f + 0.25f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0.0f;
            for (k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    norm = 0.0f;
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            norm += fabsf(c[i][j]);

    check = (check + (int32_t)(norm * 16.0f)) % 10000019;
}
