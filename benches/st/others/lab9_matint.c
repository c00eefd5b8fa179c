/* Intmm after Stanford, 32 x 32, flat, b transposed before the inner products. */
#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t seed = 74755;
static int32_t ma[N * N], mb[N * N], mt[N * N], mr[N * N];
static bool first = true;
static int32_t row;

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

static void Initmatrix(int32_t *m)
{
    int32_t i, t;

    for (i = 0; i < N * N; i++) {
        t = Rand();
        m[i] = t - (t / 120) * 120 - 60;
    }
}

void scan(void)
{
    int32_t i, j, k, s;

    if (first) {
        first = false;
        Initmatrix(ma);
        Initmatrix(mb);
    }
    /* new data in one row of a and one column of b */
    for (j = 0; j < N; j++) {
        ma[row * N + j] = Rand() % 121 - 60;
        mb[j * N + row] = Rand() % 121 - 60;
    }
    row = (row + 1) % N;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            mt[j * N + i] = mb[i * N + j];

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            s = 0;
            for (k = 0; k < N; k++)
                s = s + ma[i * N + k] * mt[j * N + k];
            mr[i * N + j] = s;
        }
    }

    s = 0;
    for (i = 0; i < N * N; i++)
        s = s + mr[i] * (i % 7 + 1);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)s);
}
