/* 32 x 32 matrix product, int16_t elements, int32_t result */
#include "st.h"
#include <stdbool.h>

static int16_t a[32][32], b[32][32];
static int32_t c[32][32];
static bool ready;
static int16_t tick;

void scan(void)
{
    int16_t i, j, k;
    int32_t trace;

    if (!ready) {
        for (i = 0; i < 32; i++) {
            for (j = 0; j < 32; j++) {
                a[i][j] = (i * 7 + j * 3) % 41 - 20;
                b[i][j] = (i * 5 + j * 11) % 37 - 18;
            }
        }
        ready = true;
    }

    /* a new measured row every scan */
    tick = (tick + 1) % 32;
    for (j = 0; j < 32; j++)
        a[tick][j] = (a[tick][j] + j + 1) % 50;

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            c[i][j] = 0;
            for (k = 0; k < 32; k++)
                c[i][j] += (int32_t)a[i][k] * b[k][j];
        }
    }

    trace = 0;
    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            if (i == j)
                trace += c[i][j];
            else
                trace += c[i][j] / 8;
        }
    }

    check = (check + trace) % 10000019;
}
