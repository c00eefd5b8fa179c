#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool ready;
static int cycle;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 3 + j * 5) % 97 - 40;
                b[i][j] = (i * 7 + j * 2) % 89 - 50;
            }
        ready = true;
    }

    int p = cycle % N;
    for (int i = 0; i < N; i++) {
        a[i][p] = (a[i][p] + i + cycle) % 100;
        b[p][i] = (b[p][i] + 3 * i + cycle) % 100;
    }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    uint32_t total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            total += (uint32_t)c[i][j] * (uint32_t)(i + 2 * j + 1);
    check = (int32_t)((uint32_t)check * 31u + total);
    cycle = (cycle + 1) % 1000;
}
