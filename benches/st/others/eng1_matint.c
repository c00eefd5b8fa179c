/* 32 x 32 matrix product: 16-bit factors, 32-bit result */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int16_t nscan;
static bool init;

void scan(void)
{
    int i, j, k;
    int32_t sum, trace;

    if (!init) {
        for (i = 0; i < N; i++)
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 + j * 11) % 97 - 48;
            }
        init = true;
    }

    /* one new element each scan */
    nscan = (nscan + 1) % 1024;
    a[nscan / 32][nscan % 32] = nscan % 89 - 44;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            sum = 0;
            for (k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    trace = 0;
    for (i = 0; i < N; i++)
        trace += c[i][i] + c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + trace + c[nscan / 32][nscan % 32]);
}
