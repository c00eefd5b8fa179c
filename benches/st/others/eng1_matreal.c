/* 32 x 32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int16_t nscan;
static bool init;

void scan(void)
{
    int i, j, k;
    float sum, trace;

    if (!init) {
        for (i = 0; i < N; i++)
            for (j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.25f;
                b[i][j] = (float)((i * 5 + j * 11) % 97 - 48) * 0.1f;
            }
        init = true;
    }

    /* one new element each scan */
    nscan = (nscan + 1) % 1024;
    a[nscan / 32][nscan % 32] = (float)(nscan % 89 - 44) * 0.125f;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            sum = 0.0f;
            for (k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    trace = 0.0f;
    for (i = 0; i < N; i++)
        trace = trace + c[i][i] + c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (int32_t)(trace * 10.0f) + (int32_t)(c[nscan / 32][nscan % 32] * 100.0f));
}
