#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N], c[N][N];
static int16_t nscan;

void scan(void)
{
    if (nscan == 0)
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)(i * 3 - j * 5 + 7);
                b[i][j] = (int16_t)((i * 11 + j * 17) % 101 - 50);
            }
    nscan = (int16_t)(nscan % 30000 + 1);
    for (int j = 0; j < N; j++)
        a[nscan % N][j] = (int16_t)(nscan * 13 + j * 29);

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t acc = 0;
            for (int k = 0; k < N; k++)
                acc = (int16_t)(acc + a[i][k] * b[k][j]);
            c[i][j] = acc;
        }

    int32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += c[i][j] * (i + 1);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
