/* product of two 32 x 32 REAL matrices with sparse rows; the result is scaled and partly fed back */
#include <stdbool.h>
#include "st.h"

#define N 32

typedef float matrix[N][N];

static uint32_t seed = 0x00C0FFEE;
static matrix a, b, c;

static inline float uniform(uint32_t *s)
{
    uint32_t x = *s;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    *s = x;
    return (float)((int)(x & 0x3FF) - 512) / 512.0f;
}

static int16_t multiply(matrix a, matrix b, matrix c)
{
    int16_t used = 0;
    for (int i = 0; i < N; i++) {
        float *restrict out = c[i];
        for (int j = 0; j < N; j++)
            out[j] = 0.0f;
        for (int k = 0; k < N; k++) {
            float f = a[i][k];
            if (f == 0.0f)
                continue;
            used++;
            const float *restrict in = b[k];
            for (int j = 0; j < N; j++)
                out[j] = out[j] + f * in[j];
        }
    }
    return used;
}

static float row_max(const float *row)
{
    float best = 0.0f;
    for (int j = 0; j < N; j++) {
        float v = row[j] < 0.0f ? -row[j] : row[j];
        if (v > best)
            best = v;
    }
    return best;
}

void scan(void)
{
    static bool started;

    if (!started) {
        started = true;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                b[i][j] = uniform(&seed);
                float x = uniform(&seed);
                if (x > -0.6f)
                    a[i][j] = x;
            }
    }

    for (int i = 0; i < N; i++) {
        float x = uniform(&seed);
        int j = (int)((x + 1.0f) * 15.5f);
        a[i][j] = x < -0.5f ? 0.0f : x;
    }

    int16_t used = multiply(a, b, c);

    float trace = 0.0f;
    for (int i = 0; i < N; i++) {
        float x = row_max(c[i]);
        float scale = 1.0f;
        while (x > 1.0f) {
            x *= 0.5f;
            scale *= 0.5f;
        }
        if (x > 0.75f) {
            for (int j = 0; j < N; j++)
                b[i][j] = c[i][j] * scale;
        } else {
            for (int j = 0; j < N; j++)
                b[i][j] = 0.5f * b[i][j] + 0.25f;
        }
        for (int j = 0; j < N; j++)
            trace += c[i][j] * scale;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(trace * 100.0f) + used));
}
