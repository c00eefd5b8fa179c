/* Sieve of Eratosthenes up to 8192 */
#include <stdbool.h>
#include "st.h"

#define LIMIT 8192

static bool flags[LIMIT + 1];
static int32_t n_scan;

void scan(void)
{
  int32_t i, j, count, nth, p;

  for (i = 2; i <= LIMIT; i++) flags[i] = true;
  i = 2;
  while (i * i <= LIMIT) {
    if (flags[i]) {
      j = i * i;
      while (j <= LIMIT) {
        flags[j] = false;
        j += i;
      }
    }
    i++;
  }
  count = 0;
  for (i = 2; i <= LIMIT; i++)
    if (flags[i]) count++;

  /* the prime of number nth */
  nth = n_scan * 37 % count;
  p = 2;
  while (nth > 0) {
    p++;
    if (flags[p]) nth--;
  }
  check = (check * 3 + count + p) % 1000003;
  n_scan++;
}
