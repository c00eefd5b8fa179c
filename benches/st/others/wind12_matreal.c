#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float y[N][N], v[N][N], p[N][N];
static int step;
static bool init_done;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                y[i][j] = (float)(((i + 1) * 17 + (j + 1) * 3) % 53) * 0.02f - 0.5f;
                v[i][j] = (float)(((i + 1) * 7 + (j + 1) * 19) % 47) * 0.03f - 0.7f;
            }
        init_done = true;
    }

    step = (step + 1) % 500;
    for (int i = 0; i < N; i++) {
        y[i][(i + 1 + step) % N] = (float)step * 0.004f - 1.0f;
        v[i][((i + 1) * 5 + step) % N] = 1.0f - (float)(step + i + 1) * 0.0025f;
    }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += y[i][k] * v[k][j];
            p[i][j] = acc;
        }

    uint32_t c = (uint32_t)check;
    for (int i = 0; i < N; i++) {
        float row = 0.0f;
        for (int j = 0; j < N; j++)
            row += p[i][j] * (float)(j + 1);
        c = c * 7 + (uint32_t)(int32_t)lrintf(row * 100.0f);
    }
    check = (int32_t)c;
}
