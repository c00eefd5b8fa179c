/* Product of two 32 x 32 matrices in float; a row and a column change in each scan. */
#include "st.h"

#define N 32

static int32_t scan_no;
static float a[N][N], b[N][N], c[N][N];

void scan(void)
{
    int row = scan_no % 32;
    for (int i = 0; i < N; i++) {
        a[row][i] = (float)((scan_no * 3 + i * 5) % 17 - 8) * 0.37f;
        b[i][row] = (float)((scan_no * 7 + i * 11) % 19 - 9) * 0.61f;
    }
    scan_no = (scan_no + 1) % 100000;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float acc = 0.0f;
            for (int k = 0; k < N; k++)
                acc = acc + a[i][k] * b[k][j];
            c[i][j] = acc;
        }

    float sum = 0.0f;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            sum = sum + c[i][j];
        sum = sum + c[i][i] * 3.0f;
    }
    check = (check * 31 + (int32_t)(sum * 8.0f)) % 1000003;
}
