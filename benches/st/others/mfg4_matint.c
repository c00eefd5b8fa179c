#include <stdbool.h>
#include "st.h"

#define N 32
typedef int16_t Matrix[N][N];

static Matrix ma, mb, mc;
static int16_t scans;
static bool initialised;

static void matmul(Matrix a, Matrix b, Matrix c)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++)
                sum = (int16_t)(sum + a[i][k] * b[k][j]);
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
                ma[i][j] = (int16_t)((i * 7 + j * 3) % 41 - 20);
                mb[i][j] = (int16_t)((i * 5 + j * 11) % 37 - 18);
            }
        }
    }
    scans++;
    for (int i = 0; i < N; i++) {
        ma[i][(i + scans) % N] = (int16_t)(scans + i);
        mb[(i * 3 + scans) % N][i] = (int16_t)(scans - i * 2);
    }
    matmul(ma, mb, mc);

    uint32_t trace = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            trace += (uint32_t)mc[i][j];
        trace *= 3u;
    }
    check = (int32_t)((uint32_t)check * 31u + trace + 1u);
}
