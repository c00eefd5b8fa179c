#include <stdbool.h>
#include <math.h>
#include <xmmintrin.h>
#include "st.h"

/* Rounds to the nearest, halves to even (no libm here, so no lrintf). */
static int32_t real_to_dint(float x)
{
    return _mm_cvtss_si32(_mm_set_ss(x));
}

#define N 32

static float matrix_product(float a[N][N], float b[N][N], float c[N][N])
{
    float largest = 0.0f;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
            if (fabsf(sum) > largest)
                largest = fabsf(sum);
        }
    }
    return largest;
}

static float state[N][N], model[N][N], next[N][N];
static bool init_done;
static int16_t step;

void scan(void)
{
    if (!init_done) {
        for (int i = 1; i <= N; i++) {
            for (int j = 1; j <= N; j++) {
                model[i - 1][j - 1] = (float)((i * 13 + j * 7) % 29 - 14) * 0.125f;
                state[i - 1][j - 1] = (float)((i * 3 + j * 17) % 31 - 15) * 0.0625f;
            }
        }
        init_done = true;
    }

    float largest = matrix_product(state, model, next);

    float factor = 0.0f;
    if (largest > 0.0f)
        factor = 1.0f / largest;
    step = (int16_t)((step + 1) % N);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            state[i][j] = next[i][j] * factor;
        state[i][step] += 0.25f;
    }

    check += real_to_dint(largest * 100.0f);
    for (int i = 0; i < N; i++)
        check += real_to_dint(state[i][N - 1 - i] * 1000.0f);
}
