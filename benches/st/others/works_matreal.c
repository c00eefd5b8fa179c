/* 32 x 32 matrix product in REAL */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int16_t row;
static bool ready;

void scan(void)
{
    int16_t i, j, k;
    float sum, total;

    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 41) * 0.05f - 1.0f;
                b[i][j] = (float)((i * 5 + j * 11) % 37) * 0.06f - 1.0f;
            }
        }
        ready = true;
    }

    row = (row + 1) % 32;
    for (j = 0; j < N; j++)
        a[row][j] = a[row][j] * 0.9f + (float)j * 0.01f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0.0f;
            for (k = 0; k < N; k++)
                sum = sum + a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    total = 0.0f;
    for (i = 0; i < N; i++)
        total = total + c[i][i] * 2.0f + c[i][N - 1 - i];
    check = (check * 3 + (int32_t)(total * 1000.0f)) % 1000003;
}
