#include <stdbool.h>
#include "st.h"

struct prime_sieve {
    int32_t limit;
    int16_t count;
    int32_t largest;
    int32_t sum;
    bool composite[8192];
};

static void prime_sieve(struct prime_sieve *s)
{
    for (int32_t i = 0; i <= s->limit; i++)
        s->composite[i] = false;
    s->count = 0;
    s->sum = 0;
    s->largest = 0;
    for (int32_t i = 2; i <= s->limit; i++) {
        if (!s->composite[i]) {
            s->count++;
            s->largest = i;
            s->sum += i;
            for (int32_t k = i * i; k <= s->limit; k += i)
                s->composite[k] = true;
        }
    }
}

static struct prime_sieve sieve;
static int32_t top = 8000;

void scan(void)
{
    top++;
    if (top > 8191)
        top = 8000;
    sieve.limit = top;
    prime_sieve(&sieve);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sieve.count + sieve.largest + sieve.sum % 10007));
}
