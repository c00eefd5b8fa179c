/* 32 x 32 matrix product: int16_t factors, int32_t result. */
#include "st.h"
#include <stdbool.h>

static bool first = true;
static int32_t turn;
static int16_t a[32][32], b[32][32];
static int32_t c[32][32];

void scan(void)
{
    int32_t i, j, k, sum;

    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 100 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 90 - 45);
            }
    }

    turn = (turn + 1) % 1024;
    a[turn / 32][turn % 32] = (int16_t)(turn % 101 - 50);
    b[turn % 32][turn / 32] = (int16_t)(turn % 91 - 45);

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            sum = 0;
            for (k = 0; k < 32; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }

    sum = 0;
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++)
            sum += c[i][j];
    check = (check % 1000003) * 31 + sum;
}
