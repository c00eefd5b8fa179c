#include "st.h"
#include <math.h>
#include <stdbool.h>

#define N 32

static float state[N][N], model[N][N], next[N][N];
static bool ready;
static int shift;

static void mat_mul(float a[N][N], float b[N][N], float c[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

static void add_check(float v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)lrintf(v));
}

void scan(void)
{
    if (!ready) {
        for (int r = 0; r < N; r++)
            for (int c = 0; c < N; c++) {
                int i = r + 1, j = c + 1;
                state[r][c] = (float)((i * 5 + j * 3) % 17 - 8) * 0.125f;
                model[r][c] = (float)((i * 7 + j * 11) % 23 - 11) * 0.05f;
            }
        ready = true;
    }

    mat_mul(model, state, next);

    float largest = 0.0f, trace = 0.0f, total = 0.0f;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float v = next[i][j];
            total += v;
            if (fabsf(v) > largest)
                largest = fabsf(v);
        }
        trace += next[i][i];
    }
    add_check(largest * 1000.0f);
    add_check(trace * 100.0f);
    add_check(total * 100.0f);

    float scale = largest > 0.001f ? 1.0f / largest : 1.0f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            state[i][j] = next[i][j] * scale;
    state[shift][shift] += 0.5f;
    shift = (shift + 1) % N;
}
