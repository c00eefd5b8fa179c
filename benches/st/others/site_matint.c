/* Product of two 32 x 32 matrices of INT. */
#include <stdbool.h>
#include "st.h"

#define N 32

typedef struct {
    int16_t rows, cols;
    bool valid;
    int16_t el[N][N];
} matrix_t;

static matrix_t gain, inp, outp;
static bool init;
static int16_t scan_no;

static bool mat_mul(const matrix_t *restrict a, const matrix_t *restrict b, matrix_t *restrict c)
{
    if (!a->valid || !b->valid || a->cols != b->rows) {
        c->valid = false;
        return false;
    }
    for (int row = 0; row < a->rows; row++)
        for (int col = 0; col < b->cols; col++) {
            int16_t acc = 0;
            for (int k = 0; k < a->cols; k++)
                acc += a->el[row][k] * b->el[k][col];
            c->el[row][col] = acc;
        }
    c->rows = a->rows;
    c->cols = b->cols;
    c->valid = true;
    return true;
}

static int32_t trace(const matrix_t *m)
{
    int32_t t = 0;
    for (int i = 0; i < m->rows; i++)
        t += m->el[i][i];
    return t;
}

void scan(void)
{
    if (!init) {
        init = true;
        gain.rows = gain.cols = inp.rows = inp.cols = N;
        for (int r = 0; r < N; r++)
            for (int c = 0; c < N; c++) {
                gain.el[r][c] = (r * 5 + c * 3) % 23 - 11;
                inp.el[r][c] = (r * 7 + c * 11) % 29 - 14;
            }
        gain.valid = inp.valid = true;
    }

    scan_no = (scan_no + 1) % 1000;
    for (int c = 0; c < N; c++) {
        gain.el[scan_no % 32][c] = (scan_no + c) % 25 - 12;
        inp.el[c][scan_no % 31] = (scan_no * 3 + c) % 27 - 13;
    }

    uint32_t sum = 0;
    if (mat_mul(&gain, &inp, &outp))
        for (int r = 0; r < N; r++)
            for (int c = 0; c < N; c++)
                sum = sum * 3 + (uint32_t)outp.el[r][c];
    check = (int32_t)((uint32_t)check * 5 + sum + (uint32_t)trace(&outp));
}
