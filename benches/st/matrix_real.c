/* The same work as matrix_real.st. */
#include "st.h"

static float a[32][32], b[32][32], c[32][32];
static int32_t scans;

void scan(void)
{
    int32_t row = scans % 32;
    for (int32_t column = 0; column < 32; column++) {
        a[row][column] = (float)((row * 7 + column * 3 + scans) % 11);
        b[row][column] = (float)((row * 5 - column + scans) % 13);
    }
    for (row = 0; row < 32; row++)
        for (int32_t column = 0; column < 32; column++) {
            float sum = 0;
            for (int32_t k = 0; k < 32; k++)
                sum += a[row][k] * b[k][column];
            c[row][column] = sum;
        }
    row = scans % 32;
    for (int32_t column = 0; column < 32; column++)
        check += (int32_t)c[row][column];
    scans++;
}
