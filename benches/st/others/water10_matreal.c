#include <math.h>
#include <stdbool.h>
#include "st.h"

#define ZONES 32

typedef float matrix[ZONES][ZONES];

static matrix influence, state, pressure;
static bool ready;
static int zone;

static void mat_mul(const matrix left, const matrix right, matrix result)
{
    for (int i = 0; i < ZONES; i++)
        for (int j = 0; j < ZONES; j++) {
            float sum = 0.0f;
            for (int k = 0; k < ZONES; k++)
                sum += left[i][k] * right[k][j];
            result[i][j] = sum;
        }
}

static inline void add(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int i = 0; i < ZONES; i++)
            for (int j = 0; j < ZONES; j++) {
                influence[i][j] = 1.0f / (float)(i + j + 1);
                state[i][j] = (float)((i * 3 + j * 5) % 17) * 0.25f;
            }
    }

    mat_mul(influence, state, pressure);

    float *s = state[zone];
    const float *p = pressure[zone];
    for (int j = 0; j < ZONES; j++) {
        s[j] = 0.9f * s[j] + 0.05f * p[j] + 0.01f * (float)j;
        if (s[j] > 10.0f)
            s[j] = 0.5f;
    }
    zone = (zone + 1) % ZONES;

    for (int i = 0; i < ZONES; i++) {
        float mean = 0.0f, high = pressure[i][0];
        for (int j = 0; j < ZONES; j++) {
            mean += pressure[i][j];
            if (pressure[i][j] > high)
                high = pressure[i][j];
        }
        mean /= 32.0f;
        add((int32_t)lrintf(mean * 1000.0f));
        add((int32_t)(high * 100.0f));
    }
}
