/* 32 x 32 matrix product, INT in, DINT out */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int16_t row;
static bool ready;

void scan(void)
{
    int16_t i, j, k;
    int32_t sum, trace;

    if (!ready) {
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 41 - 20;
                b[i][j] = (i * 5 + j * 11) % 37 - 18;
            }
        }
        ready = true;
    }

    /* one new row of measurements per scan */
    row = (row + 1) % 32;
    for (j = 0; j < N; j++)
        a[row][j] = (a[row][j] + j + 1) % 50;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            sum = 0;
            for (k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
    }

    trace = 0;
    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            if (i == j)
                trace += 3 * c[i][j];
            else
                trace += c[i][j];
        }
    }
    check = (check + trace) % 1000003;
}
