/* Chapter 7: arrays. Lane-to-lane correlation of counts as a 32 x 32 matrix product. */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool first = true;
static int16_t a[N][N];
static int16_t b[N][N];
static int32_t c[N][N];
static int16_t row;

void scan(void)
{
    int i, j, k;
    int32_t acc, trace, total;

    if (first) {
        first = false;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = ((i + 1) * 17 + (j + 1) * 5) % 201 - 100;
                b[i][j] = ((i + 1) * 11 + (j + 1) * 23) % 151 - 75;
            }
        }
    }

    /* fresh counts for one lane */
    for (j = 0; j < N; j++)
        a[row][j] = (a[row][j] + (j + 1) * 3) % 100;
    row++;
    if (row >= N)
        row = 0;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0;
            for (k = 0; k < N; k++)
                acc += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = acc;
        }
    }

    trace = 0;
    total = 0;
    for (i = 0; i < N; i++) {
        trace += c[i][i];
        for (j = 0; j < N; j++)
            total += c[i][j];
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)trace * 3u + (uint32_t)total);
}
