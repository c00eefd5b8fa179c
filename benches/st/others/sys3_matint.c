#include "st.h"
#include <stdbool.h>

static int16_t a[32][32], b[32][32];
static int32_t c[32][32];
static bool ready;
static int32_t step;

void scan(void)
{
    int32_t i, j, k, sum;

    if (!ready) {
        ready = true;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 200 - 100);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 150 - 75);
            }
    }
    step = (step + 1) % 32;
    a[step][31 - step] = (int16_t)(check % 100);
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
            sum += c[i][j] % 1000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
