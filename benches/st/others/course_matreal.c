/* Course unit 5: product of real matrices. */
#include "st.h"
#include <stdbool.h>

static void matrix_product(float a[32][32], float b[32][32], float c[32][32])
{
    for (int i = 0; i < 32; i++) {
        for (int j = 0; j < 32; j++) {
            float sum = 0.0f;
            for (int k = 0; k < 32; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }
}

static float trace(float m[32][32])
{
    float sum = 0.0f;
    for (int i = 0; i < 32; i++)
        sum = sum + m[i][i] - m[i][31 - i];
    return sum;
}

static int16_t scan_no;
static bool ready;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 32; i++) {
            for (int j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 41 - 20) * 0.1f;
                b[i][j] = (float)((i * 5 + j * 11) % 37 - 18) * 0.2f;
            }
        }
        ready = true;
    }
    scan_no = (int16_t)((scan_no + 1) % 1000);
    a[scan_no % 32][scan_no % 7] = (float)scan_no * 0.01f;
    b[scan_no % 5][scan_no % 32] = (float)(scan_no % 50) * 0.05f;
    matrix_product(a, b, c);
    check = (check * 31 + (int32_t)(trace(c) * 100.0f)) % 1000003;
}
