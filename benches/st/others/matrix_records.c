#include "iec_timers.h"
typedef struct { int16_t v[32]; } Row;
static Row a[32], b[32], c[32]; static int32_t scans;
static int16_t dot(const Row *a, const Row *b) { int16_t s = 0; for (int i = 0; i < 32; i++) s += a->v[i] * b->v[i]; return s; }
static Row column(const Row *m, int c) { Row r; for (int i = 0; i < 32; i++) r.v[i] = m[i].v[c]; return r; }
void scan(void) {
  scans++;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) {
    a[i].v[j] = (scans % 50 + (i + 1) * (j + 1)) % 17 - 8;
    b[i].v[j] = (i - j) % 9;
  }
  for (int j = 0; j < 32; j++) { Row t = column(b, j); for (int i = 0; i < 32; i++) c[i].v[j] = dot(&a[i], &t); }
  int32_t sum = 0;
  for (int i = 31; i >= 0; i--) for (int j = 0; j < 32; j++) sum += (int16_t)(c[i].v[j]) * (j + 1);
  check = (check * 31 + (sum < 0 ? -sum : sum) % 10007) % 1000003;
}
