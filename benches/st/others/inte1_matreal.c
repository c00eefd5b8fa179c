/* 32x32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init;
static float a[N][N], b[N][N], c[N][N];
static int32_t n;

void scan(void)
{
    int i, j, k;
    float sum, trace;

    if (!init) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 41 - 20) * 0.25f;
                b[i][j] = (float)((i * 5 + j * 11) % 37 - 18) * 0.1f;
            }
        }
        init = true;
    }

    /* one new sample per scan */
    n++;
    i = n % 32;
    j = (n / 32) % 32;
    a[i][j] = (float)(n % 101 - 50) * 0.3f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0.0f;
            for (k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    trace = 0.0f;
    for (i = 0; i < N; i++)
        trace = trace + c[i][i] + c[i][N - 1 - i] * 0.5f;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 16.0f));
}
