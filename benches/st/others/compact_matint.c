#include "st.h"

static int16_t a[1024], b[1024], c[1024];
static int32_t seed = 42;

static void multiply(const int16_t *x, const int16_t *y, int16_t *z)
{
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            int16_t sum = 0;
            for (int k = 0; k < 32; k++)
                sum += x[i * 32 + k] * y[k * 32 + j];
            z[i * 32 + j] = sum;
        }
}

void scan(void)
{
    for (int i = 0; i < 1024; i++) {
        seed = (seed * 421 + 1663) % 7875;
        a[i] = seed % 30;
        b[i] = seed % 31 - 15;
    }
    multiply(a, b, c);
    int32_t hash = 0;
    for (int i = 0; i < 1024; i++) {
        hash = (hash + c[i]) * 2;
        if (hash > 1000000 || hash < -1000000)
            hash /= 1024;
    }
    check = (check + hash) % 1000000;
}
