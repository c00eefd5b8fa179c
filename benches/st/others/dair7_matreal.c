#include "st.h"
#include <math.h>

#define N 32
enum state { MAT_INIT, MAT_RUN };
static enum state state;
static float share[N][N], flow[N][N], mix[N][N];
static int scans;

static void fill(float m[N][N], int mul_row, int mul_col)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            m[i][j] = (float)((i * mul_row + j * mul_col) % 29) * 0.125f - 1.3f;
}

static void multiply(float a[N][N], float b[N][N], float c[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            c[i][j] = 0.0f;
        for (int k = 0; k < N; k++) {
            float factor = a[i][k];
            for (int j = 0; j < N; j++)
                c[i][j] += factor * b[k][j];
        }
    }
}

void scan(void)
{
    switch (state) {
    case MAT_INIT:
        fill(share, 3, 5);
        fill(flow, 7, 2);
        state = MAT_RUN;
        break;
    case MAT_RUN:
        scans = (scans + 1) % 320;
        int row = scans % N;
        for (int i = 0; i < N; i++)
            flow[row][i] = flow[row][i] * 0.9f + (float)(scans - i) * 0.01f;
        multiply(share, flow, mix);
        float trace = 0.0f, sum = 0.0f;
        for (int i = 0; i < N; i++) {
            trace += mix[i][i];
            sum += mix[row][i];
        }
        check = (int32_t)((uint32_t)check * 5u + (uint32_t)lrintf(trace * 100.0f) + (uint32_t)lrintf(sum * 10.0f));
        break;
    }
}
