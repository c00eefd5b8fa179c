/* Course unit 4: product of integer matrices. */
#include "st.h"
#include <stdbool.h>

static void matrix_product(int16_t a[32][32], int16_t b[32][32], int32_t c[32][32])
{
    for (int i = 0; i < 32; i++) {
        for (int j = 0; j < 32; j++) {
            int32_t sum = 0;
            for (int k = 0; k < 32; k++)
                sum += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = sum;
        }
    }
}

static int32_t trace(int32_t m[32][32])
{
    int32_t sum = 0;
    for (int i = 0; i < 32; i++)
        sum += m[i][i] + m[i][31 - i];
    return sum;
}

static int16_t scan_no;
static bool ready;
static int16_t a[32][32], b[32][32];
static int32_t c[32][32];

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 32; i++) {
            for (int j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 41 - 20);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 37 - 18);
            }
        }
        ready = true;
    }
    scan_no = (int16_t)((scan_no + 1) % 1000);
    a[scan_no % 32][scan_no % 7] = scan_no;
    b[scan_no % 5][scan_no % 32] = (int16_t)(scan_no % 50);
    matrix_product(a, b, c);
    check = (check * 31 + trace(c)) % 1000003;
}
