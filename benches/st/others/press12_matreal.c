/* 32 x 32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool init_done;
static uint32_t seed = 7;
static int row;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 5 + j * 3) % 41 - 20) * 0.25f;
                b[i][j] = (float)((i * 7 + j * 11) % 37 - 18) * 0.1f;
            }
        init_done = true;
    }

    for (int i = 0; i < N; i++) {
        seed = seed * 1664525u + 1013904223u;
        a[row][i] = (float)(seed / 65536 % 1000) * 0.01f - 5.0f;
        b[i][row] = (float)(seed / 4194304 % 1000) * 0.003f - 1.5f;
    }
    row = (row + 1) % 32;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    uint32_t hash = 0;
    for (int i = 0; i < N; i++) {
        float sum = 0;
        for (int j = 0; j < N; j++)
            sum += c[i][j];
        hash = hash * 31 + (int32_t)(sum * 1000.0f);
    }
    check = (int32_t)hash;
}
