#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static uint16_t n;
static bool filled;

static void multiply(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

void scan(void)
{
    float trace = 0.0f;
    int i, j;

    if (!filled) {
        filled = true;
        for (i = 1; i <= N; i++)
            for (j = 1; j <= N; j++) {
                a[i - 1][j - 1] = (float)((i * 7 + j * 3) % 19 - 9) * 0.37f;
                b[i - 1][j - 1] = (float)((i * 5 - j * 11) % 23 + 2) / 3.0f;
            }
    }
    n++;
    i = n % N;
    j = n / N % N;
    a[i][j] += 0.03f;
    b[j][i] -= 0.7f;

    multiply();

    for (i = 0; i < N; i++)
        trace = trace + c[i][i] - c[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(trace * 100.0f) + (int32_t)(c[0][6] * 10.0f) + 1));
}
