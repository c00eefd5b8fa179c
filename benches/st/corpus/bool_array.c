#include "st.h"
static uint8_t a[256], b[256], c[256], out[256];
static int16_t scans;
void scan(void)
{
    for (int i = 0; i < 256; i++) {
        a[i] = (i + scans) % 5 == 0;
        b[i] = (i + scans) % 3 == 0;
        c[i] = (i * 3 + scans) % 7 == 0;
    }
    for (int i = 0; i < 256; i++)
        out[i] = ((a[i] & b[i]) | out[i]) & !c[i];
    int16_t n = 0;
    for (int i = 1; i < 256; i++)
        if (out[i] && !out[i - 1])
            n++;
    check += n;
    scans++;
}
