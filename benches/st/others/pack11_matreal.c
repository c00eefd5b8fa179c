/* 32 x 32 matrix product in float: one row of A is measured anew in each scan */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool initialised;
static int32_t scan_no;
static int row;

static void matmul(float a[N][N], float b[N][N], float c[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
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
                a[i][j] = (float)((i * 7 + j * 3) % 101) * 0.01f;
                b[i][j] = (float)((i * 5 + j * 11) % 97) * 0.013f;
            }
        }
    }

    scan_no = (scan_no + 1) % 10000;
    for (int j = 0; j < N; j++)
        a[row][j] = (float)((scan_no * 13 + j * 7) % 101) * 0.01f;
    row = (row + 1) % N;

    matmul(a, b, c);

    uint32_t sum = 0;
    for (int i = 0; i < N; i++) {
        float r = 0.0f;
        for (int j = 0; j < N; j++)
            r += c[i][j];
        sum = sum * 7u + (uint32_t)lrintf(r * 100.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
