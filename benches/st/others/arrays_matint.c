#include "st.h"

static int32_t n;
static int16_t a[32][32], b[32][32], c[32][32];

void scan(void)
{
    if (n == 0)
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a[i][j] = (i * 7 + j * 3) % 61 - 30;
                b[i][j] = (i * 5 + j * 11) % 59 - 29;
            }
    a[n % 32][(n * 5) % 31] = n % 61 - 30;
    b[(n * 3) % 31][n % 32] = n % 59 - 29;

    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            int16_t sum = 0;
            for (int k = 0; k < 32; k++) sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    int32_t acc = 0;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) acc = c[i][j] - acc;
    n++;
    check = (check * 31 + acc) % 1000003;
}
