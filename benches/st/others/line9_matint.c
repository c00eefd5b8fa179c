/* Product of two 32 x 32 matrices of int16 with an int32 result */
#include "st.h"
#include <stdbool.h>

#define N 32

struct summary {
    int32_t trace, total, largest;
    int row, column;
};

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static struct summary result;
static bool filled;
static int cycle;

static int32_t row_times_column(int row, int column, int16_t x[N][N], int16_t y[N][N])
{
    int32_t sum = 0;
    for (int k = 0; k < N; k++)
        sum += x[row][k] * y[k][column];
    return sum;
}

static void multiply(int16_t x[N][N], int16_t y[N][N], int32_t z[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            z[i][j] = row_times_column(i, j, x, y);
}

static void summarize(int32_t z[N][N], struct summary *out)
{
    struct summary s = { .largest = z[0][0] };
    for (int i = 0; i < N; i++) {
        s.trace += z[i][i];
        for (int j = 0; j < N; j++) {
            s.total += z[i][j];
            if (z[i][j] > s.largest) {
                s.largest = z[i][j];
                s.row = i;
                s.column = j;
            }
        }
    }
    *out = s;
}

static void add_check(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    if (!filled) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 37 + j * 11) % 201 - 100);
                b[i][j] = (int16_t)((i * 13 + j * 29) % 301 - 150);
            }
        }
        filled = true;
    }

    cycle = (cycle + 1) % 1000;
    int row = cycle % 32, column = cycle % 31;
    for (int j = 0; j < N; j++) {
        a[row][j] = (int16_t)((a[row][j] + cycle + j) % 500);
        b[j][column] = (int16_t)((b[j][column] - cycle - j) % 500);
    }

    multiply(a, b, c);
    summarize(c, &result);
    add_check(result.trace);
    add_check(result.total);
    add_check(result.largest);
    add_check(result.row * 32 + result.column);
}
