/* Sieve of Eratosthenes up to LIMIT_N, then a pass over the gaps between primes */
#include <stdbool.h>
#include "st.h"

#define LIMIT_N 8192

static bool composite[LIMIT_N + 1];
static int32_t top = 8000;

void scan(void)
{
  int32_t i, j;
  top++;
  if (top > LIMIT_N)
    top = 8000;

  for (i = 0; i <= top; i++)
    composite[i] = false;
  i = 2;
  while (i * i <= top) {
    if (!composite[i]) {
      j = i * i;
      do {
        composite[j] = true;
        j += i;
      } while (j <= top);
    }
    i++;
  }

  int32_t primes = 0, sum = 0, max_gap = 0, last = 2;
  for (i = 2; i <= top; i++) {
    if (!composite[i]) {
      primes++;
      sum += i;
      int32_t gap = i - last;
      if (gap > max_gap)
        max_gap = gap;
      last = i;
    }
  }
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)(primes + sum + max_gap * 7 + last));
}
