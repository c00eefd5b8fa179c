/* Product of two 32 x 32 matrices in 16 bits; a row and a column change in each scan. */
#include "st.h"

#define N 32

static int32_t scan_no;
static int16_t a[N][N], b[N][N], c[N][N];

void scan(void)
{
    int row = scan_no % 32;
    for (int i = 0; i < N; i++) {
        a[row][i] = (int16_t)((scan_no * 3 + i * 5) % 17 - 8);
        b[i][row] = (int16_t)((scan_no * 7 + i * 11) % 19 - 9);
    }
    scan_no = (scan_no + 1) % 100000;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t acc = 0;
            for (int k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    int32_t sum = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            sum += c[i][j] * (i + 1);
        sum += c[i][i];
    }
    check = (check * 31 + sum) % 1000003;
}
