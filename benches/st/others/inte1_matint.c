/* 32x32 matrix product, int16 factors, int32 result */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init;
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int32_t n;

void scan(void)
{
    int i, j, k;
    int32_t sum, trace;

    if (!init) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 41 - 20;
                b[i][j] = (i * 5 + j * 11) % 37 - 18;
            }
        }
        init = true;
    }

    /* one new sample per scan */
    n++;
    i = n % 32;
    j = (n / 32) % 32;
    a[i][j] = n % 101 - 50;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0;
            for (k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    trace = 0;
    for (i = 0; i < N; i++)
        trace += c[i][i] + c[i][N - 1 - i] * 3;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)trace);
}
