#include "st.h"
#include <stdbool.h>

static bool first = true;
static int16_t cycle;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    int i, j, k;

    if (first) {
        first = false;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 19) * 0.37f - 2.5f;
                b[i][j] = (float)((i * 5 + j * 11) % 23) * 0.21f - 1.75f;
            }
    }
    for (j = 0; j < 32; j++)
        a[cycle][j] = 1.25f - a[cycle][j] * 0.9f;
    cycle = (int16_t)((cycle + 1) % 32);

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            float s = 0.0f;
            for (k = 0; k < 32; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }
    }
    for (i = 0; i < 32; i++) {
        float row_sum = 0.0f;
        for (j = 0; j < 32; j++)
            row_sum += c[i][j];
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(row_sum * 100.0f));
    }
}
