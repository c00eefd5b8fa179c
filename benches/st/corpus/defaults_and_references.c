#include "iec_timers.h"
typedef struct { int32_t sum; uint16_t hits; double last; } Acc;
static Acc accs[8]; static int32_t scans;
static int32_t mix(int8_t a, int16_t b, int32_t c, uint8_t d, uint16_t e, uint32_t f, bool g, uint16_t h, float i, double j, int64_t k, uint8_t l, bool *parity) {
  int32_t m = a + b - c / 7 + d + e + (int32_t)(f % 100);
  if (g) m += h & 0xFF; else m = m - (int32_t)(i * 10.0f) - (int32_t)(j * 3.0);
  m += (int32_t)(k / 1000) + l;
  *parity = m % 2 != 0;
  return m;
}
static uint32_t gcd(uint32_t x, uint32_t y) { while (y) { uint32_t t = x % y; x = y; y = t; } return x; }
static int32_t middle(int32_t n, Acc *acc) {
  bool p;
  int32_t m = mix(n % 50, n % 300, n, 7, acc->hits, gcd(n + 60, 84), n % 3 == 0, n % 60000, 0.5f, acc->last, 30000, 0x0F, &p);
  acc->last = (double)(m % 64) * 0.25;
  if (p) acc->hits = (acc->hits + 1) % 400;
  return m;
}
static int32_t outer(Acc *r, int32_t n) {
  int32_t o = 0;
  for (int q = 3; q >= 1; q--) { if (!r) return o; o += middle(n * q, r); }
  r->sum = (r->sum + o) % 5000;
  return o;
}
void scan(void) {
  scans++; int32_t n = 0;
  for (int i = 0; i <= 65; i++) n += outer(&accs[i % 8], (scans * 17 + i * 31) % 5000);
  for (int i = 0; i < 8; i++) n += accs[i].sum + accs[i].hits;
  check = (check * 31 + (n < 0 ? -n : n) % 100003) % 1000003;
}
