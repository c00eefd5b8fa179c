/* 32 x 32 matrix product in float */
#include <stdbool.h>
#include "st.h"

#define N 31

static int32_t diScan;
static bool xInit;
static float arA[32][32];
static float arB[32][32];
static float arC[32][32];

void scan(void)
{
    int32_t i, j, k;
    float rSum;

    if (!xInit) {
        xInit = true;
        for (i = 0; i <= N; i++) {
            for (j = 0; j <= N; j++) {
                arA[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.125f;
                arB[i][j] = (float)((i * 5 + j * 11) % 97 - 48) * 0.3f;
            }
        }
    }

    diScan = diScan + 1;
    i = diScan % 32;
    j = (diScan / 32) % 32;
    arA[i][j] = (float)(diScan % 1000) * 0.01f;

    for (i = 0; i <= N; i++) {
        for (j = 0; j <= N; j++) {
            rSum = 0.0f;
            for (k = 0; k <= N; k++)
                rSum += arA[i][k] * arB[k][j];
            arC[i][j] = rSum;
        }
    }

    rSum = 0.0f;
    for (i = 0; i <= N; i++)
        rSum = rSum + arC[i][N - i] + arC[i][diScan % 32] * 0.5f;
    check = check * 3 + (int32_t)rSum;
}
