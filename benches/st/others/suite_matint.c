/* Product of two 32 x 32 matrices of 16 bit integers. */
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N], c[N][N];
static int step;

void scan(void)
{
    int32_t sum = 0, trace = 0;

    step = (step + 7) % 101;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = ((i + 1) * (j + 1) + step) % 61 - 30;
            b[i][j] = (3 * (i + 1) + 5 * (j + 1) + step) % 59 - 29;
        }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t acc = 0;

            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    for (int i = 0; i < N; i++) {
        trace += c[i][i];
        for (int j = 0; j < N; j++)
            sum += c[i][j];
    }

    check = (check * 31 + sum + 7 * trace) % 1000003;
}
