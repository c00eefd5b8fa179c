/* Chapter 7: arrays. Calibration matrix of the multihead weigher, 32 x 32 REAL. */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool first = true;
static float gain[N][N];
static float load[N][N];
static float weight[N][N];
static int16_t row;

void scan(void)
{
    int i, j, k;
    float acc, trace, total;

    if (first) {
        first = false;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                gain[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 19) * 0.05f;
                load[i][j] = (float)(((i + 1) * 5 + (j + 1) * 13) % 23) * 0.125f - 1.0f;
            }
        }
    }

    /* one head was tared again */
    for (j = 0; j < N; j++)
        gain[row][j] = gain[row][j] * 0.75f + (float)(j + 1) * 0.01f;
    row++;
    if (row >= N)
        row = 0;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0.0f;
            for (k = 0; k < N; k++)
                acc += gain[i][k] * load[k][j];
            weight[i][j] = acc;
        }
    }

    trace = 0.0f;
    total = 0.0f;
    for (i = 0; i < N; i++) {
        trace += weight[i][i];
        for (j = 0; j < N; j++)
            total += weight[i][j];
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 1000.0f)
            + (uint32_t)(int32_t)(total * 100.0f));
}
