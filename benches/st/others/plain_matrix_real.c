#include <stdint.h>
#include <xmmintrin.h>
#include "st.h"

/* REAL_TO_DINT: round to nearest, even (lrintf without libm) */
static int32_t to_dint(float x) { return _mm_cvtss_si32(_mm_set_ss(x)); }

#define N 32
static int32_t scans;
static float a[N][N], b[N][N], c[N][N];

void scan(void)
{
    scans++;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = (i + j) * 0.5f + scans % 10;
            b[i][j] = (i - j) * 0.25f;
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    float total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            total += c[i][j];
    check = (check + to_dint(total) + to_dint(c[7][9])) % 1000000;
}
