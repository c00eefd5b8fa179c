/* Product of two 32 x 32 matrices of REAL; a row of a and a column of b are new in each scan. */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

static float a[32][32], b[32][32], c[32][32];
static int32_t seed = 1;
static bool started;
static int turn;

void scan(void)
{
    if (!started) {
        started = true;
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.125f;
                b[i][j] = (float)((i * 5 + j * 11) % 97 - 48) / 7.0f;
            }
    }

    for (int i = 0; i < 32; i++) {
        seed = (seed * 75 + 74) % 65537;
        a[turn][i] = (float)(seed % 2001 - 1000) / 100.0f;
        b[i][turn] = (float)(seed - 32768) * 0.0003f;
    }
    turn = (turn + 1) % 32;

    float top = 0.0f;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            float s = 0.0f;
            for (int k = 0; k < 32; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
            top = s > top ? s : top;
        }

    for (int i = 0; i < 32; i++) {
        int32_t w = 0;
        for (int j = 0; j < 32; j++)
            w += (int32_t)(c[i][j] * 16.0f) * (j + 1);
        check = (check * 31 + abs(w)) % 1000003;
    }
    check = (check * 31 + (int32_t)(top * 100.0f)) % 1000003;
}
