#include <stdbool.h>
#include "st.h"

#define N 32
static float a[N][N], b[N][N], c[N][N];
static float gain = 1.0f;
static bool ready;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)(i + 1) * 0.125f - (float)j * 0.25f;
                b[i][j] = (float)(j + 1) * 0.0625f + (float)i * 0.03125f;
            }
        ready = true;
    }
    gain = gain * 1.01f;
    if (gain > 2.0f)
        gain = 0.5f;
    for (int i = 0; i < N; i++)
        a[i][i] = gain * (float)(i + 1);

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc = acc + a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    float trace = 0.0f;
    for (int i = 0; i < N; i++)
        trace = trace + c[i][i] - 0.5f * c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 16.0f));
}
