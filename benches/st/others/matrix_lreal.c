#include "st.h"
static double a[20][20], b[20][20], c[20][20];
static int32_t scans;
void scan(void)
{
    for (int i = 0; i < 20; i++) for (int j = 0; j < 20; j++) { a[i][j] = i + j + 2; b[i][j] = i - j + scans % 8; }
    for (int i = 0; i < 20; i++)
        for (int j = 0; j < 20; j++) {
            c[i][j] = 0;
            for (int k = 0; k < 20; k++) c[i][j] += a[i][k] * b[k][j];
        }
    check += (int32_t)c[2][3] + (int32_t)c[19][19];
    scans++;
}
