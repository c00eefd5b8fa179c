/* Course unit 3: sieve of Eratosthenes. */
#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t count, largest;
    bool composite[8192];
} PrimeSieve;

static void prime_sieve(PrimeSieve *s, int32_t limit)
{
    for (int32_t n = 0; n <= limit; n++)
        s->composite[n] = false;
    int32_t number = 2;
    while (number * number <= limit) {
        if (!s->composite[number]) {
            int32_t multiple = number * number;
            while (multiple <= limit) {
                s->composite[multiple] = true;
                multiple += number;
            }
        }
        number++;
    }
    s->count = 0;
    for (int32_t n = 2; n <= limit; n++) {
        if (!s->composite[n]) {
            s->count++;
            s->largest = n;
        }
    }
}

static int32_t scan_no;
static PrimeSieve sieve;

void scan(void)
{
    scan_no = (scan_no + 1) % 192;
    prime_sieve(&sieve, 8000 + scan_no);
    check = (check * 31 + sieve.count + sieve.largest) % 1000003;
}
