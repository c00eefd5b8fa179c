#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static bool init_done;
static int32_t scan_no;
static float a[N][N], b[N][N], c[N][N], norm[N];

static void add(float v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)lrintf(v));
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.02f;
                b[i][j] = (float)((i * 5 + j * 11) % 89 - 44) * 0.025f;
            }
        }
        init_done = true;
    }

    int row = scan_no % 32;
    for (int k = 0; k < N; k++) {
        a[row][k] = 0.9f * a[row][k] + (float)(k - row) * 0.01f;
        b[k][row] = 0.95f * b[k][row] - (float)(k - 15) * 0.003f;
    }
    scan_no = (scan_no + 1) % 1000000;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    float trace = 0.0f, biggest = 0.0f;
    for (int i = 0; i < N; i++) {
        float sum = 0.0f;
        for (int j = 0; j < N; j++) {
            sum += c[i][j];
            if (fabsf(c[i][j]) > biggest)
                biggest = fabsf(c[i][j]);
        }
        norm[i] = sum;
        trace += c[i][i];
        add(norm[i] * 1000.0f);
    }
    add(trace * 1000.0f);
    add(biggest * 1000.0f);
}
