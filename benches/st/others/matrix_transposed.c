#include <stdint.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N], bt[N][N];
static int c[N][N];
static int scans;

static void transpose(int16_t m[N][N], int16_t t[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            t[j][i] = m[i][j];
}

static int multiply(int16_t a[N][N], int16_t bt[N][N], int c[N][N])
{
    int trace = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            int sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * bt[j][k];
            c[i][j] = sum;
        }
        trace += c[i][i];
    }
    return trace;
}

void scan(void)
{
    if (scans == 0)
        for (int i = 1; i <= N; i++)
            for (int j = 1; j <= N; j++) {
                a[i - 1][j - 1] = (i * 7 + j * 3) % 19 - 9;
                b[i - 1][j - 1] = (i * 5 + j * 11) % 17 - 8;
            }
    scans++;
    a[scans % 32][scans % 29] = scans % 23 - 11;
    b[scans % 29][scans % 32] = scans % 13 - 6;

    transpose(b, bt);
    int sum = multiply(a, bt, c);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += c[i][j] > 0 ? c[i][j] : -2 * c[i][j];
    check = (check * 31 + sum) % 1000003;
}
