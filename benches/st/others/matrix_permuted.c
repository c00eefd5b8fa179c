#include "iec_timers.h"
static int16_t a[32][32], b[32][32], c[32][32], old[32][32]; static uint8_t p[32]; static int32_t scans;
static int16_t sat(int32_t x) { return x < -2000 ? -2000 : x > 2000 ? 2000 : x; }
static int32_t muladd(int32_t acc, int16_t a, int16_t b) { if (a == 0 || b == 0) return acc; return acc + a * b; }
static int16_t element(int r, int col) {
  int32_t acc = 0;
  for (int k = 0; k <= 31; k++) acc = muladd(acc, a[r][p[k]], b[p[k]][col]);
  return sat(acc);
}
void scan(void) {
  scans++;
  for (int i = 0; i < 32; i++) {
    p[i] = (i * 7 + scans) % 32;
    for (int j = 0; j < 32; j++) { a[i][j] = (i * 5 + j * 3 + scans % 11) % 23 - 9; b[i][j] = (i + j * 7) % 19 - 5; }
  }
  memcpy(old, c, sizeof c);
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) c[i][j] = element(i, j);
  int64_t sum = 0;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) sum += (int64_t)c[p[i]][j] * (i > j ? i : j) - old[j][i];
  check = (check * 31 + (int32_t)((sum < 0 ? -sum : sum) % 10007)) % 1000003;
}
