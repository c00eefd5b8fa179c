#include <stdbool.h>
#include "st.h"

#define MAX_NUMBER 6000

typedef struct {
    int16_t limit;
    int16_t count;
    int16_t max_gap;
    int32_t sum;
    bool prime[MAX_NUMBER + 1];
} sieve_t;

static void sieve(sieve_t *s)
{
    s->prime[0] = false;
    s->prime[1] = false;
    for (int i = 2; i <= s->limit; i++)
        s->prime[i] = true;

    for (int i = 2; i * i <= s->limit; i++)
        if (s->prime[i])
            for (int k = i * i; k <= s->limit; k += i)
                s->prime[k] = false;

    int16_t count = 0, max_gap = 0, last = 2;
    int32_t sum = 0;
    for (int16_t i = 2; i <= s->limit; i++) {
        if (s->prime[i]) {
            count++;
            sum += i;
            if (i - last > max_gap)
                max_gap = (int16_t)(i - last);
            last = i;
        }
    }
    s->count = count;
    s->sum = sum;
    s->max_gap = max_gap;
}

static sieve_t s;
static int16_t offset;

void scan(void)
{
    offset = (int16_t)((offset + 37) % 500);
    s.limit = (int16_t)(5500 + offset);
    sieve(&s);
    check = check * 3 + s.sum + s.count + s.max_gap;
}
