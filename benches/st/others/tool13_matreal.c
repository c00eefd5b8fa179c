#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int cycle;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)(i - j) * 0.125f;
                b[i][j] = (float)(i + j) * 0.1f - 3.0f;
            }
        ready = true;
    }

    int p = cycle % N;
    for (int i = 0; i < N; i++) {
        a[i][p] = a[i][p] * 0.9f + (float)(i + cycle) * 0.01f;
        b[p][i] = (float)i * 0.3f - b[p][i] * 0.8f;
    }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    int32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += (int32_t)(c[i][j] * 100.0f);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
    cycle = (cycle + 1) % 1000;
}
