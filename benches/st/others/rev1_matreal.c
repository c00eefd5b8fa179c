/* 32 x 32 matrix product in REAL. */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool first = true;
static int16_t row;
static float shift;

void scan(void)
{
    if (first) {
        first = false;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 41 - 20) / 16.0f;
                b[i][j] = (float)((i * 5 + j * 11) % 37 - 18) / 10.0f;
            }
        }
    }

    /* one row of a changes in every scan */
    row = (int16_t)((row + 1) % 32);
    shift = shift * 0.5f + (float)row / 8.0f;
    for (int j = 0; j < N; j++)
        a[row][j] = a[row][j] * 0.75f + shift - (float)j * 0.125f;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    float trace = 0.0f, largest = 0.0f;
    for (int i = 0; i < N; i++) {
        trace += c[i][i];
        for (int j = 0; j < N; j++) {
            if (c[i][j] > largest) largest = c[i][j];
        }
    }
    check = (check * 31 + (int32_t)(trace * 16.0f) + (int32_t)(largest * 100.0f)) % 1000003;
}
