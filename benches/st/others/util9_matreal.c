/* pressure sensitivity matrices of the distribution network */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int32_t scans;
static bool init;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 23 - 11) / 7.0f;
                b[i][j] = (float)(((i + 1) * 5 + (j + 1) * 11) % 19 - 9) / 9.0f;
            }
        init = true;
    }
    scans++;
    int r = scans % 32;
    a[r][N - 1 - r] = (float)(scans % 101 - 50) * 0.03f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    float trace = 0.0f;
    for (int i = 0; i < N; i++)
        trace = trace + c[i][i] + 0.5f * c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 7u + (uint32_t)(int32_t)lrintf(trace * 100.0f));
}
