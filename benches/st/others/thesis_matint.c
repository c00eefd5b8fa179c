/* 32 x 32 matrix product, INT operands, DINT sums */
#include <stdbool.h>
#include "st.h"

#define N 32

static bool ready;
static int16_t a[N][N];
static int16_t b[N][N];
static int32_t c[N][N];
static int16_t row;

void scan(void)
{
  int i, j, k;
  if (!ready) {
    for (i = 0; i < N; i++) {
      for (j = 0; j < N; j++) {
        a[i][j] = (i * 17 + j * 5) % 199 - 99;
        b[i][j] = (i * 3 + j * 29) % 201 - 100;
      }
    }
    ready = true;
  }

  for (j = 0; j < N; j++)
    a[row][j] = (a[row][j] * 3 + j + 1) % 100;
  row = (row + 1) % N;

  for (i = 0; i < N; i++) {
    for (j = 0; j < N; j++) {
      int32_t sum = 0;
      for (k = 0; k < N; k++)
        sum += (int32_t)a[i][k] * (int32_t)b[k][j];
      c[i][j] = sum;
    }
  }

  int32_t trace = 0;
  for (i = 0; i < N; i++)
    trace += c[i][i] + c[i][N - 1 - i] * 3;
  for (j = 0; j < N; j++)
    trace += c[row][j];
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)trace);
}
