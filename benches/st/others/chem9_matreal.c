#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

typedef float matrix[N][N];

static matrix mixing, state, result;
static bool init_done;
static int32_t scan_no;

static void mat_mul(const matrix a, const matrix b, matrix c)
{
    for (int i = 0; i < N; i++) {
        float row[N] = { 0 };
        for (int k = 0; k < N; k++) {
            float f = a[i][k];
            for (int j = 0; j < N; j++)
                row[j] += f * b[k][j];
        }
        for (int j = 0; j < N; j++)
            c[i][j] = row[j];
    }
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                int r = i + 1, c = j + 1;
                mixing[i][j] = (float)((r * 17 + c * 29) % 64) / 64.0f - 0.25f;
                state[i][j] = (float)(r * c % 31) * 0.125f;
            }
        init_done = true;
    }

    scan_no++;
    float feed = (float)(scan_no % 100) * 0.01f;
    for (int i = 0; i < N; i++)
        state[i][i] += feed;

    mat_mul(mixing, state, result);

    float peak = 0.0f, total = 0.0f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float m = fabsf(result[i][j]);
            total += result[i][j];
            if (m > peak)
                peak = m;
        }

    float scale = peak > 0.001f ? 4.0f / peak : 1.0f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            state[i][j] = result[i][j] * scale;

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + (uint32_t)(int32_t)lrintf(peak * 1000.0f);
    sum = sum * 31 + (uint32_t)(int32_t)lrintf(total * 100.0f);
    sum = sum * 31 + (uint32_t)(int32_t)lrintf(state[6][18] * 100000.0f);
    check = (int32_t)sum;
}
