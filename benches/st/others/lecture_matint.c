/* Product of two 32 x 32 matrices of INT. */
#include <stdbool.h>
#include "st.h"

#define N 32

typedef int16_t IntMatrix[N][N];

static void multiply_matrices(IntMatrix factor_a, IntMatrix factor_b, IntMatrix product)
{
    for (int row = 0; row < N; row++) {
        for (int column = 0; column < N; column++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += (int32_t)factor_a[row][k] * factor_b[k][column];
            product[row][column] = (int16_t)sum;
        }
    }
}

static int32_t weighted_sum(IntMatrix matrix)
{
    int32_t sum = 0;
    for (int row = 0; row < N; row++) {
        for (int column = 0; column < N; column++) {
            if (column > row)
                sum -= matrix[row][column];
            else
                sum += 3 * matrix[row][column];
        }
    }
    return sum;
}

static IntMatrix a, b, c;
static bool initialised;
static int32_t scan_count;

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 5 + j * 3) % 17 - 8;
                b[i][j] = (i * 7 + j * 11) % 19 - 9;
            }
        }
        initialised = true;
    }

    /* One row of the first matrix changes in every scan. */
    scan_count++;
    int changing = scan_count % N;
    for (int j = 0; j < N; j++)
        a[changing][j] = (scan_count * 13 + j) % 23 - 11;

    multiply_matrices(a, b, c);
    check = (check * 31 + weighted_sum(c)) % 1000003;
}
