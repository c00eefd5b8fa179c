#include "st.h"
#include <stdint.h>

enum { N = 32 };
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int scans;

void scan(void)
{
    scans++;
    if (scans == 1)
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 7 + j * 3) % 19 - 9;
                b[i][j] = (i * 5 + j * 11) % 23 - 11;
            }
    int r = scans % N;
    for (int j = 0; j < N; j++) {
        a[r][j] = (a[r][j] + j) % 50;
        b[j][r] = (b[j][r] - r) % 40;
    }
    for (int i = 0; i < N; i++) {
        int32_t row[N] = {0};
        for (int k = 0; k < N; k++) {
            int32_t f = a[i][k];
            for (int j = 0; j < N; j++)
                row[j] += f * b[k][j];
        }
        for (int j = 0; j < N; j++)
            c[i][j] = row[j];
    }
    int32_t trace = 0, total = 0;
    for (int i = 0; i < N; i++) {
        trace += c[i][i];
        for (int j = 0; j < N; j++)
            total += c[i][j];
    }
    check = (check + trace * 3 + total) % 1000000;
}
