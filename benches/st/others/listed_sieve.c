/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>

#define TOP 8192

static int32_t cycle;
static bool composite[TOP + 1];

void scan(void)
{
  cycle++;
  for (int32_t p = 0; p <= TOP; p++)
    composite[p] = false;
  for (int32_t p = 2; p * p <= TOP; p++)
    if (!composite[p])
      for (int32_t j = p * p; j <= TOP; j += p)
        composite[j] = true;

  int32_t found = 0, twins = 0, previous = 0, total = 0;
  for (int32_t p = 2; p <= TOP; p++)
    if (!composite[p]) {
      found++;
      if (p - previous == 2)
        twins++;
      previous = p;
      total += p;
    }
  check = (check * 13 + found * 3 + twins + total % 1009 + cycle) % 1000003;
}
