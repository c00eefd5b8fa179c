/* 32 x 32 matrix product in float. */
#include "st.h"
#include <stdbool.h>

static bool first = true;
static int32_t turn;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    int32_t i, j, k;
    float sum;

    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 100 - 50) * 0.1f;
                b[i][j] = (float)((i * 5 + j * 11) % 90 - 45) * 0.3f;
            }
    }

    turn = (turn + 1) % 1024;
    a[turn / 32][turn % 32] = (float)(turn % 101 - 50) * 0.1f;
    b[turn % 32][turn / 32] = (float)(turn % 91 - 45) * 0.3f;

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            sum = 0.0f;
            for (k = 0; k < 32; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    sum = 0.0f;
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++)
            sum += c[i][j];
    check = (check % 1000003) * 31 + (int32_t)sum;
}
