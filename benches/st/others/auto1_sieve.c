/* prime sieve */
#include "st.h"
#include <stdbool.h>

#define SIZE 5000

typedef struct {
    int32_t count, last, sum;
    bool prime[SIZE + 1];
} sieve_t;

static void sieve_run(sieve_t *s, int32_t limit)
{
    int32_t i, j;

    if (limit > SIZE)
        limit = SIZE;
    for (i = 2; i <= limit; i++)
        s->prime[i] = true;
    for (i = 2; i * i <= limit; i++) {
        if (s->prime[i]) {
            for (j = i * i; j <= limit; j += i)
                s->prime[j] = false;
        }
    }
    s->count = 0;
    s->last = 0;
    s->sum = 0;
    for (i = 2; i <= limit; i++) {
        if (s->prime[i]) {
            s->count++;
            s->last = i;
            s->sum += i;
        }
    }
}

static int32_t scan_no;
static sieve_t sieve;

void scan(void)
{
    scan_no = (scan_no + 1) % 100;
    sieve_run(&sieve, 4900 + scan_no);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sieve.sum + sieve.count * 7 + sieve.last));
}
