/* Product of two 32 x 32 matrices of REAL, a matrix-vector product and a limited state vector. */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N], x[N], y[N];
static bool started;
static int16_t scan_no;

static inline float limit(float lo, float v, float hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

void scan(void)
{
    if (!started) {
        started = true;
        for (int i = 0; i < N; i++) {
            x[i] = (float)(i + 1) * 0.125f;
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)(((i + 1) * 3 + (j + 1) * 7) % 19 - 9) * 0.1f;
                b[i][j] = (float)(((i + 1) * 11 + (j + 1) * 5) % 17 - 8) * 0.05f;
            }
        }
    }

    scan_no = (scan_no + 1) % 500;
    a[scan_no % 32][scan_no % 29] = (float)scan_no * 0.01f - 2.5f;
    b[scan_no % 31][scan_no % 32] = 1.5f - (float)scan_no * 0.005f;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    float total = 0.0f;
    for (int i = 0; i < N; i++) {
        float acc = 0.0f;
        for (int j = 0; j < N; j++)
            acc += c[i][j] * x[j];
        y[i] = acc;
        total += acc;
    }
    for (int i = 0; i < N; i++)
        x[i] = limit(-10.0f, x[i] * 0.9f + y[i] * 0.05f, 10.0f);

    check = (int32_t)((uint32_t)check * 7u + (uint32_t)(int32_t)(total * 100.0f)
                      + (uint32_t)(int32_t)(c[scan_no % 32][N - 1] * 1000.0f));
}
