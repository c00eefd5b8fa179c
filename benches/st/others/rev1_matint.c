/* 32 x 32 matrix product: INT factors, DINT sums. */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool first = true;
static int16_t row;

void scan(void)
{
    if (first) {
        first = false;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 41 - 20);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 37 - 18);
            }
        }
    }

    /* one row of a changes in every scan */
    row = (int16_t)((row + 1) % 32);
    for (int j = 0; j < N; j++)
        a[row][j] = (int16_t)((a[row][j] * 3 + j) % 100);

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
    }

    int32_t trace = 0, total = 0;
    for (int i = 0; i < N; i++) {
        trace += c[i][i];
        for (int j = 0; j < N; j++)
            total += c[i][j];
    }
    check = (check * 31 + trace + total % 1000) % 1000003;
}
