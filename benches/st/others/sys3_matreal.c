#include "st.h"
#include <stdbool.h>

static float a[32][32], b[32][32], c[32][32];
static bool ready;
static int32_t step;

void scan(void)
{
    int32_t i, j, k, total;
    float sum;

    if (!ready) {
        ready = true;
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 40 - 20) * 0.125f;
                b[i][j] = (float)((i * 5 + j * 11) % 30 - 15) * 0.1f;
            }
    }
    step = (step + 1) % 32;
    a[step][31 - step] = (float)(check % 100) * 0.05f;
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            sum = 0.0f;
            for (k = 0; k < 32; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    total = 0;
    for (i = 0; i < 32; i++)
        total += (int32_t)(c[i][i] * 100.0f) + (int32_t)(c[i][31 - i] * 10.0f);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)total);
}
