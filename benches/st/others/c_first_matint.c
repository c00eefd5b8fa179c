/* 32 x 32 product of int16_t, sums in int32_t */
#include <stdbool.h>
#include "st.h"

#define N 32

static int16_t a[N][N], b[N][N];
static int32_t c[N][N];
static bool init_done;
static int32_t n_scan;
static uint32_t rnd;

static int16_t next_small(void)
{
  rnd = (rnd * 8121 + 28411) % 134456;
  return (int16_t)((int32_t)(rnd % 101) - 50);
}

void scan(void)
{
  int i, j, k;
  int32_t sum;

  if (!init_done) {
    rnd = 1;
    for (i = 0; i < N; i++)
      for (j = 0; j < N; j++) {
        a[i][j] = next_small();
        b[i][j] = next_small();
      }
    init_done = true;
  }
  /* one new row of a, one new column of b */
  rnd = (uint32_t)(n_scan * 31 + 7);
  k = n_scan % N;
  for (j = 0; j < N; j++) {
    a[k][j] = next_small();
    b[j][k] = next_small();
  }

  for (i = 0; i < N; i++)
    for (j = 0; j < N; j++) {
      sum = 0;
      for (k = 0; k < N; k++)
        sum += a[i][k] * b[k][j];
      c[i][j] = sum;
    }

  sum = c[n_scan % N][n_scan * 7 % N];
  for (i = 0; i < N; i++) sum += c[i][i] - 2 * c[i][N - 1 - i];
  check = (check + sum) % 1000003;
  n_scan++;
}
