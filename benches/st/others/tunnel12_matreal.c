/* Air flow network: 32 x 32 product of float matrices. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init_done;
static float a[N][N];
static float b[N][N];
static float c[N][N];
static int row;             /* 0 before the first scan, then 1..N */
static int scan_no;

static void init(void)
{
    for (int i = 1; i <= N; i++) {
        for (int j = 1; j <= N; j++) {
            a[i - 1][j - 1] = (float)((i * 7 + j * 3) % 101) * 0.01f;
            b[i - 1][j - 1] = (float)((i * 5 + j * 11) % 97) * 0.02f - 0.5f;
        }
    }
}

void scan(void)
{
    if (!init_done) {
        init();
        init_done = true;
    }

    /* One row and one column follow the measurements a scan */
    row++;
    if (row > N)
        row = 1;
    scan_no = (scan_no + 1) % 1000;
    for (int j = 0; j < N; j++) {
        a[row - 1][j] = a[row - 1][j] * 0.75f + (float)((scan_no + (j + 1) * 5) % 50) * 0.01f;
        b[j][row - 1] = 0.9f - b[j][row - 1] * 0.5f;
        if (b[j][row - 1] > 0.62f)
            b[j][row - 1] -= 0.41f;
    }

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    uint32_t sum = 17;
    for (int i = 0; i < N; i++) {
        float row_sum = 0.0f;
        for (int j = 0; j < N; j++)
            row_sum += c[i][j];
        sum = sum * 31u + (uint32_t)(int32_t)lrintf(row_sum * 1000.0f);
    }
    check = (int32_t)sum;
}
