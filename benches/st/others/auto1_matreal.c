/* 32 x 32 matrix product in float, row by row */
#include "st.h"
#include <stdbool.h>

#define N 32

static bool init_done;
static int32_t scan_no;
static float a[N][N], b[N][N], c[N][N];

void scan(void)
{
    int i, j, k;
    float aik, trace, sum;

    if (!init_done) {
        init_done = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.1f;
                b[i][j] = (float)((i * 5 + j * 11) % 97 - 48) * 0.05f;
            }
        }
    }
    scan_no = (scan_no + 1) % 1000;
    a[scan_no % 32][(scan_no * 5) % 32] = (float)(scan_no % 89) * 0.125f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++)
            c[i][j] = 0.0f;
        for (k = 0; k < N; k++) {
            aik = a[i][k];
            for (j = 0; j < N; j++)
                c[i][j] = c[i][j] + aik * b[k][j];
        }
    }

    trace = 0.0f;
    sum = 0.0f;
    for (i = 0; i < N; i++) {
        trace += c[i][i];
        sum += c[scan_no % 32][i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 8.0f) + (uint32_t)(int32_t)(sum * 4.0f));
}
