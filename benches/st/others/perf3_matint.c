/* The product of two 32 x 32 matrices of 16 bits; a row of one changes in each scan */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N], c[N][N];
static bool ready;
static int row;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)(i * 7 - j * 3);
                b[i][j] = (int16_t)(i * j % 101 - 50);
            }
        ready = true;
    }
    for (int j = 0; j < N; j++)
        a[row][j] = (int16_t)(a[row][j] + b[j][row] + 1);
    row = (row + 1) % N;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++)
                sum = (int16_t)(sum + a[i][k] * b[k][j]);
            c[i][j] = sum;
        }

    int32_t total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            total += (int16_t)(c[i][j] * (i + 1));
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(total + c[row][5]) + 1u);
}
