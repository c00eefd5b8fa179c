#include "iec_timers.h"
enum { N = 32, BLK = 8 };
typedef struct { int16_t data[N * N]; } Mat;
static Mat a, b, c; static int32_t scans;
static void set(Mat *m, int r, int c, int16_t x) { m->data[r * N + c] = x; }
static int16_t get(const Mat *m, int r, int c) { return m->data[r * N + c]; }
static void mul(Mat *m, const Mat *a, const Mat *b) {
  memset(m, 0, sizeof *m);
  for (int bi = 0; bi < N; bi += BLK) for (int bj = 0; bj < N; bj += BLK) for (int bk = 0; bk < N; bk += BLK)
    for (int i = bi; i < bi + BLK; i++) for (int j = bj; j < bj + BLK; j++) {
      int16_t s = get(m, i, j);
      for (int k = bk; k < bk + BLK; k++) s += get(a, i, k) * get(b, k, j);
      set(m, i, j, s);
    }
}
void scan(void) {
  scans++;
  for (int i = 0; i < N; i++) for (int j = N - 1; j >= 0; j--) {
    int x = i - j + scans % 5;
    set(&a, i, j, x < -7 ? -7 : x > 7 ? 7 : x);
    set(&b, i, j, (i * 3 + j) % 13 - 6);
  }
  mul(&c, &a, &b);
  int32_t sum = 0;
  for (int i = 0; i < N; i++) for (int j = 0; j < N; j++) sum = sum * 3 % 100003 + get(&c, j, i);
  check = (check * 31 + (sum < 0 ? -sum : sum)) % 1000003;
}
