#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t calib[N][N];
static int16_t sample[N][N];
static int32_t product[N][N];
static bool init_done;
static uint32_t seed = 99;
static int32_t scan_no;

static inline uint32_t next(void)
{
    seed = seed * 1103515245u + 12345u;
    return seed >> 16;
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                calib[i][j] = (int16_t)((int)(next() % 2001) - 1000);
                sample[i][j] = (int16_t)((i * 7 - j * 5) % 113);
            }
        init_done = true;
    }

    int row = scan_no++ % N;
    for (int j = 0; j < N; j++)
        sample[row][j] = (int16_t)((int)(next() % 4096) - 2048);

    /* |sum| <= 32 * 1000 * 2048, no overflow */
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t acc = 0;
            for (int k = 0; k < N; k++)
                acc += calib[i][k] * sample[k][j];
            product[i][j] = acc;
        }

    uint32_t sum = (uint32_t)check;
    uint32_t trace = 0;
    int32_t highest = product[0][0];
    for (int i = 0; i < N; i++) {
        trace += (uint32_t)product[i][i];
        uint32_t row_sum = 0;
        for (int j = 0; j < N; j++) {
            row_sum += (uint32_t)product[i][j];
            if (product[i][j] > highest)
                highest = product[i][j];
        }
        sum = sum * 31 + row_sum;
    }
    sum = sum * 31 + trace;
    check = (int32_t)(sum * 31 + (uint32_t)highest);
}
