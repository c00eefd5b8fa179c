/* The same work as matrix_int.st. */
#include "st.h"

static int16_t a[32][32], b[32][32], c[32][32];
static int32_t scans;

void scan(void)
{
    int32_t row = scans % 32;
    for (int32_t column = 0; column < 32; column++) {
        a[row][column] = (int16_t)((row * 7 + column * 3 + scans) % 11);
        b[row][column] = (int16_t)((row * 5 - column + scans) % 13);
    }
    for (row = 0; row < 32; row++)
        for (int32_t column = 0; column < 32; column++) {
            int16_t sum = 0;
            for (int32_t k = 0; k < 32; k++)
                sum = (int16_t)(sum + a[row][k] * b[k][column]);
            c[row][column] = sum;
        }
    row = scans % 32;
    for (int32_t column = 0; column < 32; column++)
        check += c[row][column];
    scans++;
}
