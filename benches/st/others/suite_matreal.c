/* Product of two 32 x 32 matrices of float. */
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int32_t step;

void scan(void)
{
    int32_t sum = 0;

    step = (step + 11) % 97;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = (float)((i * 7 + j * 3 + step) % 50) / 8.0f;
            b[i][j] = (float)((i + j * 5 + step) % 40) * 0.3f - 5.0f;
        }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            c[i][j] = 0.0f;
            for (int k = 0; k < N; k++)
                c[i][j] += a[i][k] * b[k][j];
        }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += (int32_t)c[i][j];

    check = (check * 31 + sum) % 1000003;
}
