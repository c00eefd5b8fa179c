/* 32 x 32 matrix product, int16_t elements, int32_t sums */
#include "st.h"
#include <stdbool.h>

#define N 32

static bool init_done;
static int16_t scan_no;
static int16_t a[N][N];
static int16_t b[N][N];
static int32_t c[N][N];

void scan(void)
{
    int i, j, k;
    int32_t acc;

    if (!init_done) {
        init_done = true;
        for (i = 0; i < N; i++) {
            for (j = 0; j < N; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        }
    }
    scan_no = (int16_t)((scan_no + 1) % 1000);
    a[scan_no % 32][(scan_no * 5) % 32] = (int16_t)(scan_no % 89 - 44);
    b[(scan_no * 3) % 32][scan_no % 32] = (int16_t)(scan_no % 83 - 41);

    for (i = 0; i < N; i++) {
        for (j = 0; j < N; j++) {
            acc = 0;
            for (k = 0; k < N; k++)
                acc += a[i][k] * b[k][j];
            c[i][j] = acc;
        }
    }

    acc = 0;
    for (i = 0; i < N; i++)
        acc += c[i][i] - 3 * c[i][N - 1 - i] + c[scan_no % 32][i];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)acc);
}
