#include <stdbool.h>
#include "st.h"

#define N 32
typedef float Matrix[N][N];

static Matrix ma, mb, mc;
static int scans;
static bool initialised;

static void matmul(const Matrix a, const Matrix b, Matrix c)
{
    for (int i = 0; i < N; i++) {
        float row[N] = {0};
        for (int k = 0; k < N; k++) {
            float x = a[i][k];
            for (int j = 0; j < N; j++)
                row[j] += x * b[k][j];
        }
        for (int j = 0; j < N; j++)
            c[i][j] = row[j];
    }
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                ma[i][j] = (float)((i * 7 + j * 3) % 41 - 20) * 0.125f;
                mb[i][j] = (float)((i * 5 + j * 11) % 37 - 18) * 0.3f;
            }
        }
    }
    scans++;
    for (int i = 0; i < N; i++) {
        ma[i][(i + scans) % N] = (float)(scans % 100 + i) * 0.01f;
        mb[(i * 3 + scans) % N][i] = (float)(scans % 77 - i) * 0.07f;
    }
    matmul(ma, mb, mc);

    float sum = 0.0f;
    for (int i = 0; i < N; i++)
        sum = sum * 0.5f + mc[i][i] + mc[i][N - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 100.0f) + 1u);
}
