/* Influence matrix of 32 fans on 32 sections times the measured values:
   32 x 32 product of int16 matrices, summed in int32. */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init_done;
static int16_t a[N][N];
static int16_t b[N][N];
static int32_t c[N][N];
static int row;             /* 0 before the first scan, then 1..N */
static int16_t offset;

static void init(void)
{
    for (int i = 1; i <= N; i++) {
        for (int j = 1; j <= N; j++) {
            a[i - 1][j - 1] = (int16_t)((i * 7 + j * 3) % 101 - 50);
            b[i - 1][j - 1] = (int16_t)((i * 5 + j * 11) % 97 - 48);
        }
    }
}

void scan(void)
{
    if (!init_done) {
        init();
        init_done = true;
    }

    /* One row of new measurements a scan */
    row++;
    if (row > N) {
        row = 1;
        offset = (int16_t)((offset + 13) % 64);
    }
    for (int j = 0; j < N; j++) {
        a[row - 1][j] = (int16_t)((a[row - 1][j] + offset + (j + 1)) % 200);
        b[j][row - 1] = (int16_t)((b[j][row - 1] * 3 + offset - (j + 1)) % 150);
    }

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int32_t acc = 0;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    uint32_t sum = 17;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum = sum * 31u + (uint32_t)c[i][j];
    check = (int32_t)sum;
}
