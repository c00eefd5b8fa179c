#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int k0;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.1f;
                b[i][j] = (float)((i * 5 + j * 11) % 97 - 48) * 0.1f;
            }
        ready = true;
    }
    k0 = (k0 + 1) % N;
    for (int j = 0; j < N; j++) {
        a[k0][j] = a[k0][j] * 0.75f + (float)(j - 11) * 0.3f;
        b[j][k0] = 2.0f - b[j][k0] * 0.875f + (float)k0 * 0.05f;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    uint32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum = sum * 3u + (uint32_t)(int32_t)lrintf(c[i][j] * 100.0f);
    check = (int32_t)((uint32_t)check * 31u + sum);
}
