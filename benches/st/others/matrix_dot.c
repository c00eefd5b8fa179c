#include "st.h"
#include <stdint.h>

enum { N = 32 };
typedef float mat[N][N];
static mat a, b, bt, c;
static int scans;

static float dot(const float *x, const float *y)
{
    float s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    for (int k = 0; k < N; k += 4) {
        s0 += x[k] * y[k];
        s1 += x[k + 1] * y[k + 1];
        s2 += x[k + 2] * y[k + 2];
        s3 += x[k + 3] * y[k + 3];
    }
    return (s0 + s1) + (s2 + s3);
}

static void transpose(mat src, mat dst)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            dst[j][i] = src[i][j];
}

void scan(void)
{
    scans++;
    if (scans == 1)
        for (int i = 1; i <= N; i++)
            for (int j = 1; j <= N; j++) {
                a[i - 1][j - 1] = (float)((i * 3 + j * 5) % 17) * 0.125f;
                b[i - 1][j - 1] = (float)((i * 7 - j * 2) % 13) * 0.0625f;
            }
    float *r = a[scans % N];
    for (int j = 0; j < N; j++)
        r[j] = r[j] * 0.75f + (float)(j + 1) * 0.03f;
    transpose(b, bt);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            c[i][j] = dot(a[i], bt[j]);
    float sum = 0, peak = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            sum += c[i][j];
            if (c[i][j] > peak)
                peak = c[i][j];
        }
    check = (check + (int32_t)(sum * 4.0f) + (int32_t)(peak * 100.0f)) % 1000000;
}
