/* Product of two 32 x 32 matrices of INT; a row of a and a column of b are new in each scan. */
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

static int16_t a[32][32], b[32][32];
static int32_t c[32][32];
static int32_t seed = 1;
static bool started;
static int turn;

static inline int32_t limit(int32_t lo, int32_t x, int32_t hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

void scan(void)
{
    if (!started) {
        started = true;
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 + j * 11) % 97 - 48;
            }
    }

    for (int i = 0; i < 32; i++) {
        seed = (seed * 75 + 74) % 65537;
        a[turn][i] = seed % 101 - 50;
        b[i][turn] = seed / 101 % 101 - 50;
    }
    turn = (turn + 1) % 32;

    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            int32_t s = 0;
            for (int k = 0; k < 32; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = limit(-20000, s, 20000);
        }

    for (int i = 0; i < 32; i++) {
        int32_t s = 0;
        for (int j = 0; j < 32; j++)
            s += c[i][j] * (j + 1);
        check = (check * 31 + abs(s)) % 1000003;
    }
}
