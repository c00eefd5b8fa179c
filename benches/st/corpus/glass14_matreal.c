/* Influence matrix of the heating zones: c = a * b */
#include "st.h"
#include <stdbool.h>

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int tick;

static void init(void)
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            a[i][j] = (float)((i * 3 + j * 5) % 15) * 0.25f;
            b[i][j] = (float)((i * 7 + j * 2) % 13) * 0.5f - 3.0f;
        }
    }
    ready = true;
}

void scan(void)
{
    if (!ready)
        init();

    tick = (tick + 1) % 1000;
    a[tick % N][(tick * 5) % N] = (float)(tick % 15) * 0.3f;
    b[(tick * 3) % N][tick % N] = (float)(tick % 13) * 0.7f - 4.1f;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    uint32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum = sum * 3u + (uint32_t)(int32_t)(c[i][j] * 8.0f);
    check = (int32_t)((uint32_t)check * 31u + sum);
}
