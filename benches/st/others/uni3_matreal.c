#include <stdbool.h>
#include "st.h"

#define N 32

static bool ready;
static float a[N][N], b[N][N], c[N][N];
static int16_t step;

void scan(void)
{
    int i, j, k;
    float acc, trace;

    if (!ready) {
        ready = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (float)(i - j) * 0.125f + 0.3f;
                b[i][j] = (float)((i * 3 + j) % 17) * 0.0625f - 0.4f;
            }
        }
    }

    /* one element changes in each scan */
    step = (step + 1) % 32;
    a[step][31 - step] = 0.9f * a[step][31 - step] + 0.1f;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0.0f;
            for (k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    trace = 0.0f;
    for (i = 0; i < N; i++)
        trace = trace + c[i][i] - 0.5f * c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 1000.0f));
}
