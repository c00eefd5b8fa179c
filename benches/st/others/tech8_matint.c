#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool initialised;
static int line;

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = ((i + 1) * 7 + (j + 1) * 3) % 100 - 50;
                b[i][j] = ((i + 1) * 5 - (j + 1) * 11) % 90;
            }
    }
    for (int k = 0; k < N; k++) {
        a[line][k] = (a[line][k] + k + 1) % 500;
        b[k][line] = (b[k][line] * 3 + line + 1) % 700;
    }
    line = (line + 1) % N;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += (int32_t)a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    uint32_t trace = 0, sum = 0;
    for (int i = 0; i < N; i++) {
        trace += c[i][i];
        for (int j = 0; j < N; j++)
            sum += c[i][j];
    }
    check = (int32_t)((uint32_t)check * 31u + trace + 3u * sum);
}
