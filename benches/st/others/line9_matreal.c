/* Product of two 32 x 32 matrices of float: calibration of a sensor field */
#include "st.h"
#include <stdbool.h>
#include <math.h>

#define N 32

static float field[N][N], calibration[N][N], corrected[N][N];
static bool prepared;
static int row;
static int cycle;

static void matmul(float left[N][N], float right[N][N], float product[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += left[i][k] * right[k][j];
            product[i][j] = sum;
        }
    }
}

static float trace(float m[N][N])
{
    float sum = 0.0f;
    for (int i = 0; i < N; i++)
        sum += m[i][i];
    return sum;
}

static float max_of(const float *v)
{
    float best = v[0];
    for (int j = 1; j < N; j++)
        if (v[j] > best)
            best = v[j];
    return best;
}

static void update_measurement(float *v, float offset)
{
    for (int j = 0; j < N; j++)
        v[j] = v[j] * 0.75f + offset + (float)(j + 1) * 0.03125f;
}

static void add_check(float v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(v));
}

void scan(void)
{
    if (!prepared) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                field[i][j] = (float)(((i + 1) * 7 + (j + 1) * 5) % 23) * 0.25f;
                calibration[i][j] = (float)(((i + 1) * 3 + (j + 1) * 11) % 19 - 9) * 0.1f;
                if (i == j)
                    calibration[i][j] += 1.0f;
            }
        }
        prepared = true;
    }

    cycle = (cycle + 1) % 50;
    update_measurement(field[row], (float)cycle * 0.02f);
    matmul(field, calibration, corrected);
    add_check(trace(corrected) * 10.0f);
    add_check(max_of(corrected[row]) * 100.0f);
    add_check(corrected[N - 1 - row][row] * 1000.0f);
    row = (row + 1) % N;
}
