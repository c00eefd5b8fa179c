#include <stdbool.h>
#include "st.h"

#define N 32

static bool init_done;
static int32_t scan_no;
static int16_t a[N][N], b[N][N];
static int32_t c[N][N];

static void add(uint32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + v);
}

void scan(void)
{
    if (!init_done) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 89 - 44);
            }
        }
        init_done = true;
    }

    int row = scan_no % 32;
    int col = scan_no * 5 % 31;
    for (int k = 0; k < N; k++) {
        a[row][k] = (int16_t)(a[row][k] + k - 9);
        b[k][col] = (int16_t)(b[k][col] - k * 3 + 1);
    }
    scan_no = (scan_no + 1) % 1000000;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            uint32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += (uint32_t)((int32_t)a[i][k] * b[k][j]);
            c[i][j] = (int32_t)sum;
        }
    }

    uint32_t trace = 0;
    int32_t max_val = c[0][0];
    for (int i = 0; i < N; i++) {
        uint32_t row_sum = 0;
        for (int j = 0; j < N; j++) {
            row_sum += (uint32_t)c[i][j];
            if (c[i][j] > max_val)
                max_val = c[i][j];
        }
        trace += (uint32_t)c[i][i];
        add(row_sum);
    }
    add(trace);
    add((uint32_t)max_val);
}
