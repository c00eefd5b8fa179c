#include <math.h>
#include <string.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static int scans;

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 19) * 0.25f - 2.0f;
                b[i][j] = (float)((i * 5 + j * 11) % 17) * 0.125f - 1.1f;
            }
    scans++;
    a[scans % 32][scans % 29] = (float)(scans % 23) * 0.3f - 3.0f;
    b[scans % 29][scans % 32] = (float)(scans % 13) * 0.7f - 4.0f;

    for (int i = 0; i < N; i++) {
        float row[N] = {0};
        for (int k = 0; k < N; k++) {
            float factor = a[i][k];
            for (int j = 0; j < N; j++)
                row[j] += factor * b[k][j];
        }
        memcpy(c[i], row, sizeof row);
    }

    float total = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            total += fabsf(c[i][j]);
        total += c[i][N - 1 - i];
    }
    check = (check * 31 + (int)(total * 4.0f)) % 1000003;
}
