/* influence matrices of the distribution network, in litres */
#include <stdbool.h>
#include "st.h"

#define N 32

static int32_t a[N][N], b[N][N], c[N][N];
static int32_t scans;
static bool init;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = ((i + 1) * 7 + (j + 1) * 3) % 23 - 11;
                b[i][j] = ((i + 1) * 5 + (j + 1) * 11) % 19 - 9;
            }
        init = true;
    }
    scans++;
    int r = scans % 32;
    a[r][N - 1 - r] = scans % 101 - 50;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    int32_t trace = 0;
    for (int i = 0; i < N; i++)
        trace += c[i][i] + 3 * c[i][N - 1 - i];
    b[r][4] = trace % 100;
    check = (int32_t)((uint32_t)check * 7u + (uint32_t)trace);
}
