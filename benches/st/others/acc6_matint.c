#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N], c[N][N];
static uint16_t n;
static bool filled;

static void multiply(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++)
                sum = (int16_t)(sum + a[i][k] * b[k][j]);
            c[i][j] = sum;
        }
}

void scan(void)
{
    int16_t trace = 0;
    int i, j;

    if (!filled) {
        filled = true;
        for (i = 1; i <= N; i++)
            for (j = 1; j <= N; j++) {
                a[i - 1][j - 1] = (int16_t)((i * 7 + j * 3) % 19 - 9);
                b[i - 1][j - 1] = (int16_t)((i * 5 - j * 11) % 23 + 2);
            }
    }
    n++;
    i = n % N;
    j = n / N % N;
    a[i][j] = (int16_t)(a[i][j] + 3);
    b[j][i] = (int16_t)(b[j][i] - 5);

    multiply();

    for (i = 0; i < N; i++)
        trace = (int16_t)(trace + c[i][i] - c[i][N - 1 - i]);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(trace + c[0][6] + 1));
}
