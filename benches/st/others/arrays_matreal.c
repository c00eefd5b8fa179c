#include "st.h"

static int32_t n;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    if (n == 0)
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 61 - 30) * 0.37f;
                b[i][j] = (float)((i * 5 + j * 11) % 59 - 29) / 7.0f;
            }
    a[n % 32][(n * 5) % 31] = (float)(n % 61 - 30) * 0.41f;
    b[(n * 3) % 31][n % 32] = (float)(n % 59 - 29) / 3.0f;

    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            float sum = 0.0f;
            for (int k = 0; k < 32; k++) sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }

    int32_t acc = 0;
    for (int i = 0; i < 32; i++) {
        float fold = 0.0f;
        for (int j = 0; j < 32; j++) fold = c[i][j] - fold * 0.75f;
        acc = (int32_t)(fold * 64.0f) - acc;
    }
    n++;
    check = (check * 31 + acc) % 1000003;
}
