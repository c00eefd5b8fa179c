#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool ready;
static int16_t scans;
static uint32_t crc;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 13 + j * 7) % 201 - 100;
                b[i][j] = (i * 5 + j * 11) % 151 - 75;
            }
        }
        ready = true;
    }

    scans = (scans + 1) % 1024;
    a[scans / 32][scans % 32] = scans - 500;
    b[scans % 32][scans / 32] = 300 - scans;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            crc += (uint32_t)c[i][j] * (uint32_t)(i + 2 * j + 1);
    check = (int32_t)crc;
}
