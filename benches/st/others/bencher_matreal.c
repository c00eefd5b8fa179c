/* 32 x 32 REAL matrix product; A is renewed from C every scan. */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool init;

void scan(void)
{
    int32_t i, j, k;
    float s, tr;

    if (!init) {
        for (i = 0; i < N; i++)
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 23) * 0.1f;
                b[i][j] = (float)((i * 5 + j * 11) % 19 - 9) * 0.005f;
            }
        init = true;
    }

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            s = 0.0f;
            for (k = 0; k < N; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }

    tr = 0.0f;
    for (i = 0; i < N; i++) {
        tr += c[i][i];
        for (j = 0; j < N; j++)
            a[i][j] = 0.5f * c[i][j] + 0.25f * a[i][j] + (float)(i + j) * 0.01f;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(tr * 1000.0f));
}
