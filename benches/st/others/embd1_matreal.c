/* 32 x 32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N];
static float b[N][N];
static float c[N][N];
static int32_t turn;
static bool first = true;

void scan(void)
{
    int32_t i, j, k;
    float sum, trace;

    if (first) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)(i - j) * 0.25f;
                b[i][j] = (float)((i * 3 + j) % 17) * 0.1f;
            }
        }
        first = false;
    }

    turn++;
    a[turn % N][(turn * 5) % N] = (float)(turn % 256) * 0.125f;

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
        trace = trace + c[i][i] - c[i][N - 1 - i] * 0.5f;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 10.0f)
                      + (uint32_t)(int32_t)(c[turn % N][5] * 100.0f));
}
