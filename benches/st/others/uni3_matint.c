#include <stdbool.h>
#include "st.h"

#define N 32

static bool ready;
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int16_t step;

void scan(void)
{
    int i, j, k;
    int32_t acc, trace;

    if (!ready) {
        ready = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 - j * 11) % 97;
            }
        }
    }

    /* one element changes in each scan */
    step = (step + 1) % 32;
    a[step][(step * 5) % 32] = a[step][(step * 5) % 32] % 100 + 1;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0;
            for (k = 0; k < N; k++)
                acc += (int32_t)a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    trace = 0;
    for (i = 0; i < N; i++)
        trace += c[i][i] + c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)trace);
}
