#include <stdint.h>
#include <math.h>
#include "st.h"

static int32_t scans;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    if (scans == 0)
        for (int i = 1; i <= 32; i++)
            for (int j = 1; j <= 32; j++) {
                a[i - 1][j - 1] = (i * j % 9) / 4.0f;
                b[i - 1][j - 1] = i == j ? 1.5f : 1.0f / (i + j);
            }
    scans++;
    a[scans % 32][scans % 31] = (scans % 50) * 0.1f;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            c[i][j] = 0;
            for (int k = 0; k < 32; k++)
                c[i][j] += a[i][k] * b[k][j];
        }
    float trace = 0;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++)
            trace += fabsf(c[i][j]);
    check = (check + (int32_t)(trace * 10.0f)) % 1000000;
}
