#include "st.h"
#include <xmmintrin.h>
#define N 32
static int16_t a[N][N], b[N][N], c[N][N];
static int32_t scans;

void scan(void)
{
    scans++;
    for (int r = 0; r < N; r++)
        for (int k = 0; k < N; k++) {
            a[r][k] = (scans + (r + 1) * 3 + k + 1) % 17 - 8;
            b[r][k] = (scans + (r + 1) + (k + 1) * 5) % 13 - 6;
        }
    for (int r = 0; r < N; r++)
        for (int k = 0; k < N; k++) {
            int16_t sum = 0;
            for (int i = 0; i < N; i++)
                sum += a[r][i] * b[i][k];
            c[r][k] = sum;
        }
    int16_t trace = 0;
    int32_t total = 0;
    for (int r = 0; r < N; r++) {
        trace += c[r][r];
        for (int k = 0; k < N; k++)
            total += c[r][k];
    }
    check = (check + total * 3 + trace) % 1000000;
}
