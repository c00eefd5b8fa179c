/* Example 5: Matrix product of float, 32 x 32. */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N];
static float b[N][N];
static float c[N][N];
static int16_t cycle;
static bool ready;

void scan(void)
{
    int i, j, k;
    float sum, trace, total;

    /* fill the matrices once */
    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 101) * 0.02f - 1.0f;
                b[i][j] = (float)(((i + 1) * 5 + (j + 1) * 11) % 97) * 0.02f - 1.0f;
            }
        }
        ready = true;
    }

    /* a new row of measured values in each cycle */
    cycle = (int16_t)((cycle + 1) % 1000);
    i = cycle % N;
    for (j = 0; j < N; j++)
        a[i][j] = (float)((cycle + (j + 1) * 13) % 127) * 0.015f - 0.95f;

    /* c = a * b */
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0.0f;
            for (k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    /* trace and the sum of the absolute values as result */
    trace = 0.0f;
    total = 0.0f;
    for (i = 0; i < N; i++) {
        trace += c[i][i];
        for (j = 0; j < N; j++)
            total += c[i][j] < 0.0f ? -c[i][j] : c[i][j];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 1000.0f)
                      + (uint32_t)(int32_t)(total * 100.0f));
}
