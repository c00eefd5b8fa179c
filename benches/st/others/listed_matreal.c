/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

static float a[32][32], b[32][32], c[32][32];
static int32_t seed = 4711, cycle;

void scan(void)
{
  int line = cycle % 32;
  cycle++;
  for (int k = 0; k < 32; k++) {
    seed = (seed * 421 + 1663) % 7875;
    a[line][k] = (float)(seed % 2001 - 1000) / 128.0f;
    seed = (seed * 421 + 1663) % 7875;
    b[k][line] = (float)(seed % 1501 - 700) * 0.003f;
  }

  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++) {
      float sum = 0.0f;
      for (int k = 0; k < 32; k++)
        sum += a[i][k] * b[k][j];
      c[i][j] = sum;
    }

  float total = 0.0f;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      total += c[i][j];
  check = (check * 29 + abs((int32_t)(total * 16.0f)) + abs((int32_t)(c[line][31] * 64.0f))) % 1000003;
}
