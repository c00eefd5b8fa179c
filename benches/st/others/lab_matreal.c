/* 32 x 32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init;
static float ma[N][N], mb[N][N], mc[N][N];
static int16_t phase;

void scan(void)
{
    int row, col, k;
    float acc, trace;

    if (!init) {
        init = true;
        for (row = 0; row < N; row++) {
            for (col = 0; col < N; col++) {
                ma[row][col] = (float)(((row + 1) * 13 + (col + 1) * 7) % 29) / 8.0f - 1.5f;
                mb[row][col] = (float)(((row + 1) * 3 + (col + 1) * 17) % 31) / 16.0f - 0.75f;
            }
        }
    }

    phase++;
    if (phase > N)
        phase = 1;
    ma[phase - 1][phase - 1] = ma[phase - 1][phase - 1] * 0.5f + 0.25f;

    for (row = 0; row < N; row++) {
        for (col = 0; col < N; col++) {
            acc = 0.0f;
            for (k = 0; k < N; k++)
                acc += ma[row][k] * mb[k][col];
            mc[row][col] = acc;
        }
    }

    trace = 0.0f;
    for (row = 0; row < N; row++)
        for (col = 0; col < N; col++)
            trace = trace * 0.9f + mc[row][col];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 1000.0f));
}
