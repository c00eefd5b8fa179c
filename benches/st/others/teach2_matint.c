/* Example 4: Matrix product of integers, 32 x 32. */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N];
static int16_t b[N][N];
static int32_t c[N][N];
static int16_t cycle;
static bool ready;

void scan(void)
{
    int i, j, k;
    int32_t sum, trace;
    uint32_t chk = (uint32_t)check;

    /* fill the matrices once */
    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (int16_t)(((i + 1) * 7 + (j + 1) * 3) % 101 - 50);
                b[i][j] = (int16_t)(((i + 1) * 5 + (j + 1) * 11) % 97 - 48);
            }
        }
        ready = true;
    }

    /* a new row of measured values in each cycle */
    cycle = (int16_t)((cycle + 1) % 1000);
    i = cycle % N;
    for (j = 0; j < N; j++)
        a[i][j] = (int16_t)((cycle + (j + 1) * 13) % 127 - 63);

    /* c = a * b */
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0;
            for (k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
    }

    /* trace and a weighted sum as result */
    trace = 0;
    for (i = 0; i < N; i++)
        trace += c[i][i];
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++)
            chk += (uint32_t)c[i][j] * (uint32_t)(i + 1 + 2 * (j + 1));
    }
    check = (int32_t)(chk * 31u + (uint32_t)trace);
}
