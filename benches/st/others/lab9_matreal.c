/* Mm after Stanford, 32 x 32 of float, flat, loops in the order i k j (saxpy on rows). */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t seed = 74755;
static float ma[N * N], mb[N * N], mr[N * N];
static bool first = true;
static int32_t row;

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

static void Initmatrix(float *m)
{
    int32_t i;

    for (i = 0; i < N * N; i++)
        m[i] = (float)(Rand() % 121 - 60) / 3.0f;
}

void scan(void)
{
    int32_t i, j, k;
    float t, s;

    if (first) {
        first = false;
        Initmatrix(ma);
        Initmatrix(mb);
    }
    /* new data in one row of each */
    for (j = 0; j < N; j++) {
        ma[row * N + j] = (float)(Rand() % 121 - 60) / 3.0f;
        mb[row * N + j] = (float)(Rand() % 121 - 60) / 3.0f;
    }
    row = (row + 1) % N;

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++)
            mr[i * N + j] = 0.0f;
        for (k = 0; k < N; k++) {
            t = ma[i * N + k];
            for (j = 0; j < N; j++)
                mr[i * N + j] = mr[i * N + j] + t * mb[k * N + j];
        }
    }

    s = 0.0f;
    for (i = 0; i < N * N; i++)
        s = s + fabsf(mr[i]) * 0.125f;
    for (i = 0; i < N; i++)
        s = s + mr[i * N + i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(s * 16.0f));
}
