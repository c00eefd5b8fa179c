/* 32 x 32 matrix product in int16_t. */
#include "st.h"
#include <stdbool.h>

#define N 32

static int16_t a[N][N], b[N][N], c[N][N];
static int32_t round_no;
static bool started;

void scan(void)
{
    int32_t i, j, k;

    if (!started) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 21 - 10;
                b[i][j] = (i * 5 + j * 11) % 23 - 11;
            }
        }
        started = true;
    }

    /* a new row each scan */
    round_no = (round_no + 1) % 1000;
    for (j = 0; j < N; j++)
        a[round_no % N][j] = (round_no + j * 3) % 21 - 10;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            int16_t s = 0;
            for (k = 0; k < N; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }
    }

    int32_t total = 0;
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++)
            total += c[i][j];
        total += 3 * c[i][i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)total);
}
