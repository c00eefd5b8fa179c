/* 32 x 32 matrix product, int16 elements, int32 sums */
#include <stdbool.h>
#include "st.h"

#define N 31

static int32_t diScan;
static bool xInit;
static int16_t aiA[32][32];
static int16_t aiB[32][32];
static int32_t adiC[32][32];

void scan(void)
{
    int32_t i, j, k, diSum;

    if (!xInit) {
        xInit = true;
        for (i = 0; i <= N; i++) {
            for (j = 0; j <= N; j++) {
                aiA[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                aiB[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        }
    }

    diScan = diScan + 1;
    i = diScan % 32;
    j = (diScan / 32) % 32;
    aiA[i][j] = (int16_t)(diScan % 1000);

    for (i = 0; i <= N; i++) {
        for (j = 0; j <= N; j++) {
            diSum = 0;
            for (k = 0; k <= N; k++)
                diSum += (int32_t)aiA[i][k] * (int32_t)aiB[k][j];
            adiC[i][j] = diSum;
        }
    }

    for (i = 0; i <= N; i++)
        check = check * 3 + adiC[i][N - i] + adiC[i][diScan % 32];
}
