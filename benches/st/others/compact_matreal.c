#include "st.h"
#include <math.h>
#define N 32

static float a[N][N], b[N][N], c[N][N];
static uint32_t seed = 7;

void scan(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            seed = seed * 1103515245u + 12345u;
            a[i][j] = (float)(seed / 65536 % 1024) / 1024.0f;
            seed = seed * 1103515245u + 12345u;
            b[i][j] = (float)(seed / 65536 % 1024) / 512.0f - 1.0f;
            c[i][j] = 0.0f;
        }
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            float f = a[i][k];
            for (int j = 0; j < N; j++)
                c[i][j] += f * b[k][j];
        }
    float sum = 0.0f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += fabsf(c[i][j]);
    check = (check + (int32_t)(sum * 10.0f)) % 1000000;
}
