#include "st.h"
#include <xmmintrin.h>
#define N 32
static float a[N][N], b[N][N], c[N][N];
static int32_t scans;

void scan(void)
{
    scans++;
    for (int r = 0; r < N; r++)
        for (int k = 0; k < N; k++) {
            a[r][k] = (scans + (r + 1) * 3 + k + 1) % 17 * 0.25f - 2.0f;
            b[r][k] = (scans + (r + 1) + (k + 1) * 5) % 13 * 0.5f - 3.0f;
        }
    for (int r = 0; r < N; r++)
        for (int k = 0; k < N; k++) {
            float sum = 0;
            for (int i = 0; i < N; i++)
                sum += a[r][i] * b[i][k];
            c[r][k] = sum;
        }
    float trace = 0;
    float total = 0;
    for (int r = 0; r < N; r++) {
        trace += c[r][r];
        for (int k = 0; k < N; k++)
            total += c[r][k];
    }
    check = (check + _mm_cvt_ss2si(_mm_set_ss(total)) * 3 + _mm_cvt_ss2si(_mm_set_ss(trace))) % 1000000;
}
