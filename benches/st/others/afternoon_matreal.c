#include "st.h"
static int round_even(float x) { x += 12582912.0f; x -= 12582912.0f; return (int)x; }
static float a[32][32], b[32][32], c[32][32];
static int scans;
void scan(void) {
    scans++;
    if (scans == 1)
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) { a[i][j] = (i - j) * 0.5f; b[i][j] = (i + j) * 0.1f; }
    a[scans % 32][5] = scans % 20;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            c[i][j] = 0;
            for (int k = 0; k < 32; k++) c[i][j] += a[i][k] * b[k][j];
        }
    float sum = 0;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) sum += c[i][j];
    check = (check + round_even(sum)) % 1000000;
}
