#include <stdbool.h>
#include "st.h"
static int16_t base[200], nbase;
static uint8_t win[2048];
static int32_t low = 2048;
typedef struct { int16_t primes, twins; } segment_t;
static void segment(segment_t *s, int32_t lo, int16_t nb, const int16_t *b, uint8_t *w)
{
    for (int16_t i = 0; i < 2048; i++)
        w[i] = 0;
    for (int16_t i = 0; i < nb; i++) {
        int32_t p = b[i];
        if (p * p > lo + 2047)
            break;
        int32_t first = ((lo + p - 1) / p) * p;
        if (first < p * p)
            first = p * p;
        for (int32_t k = first - lo; k < 2048; k += p)
            w[k] = 1;
    }
    s->primes = 0;
    s->twins = 0;
    int16_t gap = 100;
    for (int16_t i = 0; i < 2048; i++) {
        if (w[i] == 0) {
            s->primes++;
            if (gap == 1)
                s->twins++;
            gap = 0;
        } else {
            gap++;
        }
    }
}
static segment_t seg;
void scan(void)
{
    if (nbase == 0) {
        for (int16_t n = 2; n < 1000; n++) {
            bool prime = true;
            for (int16_t d = 2; d * d <= n && prime; d++)
                prime = n % d != 0;
            if (prime)
                base[nbase++] = n;
        }
    }
    segment(&seg, low, nbase, base, win);
    check = (check % 100003) * 3 + seg.primes * 7 + seg.twins;
    low += 2048;
    if (low > 900000)
        low = 2048;
}
