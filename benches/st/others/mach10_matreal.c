#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float coupling[N][N], correction[N][N], ink[N][N];
static bool ready;
static int row;

static void mat_mul(float a[N][N], float b[N][N], float c[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) c[i][j] = 0.0f;
        for (int k = 0; k < N; k++) {
            float factor = a[i][k];
            for (int j = 0; j < N; j++)
                c[i][j] += factor * b[k][j];
        }
    }
}

static void prepare(float width)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float d = fabsf((float)(i - j)) / width;
            coupling[i][j] = 1.0f / (1.0f + d * d);
            correction[i][j] = (float)(((i + 1) * 7 + (j + 1) * 13) % 29 - 14) * 0.125f;
        }
}

static float limit(float lo, float v, float hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    if (!ready) {
        prepare(3.5f);
        ready = true;
    }
    mat_mul(coupling, correction, ink);

    for (int j = 0; j < N; j++)
        correction[row][j] = limit(-4.0f, correction[row][j] - ink[row][j] * 0.05f + 0.01f, 4.0f);
    if (++row >= N) row = 0;

    float trace = 0.0f, peak = 0.0f;
    for (int i = 0; i < N; i++) {
        float sum = 0.0f;
        trace += ink[i][i];
        for (int j = 0; j < N; j++) sum += ink[i][j];
        if (sum > peak) peak = sum;
    }
    add((int32_t)(trace * 1000.0f));
    add((int32_t)(peak * 1000.0f));
}
