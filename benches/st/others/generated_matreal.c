#include "st.h"

static float a[32][32], b[32][32], c[32][32];
static int32_t scans;

void scan(void)
{
  scans++;
  int v = scans % 64;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++) {
      v = (v * 5 + 7) % 128;
      a[i][j] = v * 0.125f;
      b[i][j] = (127 - v) * 0.0625f - 4.0f;
      c[i][j] = 0;
    }
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      for (int k = 0; k < 32; k++)
        c[i][j] += a[i][k] * b[k][j];
  float s = 0;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      if (i <= j)
        s += c[i][j];
      else
        s -= c[i][j] * 0.5f;
  check = (check + (int32_t)s) % 1000003;
}
