/* The product of two 32 x 32 matrices of float, row by row; a column of one changes in each scan */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int col;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)(i - j) * 0.037f;
                b[i][j] = (float)(i * j % 17) * 0.11f - 0.8f;
            }
        ready = true;
    }
    for (int i = 0; i < N; i++)
        a[i][col] = 0.75f * a[i][col] + 0.1f * b[col][i] + 0.01f;
    col = (col + 1) % N;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            c[i][j] = 0.0f;
        for (int k = 0; k < N; k++) {
            float f = a[i][k];
            for (int j = 0; j < N; j++)
                c[i][j] += f * b[k][j];
        }
    }

    float total = 0.0f;
    for (int i = 0; i < N; i++) {
        float f = c[i][0];
        for (int j = 1; j < N; j++)
            f = f > c[i][j] ? f : c[i][j];
        total = total + f - 0.5f * c[i][i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 1000.0f) + 1u);
}
