#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t multiply(int16_t a[N][N], int16_t b[N][N], int32_t c[N][N])
{
    int32_t trace = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
        trace += c[i][i];
    }
    return trace;
}

static int16_t left[N][N], right[N][N];
static int32_t product[N][N];
static int16_t row;
static bool init_done;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                left[i][j] = (int16_t)((i * 7 + j * 3) % 41 - 20);
                right[i][j] = (int16_t)((i * 5 + j * 11) % 37 - 18);
            }
        }
        init_done = true;
    }

    row = (int16_t)((row + 1) % N);
    for (int j = 0; j < N; j++)
        left[row][j] = (int16_t)((left[row][j] + j + 1) % 1000);

    check += multiply(left, right, product);
    for (int j = 0; j < N; j++)
        check += product[row][j] - product[j][N - 1 - j];
}
