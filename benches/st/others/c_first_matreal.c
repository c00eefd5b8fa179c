/* 32 x 32 product of float */
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool init_done;
static int32_t n_scan;
static int32_t rnd;

static float next_unit(void)
{
  rnd = (rnd * 8121 + 28411) % 134456;
  return (float)(rnd % 2001 - 1000) / 1000.0f;
}

void scan(void)
{
  int i, j, k;
  float sum;

  if (!init_done) {
    rnd = 3;
    for (i = 0; i < N; i++)
      for (j = 0; j < N; j++) {
        a[i][j] = next_unit();
        b[i][j] = next_unit();
      }
    init_done = true;
  }
  /* one new row of a, one new column of b */
  rnd = n_scan * 31 + 7;
  k = n_scan % N;
  for (j = 0; j < N; j++) {
    a[k][j] = next_unit();
    b[j][k] = next_unit();
  }

  for (i = 0; i < N; i++)
    for (j = 0; j < N; j++) {
      sum = 0.0f;
      for (k = 0; k < N; k++)
        sum = sum + a[i][k] * b[k][j];
      c[i][j] = sum;
    }

  sum = c[n_scan % N][n_scan * 7 % N];
  for (i = 0; i < N; i++) sum = sum + c[i][i] - 0.5f * c[i][N - 1 - i];
  check = (check + (int32_t)(sum * 1000.0f)) % 1000003;
  n_scan++;
}
