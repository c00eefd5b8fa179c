#include <stdint.h>
#include "st.h"

#define N 32
static int32_t scans;
static int16_t a[N][N], b[N][N], c[N][N];

void scan(void)
{
    scans++;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = (i + j + scans % 10) % 10;
            b[i][j] = (i * 3 + j) % 7;
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    int32_t total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            total += c[i][j];
    check = (check + total + c[3][5]) % 1000000;
}
