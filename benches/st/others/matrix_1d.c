#include "st.h"
static float a[1024], b[1024], c[1024];
static int32_t scans;
void scan(void)
{
    for (int i = 0; i < 1024; i++) { a[i] = (i + scans % 16) % 10; b[i] = i % 7; }
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            float sum = 0;
            for (int k = 0; k < 32; k++) sum += a[i * 32 + k] * b[k * 32 + j];
            c[i * 32 + j] = sum;
        }
    check += (int32_t)c[77] + (int32_t)c[1000];
    scans++;
}
