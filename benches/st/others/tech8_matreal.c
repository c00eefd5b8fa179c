#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float left[N][N], right[N][N], product[N][N];
static bool initialised;
static int line;

static void multiply(float a[N][N], float b[N][N], float c[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

static float max_norm(float m[N][N])
{
    float largest = 0.0f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            if (fabsf(m[i][j]) > largest)
                largest = fabsf(m[i][j]);
    return largest;
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                left[i][j] = (float)(i - j) / 8.0f;
                right[i][j] = (float)(i + 1 + 2 * (j + 1)) / 50.0f;
            }
    }
    multiply(left, right, product);
    float norm = max_norm(product);
    float trace = 0.0f;
    for (int i = 0; i < N; i++)
        trace += product[i][i];
    if (norm > 0.0f)
        for (int j = 0; j < N; j++)
            left[line][j] = product[line][j] / norm + (float)(j - line) / 16.0f;
    line = (line + 1) % N;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(norm * 1000.0f)
                      + (uint32_t)(int32_t)lrintf(trace * 100.0f));
}
