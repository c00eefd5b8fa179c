/* 32 x 32 matrix product in int32_t: one row of A is measured anew in each scan */
#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t a[N][N], b[N][N], c[N][N];
static bool initialised;
static int32_t scan_no;
static int row;

static void matmul(int32_t a[N][N], int32_t b[N][N], int32_t c[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 + j * 11) % 97 - 48;
            }
        }
    }

    scan_no = (scan_no + 1) % 10000;
    for (int j = 0; j < N; j++)
        a[row][j] = (scan_no * 13 + j * 7) % 101 - 50;
    row = (row + 1) % N;

    matmul(a, b, c);

    int32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += c[i][j] * (1 + (i + j) % 4);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
