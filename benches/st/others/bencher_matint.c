/* 32 x 32 integer matrix product, A is renewed from C every scan. */
#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t a[N][N], b[N][N], c[N][N];
static bool init;

void scan(void)
{
    int32_t i, j, k, s, tr;

    if (!init) {
        for (i = 0; i < N; i++)
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 23 - 11;
                b[i][j] = (i * 5 + j * 11) % 19 - 9;
            }
        init = true;
    }

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            s = 0;
            for (k = 0; k < N; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }

    tr = 0;
    for (i = 0; i < N; i++) {
        tr += c[i][i];
        for (j = 0; j < N; j++)
            a[i][j] = (c[j][i] + i) % 100;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)tr);
}
