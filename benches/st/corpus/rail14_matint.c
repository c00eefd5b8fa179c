#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool ready;
static int k0;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        ready = true;
    }
    k0 = (k0 + 1) % N;
    for (int j = 0; j < N; j++) {
        a[k0][j] = (int16_t)((a[k0][j] + j + 3) % 200);
        b[j][k0] = (int16_t)((b[j][k0] + k0 + j) % 150);
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t acc = 0;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    uint32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum = sum * 3u + (uint32_t)c[i][j];
    check = (int32_t)((uint32_t)check * 31u + sum);
}
