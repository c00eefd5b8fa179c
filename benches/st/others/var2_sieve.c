#include <stdbool.h>
#include "st.h"
typedef struct { int32_t count, largest; uint32_t bits[256]; } odd_sieve_t;
static bool test_bit(uint32_t w, int16_t n) { return ((w >> n) & 1u) != 0; }
static void odd_sieve(odd_sieve_t *s, int32_t limit)
{
    for (int32_t k = 0; k < 256; k++)
        s->bits[k] = 0xFFFFFFFFu;
    s->bits[0] &= 0xFFFFFFFEu;
    int32_t last = (limit - 1) / 2, k = 1, p = 3;
    while (p * p <= limit) {
        if (test_bit(s->bits[k / 32], (int16_t)(k % 32))) {
            int32_t m = (p * p - 1) / 2;
            while (m <= last) {
                s->bits[m / 32] &= ~(1u << (m % 32));
                m += p;
            }
        }
        k++;
        p += 2;
    }
    s->count = 1;
    for (k = 1; k <= last; k++) {
        if (test_bit(s->bits[k / 32], (int16_t)(k % 32))) {
            s->count++;
            s->largest = 2 * k + 1;
        }
    }
}
static odd_sieve_t sieve;
static int32_t n;
void scan(void)
{
    n = (n + 37) % 1000;
    odd_sieve(&sieve, 7000 + n);
    check = (check % 100003) * 3 + sieve.count * 5 + sieve.largest;
}
