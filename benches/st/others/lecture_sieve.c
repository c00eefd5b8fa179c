/* The sieve of Eratosthenes up to 8192, with a few statistics on the primes. */
#include <stdbool.h>
#include "st.h"

#define MAX_LIMIT 8192

typedef struct {
    int32_t prime_count;
    int32_t twin_count;
    int32_t largest_prime;
    int32_t largest_gap;
    bool composite[MAX_LIMIT + 1];
} Sieve;

static void sieve_run(Sieve *s, int32_t bound)
{
    /* Nothing is crossed out yet. */
    for (int32_t n = 2; n <= bound; n++)
        s->composite[n] = false;

    /* Cross out the multiples of every prime up to the square root. */
    for (int32_t n = 2; n * n <= bound; n++) {
        if (!s->composite[n]) {
            for (int32_t multiple = n * n; multiple <= bound; multiple += n)
                s->composite[multiple] = true;
        }
    }

    /* What is left is prime. */
    s->prime_count = 0;
    s->twin_count = 0;
    s->largest_prime = 2;
    s->largest_gap = 0;
    for (int32_t n = 2; n <= bound; n++) {
        if (!s->composite[n]) {
            int32_t gap = n - s->largest_prime;
            s->prime_count++;
            if (gap == 2)
                s->twin_count++;
            if (gap > s->largest_gap)
                s->largest_gap = gap;
            s->largest_prime = n;
        }
    }
}

static Sieve sieve;
static int32_t scan_count;

void scan(void)
{
    scan_count++;
    sieve_run(&sieve, MAX_LIMIT);
    check = (check * 31 + sieve.prime_count + 3 * sieve.twin_count
             + 5 * sieve.largest_gap + sieve.largest_prime + scan_count) % 1000003;
}
