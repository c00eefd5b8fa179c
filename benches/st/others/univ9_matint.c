#include "st.h"
#include <stdbool.h>

#define N 32

static int16_t left[N][N], right[N][N];
static int32_t product[N][N];
static int32_t row_sum[N];
static bool ready;
static int active;

static void multiply(int16_t a[N][N], int16_t b[N][N], int32_t r[N][N])
{
    for (int row = 0; row < N; row++)
        for (int col = 0; col < N; col++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[row][k] * b[k][col];
            r[row][col] = sum;
        }
}

static void add_check(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

void scan(void)
{
    if (!ready) {
        for (int row = 0; row < N; row++)
            for (int col = 0; col < N; col++) {
                left[row][col] = (int16_t)((row * 7 + col * 13) % 41 - 20);
                right[row][col] = (int16_t)((row * 11 + col * 5) % 37 - 18);
            }
        ready = true;
    }

    multiply(left, right, product);

    int32_t trace = 0, largest = product[0][0];
    for (int row = 0; row < N; row++) {
        int32_t sum = 0;
        for (int col = 0; col < N; col++) {
            int32_t v = product[row][col];
            sum += v;
            if (v > largest)
                largest = v;
        }
        row_sum[row] = sum;
        trace += product[row][row];
    }

    add_check(trace);
    add_check(largest);
    for (int row = 0; row < N; row++)
        add_check(row_sum[row]);

    for (int col = 0; col < N; col++) {
        left[active][col] = (int16_t)(product[active][col] % 50);
        right[col][active] = (int16_t)(product[col][active] % 60);
    }
    active = (active + 1) % N;
}
