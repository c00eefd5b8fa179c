/* Product of two 32 x 32 matrices of REAL, element by element as the product
   of a row and a column. */
#include <stdbool.h>
#include "st.h"

#define N 32

typedef float RealMatrix[N][N];

typedef struct {
    float trace;
    float maximum;
    float total;
} Statistics;

static float row_times_column(RealMatrix factor_a, RealMatrix factor_b, int row, int column)
{
    float sum = 0.0f;
    for (int k = 0; k < N; k++)
        sum += factor_a[row][k] * factor_b[k][column];
    return sum;
}

static void compute_statistics(Statistics *s, RealMatrix matrix)
{
    s->trace = 0.0f;
    s->total = 0.0f;
    s->maximum = matrix[0][0];
    for (int i = 0; i < N; i++) {
        s->trace += matrix[i][i];
        for (int j = 0; j < N; j++) {
            s->total += matrix[i][j];
            if (matrix[i][j] > s->maximum)
                s->maximum = matrix[i][j];
        }
    }
}

static RealMatrix a, b, c;
static Statistics statistics;
static bool initialised;
static int32_t scan_count;

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 5 + j * 3) % 17) * 0.1f - 0.7f;
                b[i][j] = (float)((i * 7 + j * 11) % 19) * 0.05f - 0.4f;
            }
        }
        initialised = true;
    }

    /* One row of the first matrix changes in every scan. */
    scan_count++;
    int changing = scan_count % N;
    for (int j = 0; j < N; j++)
        a[changing][j] = (float)((scan_count * 13 + j) % 23) * 0.07f - 0.8f;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            c[i][j] = row_times_column(a, b, i, j);
    }

    compute_statistics(&statistics, c);
    check = (check * 31
             + (int32_t)(statistics.trace * 1000.0f)
             + (int32_t)(statistics.maximum * 1000.0f)
             + (int32_t)(statistics.total * 100.0f)) % 1000003;
}
