#include <stdbool.h>
#include "st.h"

static int16_t a[32][32], b[32][32];
static int32_t c[32][32];

static int32_t mat_mul(int16_t x[32][32], int16_t y[32][32], int32_t z[32][32])
{
    int32_t trace = 0;
    for (int i = 0; i < 32; i++) {
        for (int j = 0; j < 32; j++) {
            int32_t acc = 0;
            for (int k = 0; k < 32; k++)
                acc += (int32_t)x[i][k] * (int32_t)y[k][j];
            z[i][j] = acc;
        }
        trace += z[i][i];
    }
    return trace;
}

static int16_t row;
static bool init;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        init = true;
    }
    row = (int16_t)((row + 1) % 32);
    for (int j = 0; j < 32; j++)
        a[row][j] = (int16_t)((a[row][j] + j + 1) % 100);
    int32_t trace = mat_mul(a, b, c);
    int32_t sum = 0;
    for (int j = 0; j < 32; j++)
        sum += c[row][j] - c[j][row];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(trace + sum));
}
