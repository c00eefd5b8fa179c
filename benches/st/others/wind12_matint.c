#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static int step;
static bool init_done;

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (i * 13 + j * 7) % 101 - 50;
                b[i][j] = (i * 5 + j * 11) % 89 - 44;
            }
        init_done = true;
    }

    step = (step + 1) % 1000;
    for (int i = 0; i < N; i++) {
        a[i][(i + step) % N] = step - 500 + i;
        b[(i * 3 + step) % N][i] = 300 - step;
    }

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t acc = 0;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    uint32_t trace = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            trace = trace * 3 + c[i][j];
    check = (int32_t)((uint32_t)check * 31u + trace);
}
