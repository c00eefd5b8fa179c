#include "st.h"
#include <stdbool.h>

enum { N = 32 };

typedef int16_t matrix[N][N];

static matrix a, b, c;
static bool initialised;
static int row;

static void multiply(const matrix left, const matrix right, matrix product)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++)
                sum = (int16_t)(sum + left[i][k] * right[k][j]);
            product[i][j] = sum;
        }
    }
}

void scan(void)
{
    if (!initialised) {
        for (int i = 1; i <= N; i++) {
            for (int j = 1; j <= N; j++) {
                a[i - 1][j - 1] = (int16_t)((i * 7 + j * 3) % 19 - 9);
                b[i - 1][j - 1] = (int16_t)((i * 5 + j * 11) % 23 - 11);
            }
        }
        initialised = true;
    }

    multiply(a, b, c);

    int16_t trace = 0;
    for (int i = 0; i < N; i++) {
        trace = (int16_t)(trace + c[i][i]);
        a[row][i] = c[row][i] % 100;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(trace + c[row][N - 1 - row]));
    row = (row + 1) % N;
}
