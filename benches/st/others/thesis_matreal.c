/* 32 x 32 matrix product in REAL, as a function over arrays */
#include <stdbool.h>
#include "st.h"

#define N 32

typedef float matrix[N][N];

static float mat_mul(matrix a, matrix b, matrix c)
{
  float trace = 0.0f;
  for (int i = 0; i < N; i++) {
    for (int j = 0; j < N; j++) {
      float sum = 0.0f;
      int k = 0;
      while (k < N) {
        sum = sum + a[i][k] * b[k][j];
        k++;
      }
      c[i][j] = sum;
    }
    trace = trace + c[i][i];
  }
  return trace;
}

static bool ready;
static matrix a, b, c;
static int16_t row = 0;

void scan(void)
{
  int i, j;
  if (!ready) {
    for (i = 0; i < N; i++) {
      for (j = 0; j < N; j++) {
        a[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 23) * 0.125f - 1.0f;
        b[i][j] = (float)(((i + 1) * 5 + (j + 1) * 11) % 19) * 0.1f - 0.9f;
      }
    }
    ready = true;
  }

  for (j = 0; j < N; j++)
    a[row][j] = 0.75f - a[row][j] * 0.9f;
  row++;
  if (row >= N)
    row = 0;

  float trace = mat_mul(a, b, c);

  float sum = 0.0f;
  for (i = 0; i < N; i++)
    sum = sum + c[i][N - 1 - i] + c[row][i];
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(trace * 100.0f) + (uint32_t)(int32_t)(sum * 100.0f));
}
