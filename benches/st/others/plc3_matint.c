#include <stdbool.h>
#include "st.h"

static int16_t n;
static bool init;
static int16_t a[32][32], b[32][32];
static int32_t c[32][32];

void scan(void)
{
    int16_t i, j, k;
    int32_t sum, trace;

    if (!init) {
        for (i = 0; i < 32; i++)
            for (j = 0; j < 32; j++) {
                a[i][j] = (i * 7 + j * 3) % 101 - 50;
                b[i][j] = (i * 5 + j * 11) % 97 - 48;
            }
        init = true;
    }

    n++;
    if (n >= 1000)
        n = 0;
    for (i = 0; i < 32; i++)
        a[i][n % 32] = (n + i) % 200 - 100;

    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++) {
            sum = 0;
            for (k = 0; k < 32; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }

    trace = 0;
    for (i = 0; i < 32; i++)
        trace += c[i][i] - c[i][31 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)trace);
}
