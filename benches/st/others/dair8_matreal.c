/* Product of two 32 x 32 matrices of float: recipe matrix times ingredient matrix */
#include <stdbool.h>
#include <math.h>
#include "st.h"

#define SIZE 32

static float recipe[SIZE][SIZE], content[SIZE][SIZE], product[SIZE][SIZE];
static bool ready;
static int cycle;

static void mat_mul(const float a[SIZE][SIZE], const float b[SIZE][SIZE], float result[restrict SIZE][SIZE])
{
    for (int row = 0; row < SIZE; row++) {
        for (int col = 0; col < SIZE; col++) {
            float acc = 0.0f;
            for (int k = 0; k < SIZE; k++)
                acc += a[row][k] * b[k][col];
            result[row][col] = acc;
        }
    }
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                recipe[i][j] = (float)((i * 7 + j * 3) % 41 - 20) * 0.125f;
                content[i][j] = (float)((i * 5 + j * 11) % 37 - 18) / 7.0f;
            }
        }
        ready = true;
    }

    float *r = &recipe[cycle][cycle * 3 % SIZE];
    float *c = &content[cycle * 5 % SIZE][cycle];
    *r = *r * 0.95f + 0.1f;
    *c = *c * 0.9f - 0.2f;

    mat_mul(recipe, content, product);

    float trace = 0.0f;
    for (int i = 0; i < SIZE; i++)
        trace = trace * 0.75f + product[i][i] - product[i][SIZE - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)lrintf(trace * 1000.0f)
        + (uint32_t)(int32_t)(product[cycle][7] * 100.0f));
    cycle = (cycle + 1) % SIZE;
}
