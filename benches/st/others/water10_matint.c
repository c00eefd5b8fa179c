#include <stdbool.h>
#include "st.h"

#define NODES 32

static int16_t coupling[NODES][NODES], load[NODES][NODES];
static int32_t balance[NODES][NODES];
static bool initialised;
static int scan_no;

static void mat_mul(const int16_t a[NODES][NODES], const int16_t b[NODES][NODES], int32_t c[NODES][NODES])
{
    for (int row = 0; row < NODES; row++)
        for (int col = 0; col < NODES; col++) {
            uint32_t acc = 0;
            for (int k = 0; k < NODES; k++)
                acc += (uint32_t)(a[row][k] * b[k][col]);
            c[row][col] = (int32_t)acc;
        }
}

static inline void add(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int r = 0; r < NODES; r++)
            for (int c = 0; c < NODES; c++) {
                coupling[r][c] = (int16_t)(((r + 1) * 7 + (c + 1) * 13) % 101 - 50);
                load[r][c] = (int16_t)(((r + 1) * 11 - (c + 1) * 5) % 97);
            }
    }

    int16_t *row = load[scan_no % NODES];
    for (int c = 0; c < NODES; c++) {
        int v = row[c] + (c + 1) - 16;
        if (v > 3000 || v < -3000)
            v = c + 1;
        row[c] = (int16_t)v;
    }
    if (++scan_no >= 3200)
        scan_no = 0;

    mat_mul(coupling, load, balance);

    uint32_t trace = 0;
    for (int r = 0; r < NODES; r++) {
        trace += (uint32_t)balance[r][r];
        uint32_t row_sum = 0;
        for (int c = 0; c < NODES; c++)
            row_sum += (uint32_t)balance[r][c];
        add(row_sum);
    }
    add(trace);
}
