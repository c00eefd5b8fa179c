#include "st.h"
#include <stdint.h>
#define N 32
static int16_t a[N][N], b[N][N], c[N][N];
static int scans;
static void product(void) {
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t sum = 0;
            for (int k = 0; k < N; k++) sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}
void scan(void) {
    int seed = ++scans % 100;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = (i + 1 + 2 * (j + 1) + seed) % 19 - 9;
            b[i][j] = (3 * (i + 1) + j + 1 + seed) % 17 - 8;
        }
    product();
    int total = 0, trace = 0;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) total += c[i][j] * (j + 1);
        trace += c[i][i];
    }
    check = (check + total + trace) % 1000003;
}
