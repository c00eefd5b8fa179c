#include "st.h"
#include <math.h>
#define N 32
static float a[N][N], b[N][N], c[N][N];
static int scans;
static void product(void) {
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++) sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}
void scan(void) {
    float factor = (float)(++scans % 100) * 0.01f;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = (float)(i - j) * factor;
            b[i][j] = (float)(i + j + 2) * 0.125f - factor;
        }
    product();
    float total = 0.0f, norm = 0.0f;
    for (int i = 0; i < N; i++) total += c[i][N - 1 - i];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float x = fabsf(c[i][j]);
            norm = x > norm ? x : norm;
        }
    check = (check + (int)total + (int)norm) % 1000003;
}
