#include "iec_timers.h"
typedef struct { float e[4][4]; } Block;
static Block a[8][8], b[8][8], c[8][8]; static int32_t scans;
static Block mulblock(const Block *a, const Block *b) {
  Block r = {0};
  for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) for (int k = 0; k < 4; k++) r.e[i][j] += a->e[i][k] * b->e[k][j];
  return r;
}
static Block addblock(const Block *a, const Block *b) {
  Block r;
  for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) r.e[i][j] = a->e[i][j] + b->e[i][j];
  return r;
}
void scan(void) {
  scans++;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) {
    a[i / 4][j / 4].e[i % 4][j % 4] = (float)((scans + i * j) % 8);
    b[i / 4][j / 4].e[i % 4][j % 4] = (float)(i - 2 * j) * 0.25f;
  }
  for (int i = 0; i < 8; i++) for (int j = 0; j < 8; j++) {
    Block t = {0};
    for (int k = 0; k < 8; k++) { Block m = mulblock(&a[i][k], &b[k][j]); t = addblock(&t, &m); }
    c[i][j] = t;
  }
  memcpy(a, c, sizeof a);
  float sum = 0;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) sum += a[i / 4][j / 4].e[i % 4][j % 4] * (float)(i % 3 - 1);
  int32_t t = (int32_t)sum; if (t < 0) t = -t;
  check = (check * 31 + t % 10007) % 1000003;
}
