/* 32 x 32 matrix product in float. */
#include "st.h"
#include <stdbool.h>

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int32_t round_no;
static bool started;

void scan(void)
{
    int32_t i, j, k;

    if (!started) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 21 - 10) * 0.125f;
                b[i][j] = (float)((i * 5 + j * 11) % 23 - 11) * 0.3f;
            }
        }
        started = true;
    }

    /* a new row each scan */
    round_no = (round_no + 1) % 1000;
    for (j = 0; j < N; j++)
        a[round_no % N][j] = (float)((round_no + j * 3) % 21 - 10) * 0.1f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            float s = 0.0f;
            for (k = 0; k < N; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }
    }

    float total = 0.0f;
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++)
            total += c[i][j];
        total += 3.0f * c[i][i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 100.0f));
}
