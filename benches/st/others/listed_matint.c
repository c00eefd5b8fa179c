/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

static int16_t a[32][32], b[32][32], c[32][32];
static int32_t seed = 4711, cycle;

void scan(void)
{
  int line = cycle % 32;
  cycle++;
  for (int k = 0; k < 32; k++) {
    seed = (seed * 421 + 1663) % 7875;
    a[line][k] = (int16_t)(seed % 31 - 15);
    seed = (seed * 421 + 1663) % 7875;
    b[k][line] = (int16_t)(seed % 29 - 12);
  }

  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++) {
      int16_t sum = 0;
      for (int k = 0; k < 32; k++)
        sum += a[i][k] * b[k][j];
      c[i][j] = sum;
    }

  int32_t total = 0;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      total += c[i][j];
  check = (check * 29 + abs(total) + abs(c[line][31])) % 1000003;
}
