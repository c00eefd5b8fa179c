#include "iec_timers.h"
typedef struct { uint16_t lpf; bool isPrime; uint8_t omega; } Num;
static Num c[10][10][10]; static uint16_t primes[201]; static int32_t scans;
static int64_t sumof(const uint16_t *list, int n) {
  int64_t s = 0;
  for (int i = 1; i <= n; i += 2) s += (int64_t)list[i] * list[n + 1 - i];
  return s;
}
static Num *at(unsigned i) { return &c[i / 100][i / 10 % 10][i % 10]; }
void scan(void) {
  scans++;
  unsigned limit = 900 + scans % 100; int np = 0;
  for (unsigned i = 0; i < limit; i++) *at(i) = (Num){0};
  for (unsigned i = 2; i < limit; i++) {
    Num *x = at(i);
    if (x->lpf == 0) { x->lpf = i; x->isPrime = true; x->omega = 1; primes[++np] = i; }
    for (int j = 1; j <= np; j++) {
      unsigned m = (uint16_t)(primes[j] * i);
      if (primes[j] > x->lpf || m >= limit) break;
      Num *y = at(m);
      y->lpf = primes[j]; y->omega = x->omega + 1;
    }
  }
  int64_t tot = sumof(primes, np);
  for (int j = 1; j <= np; j++) tot += at(primes[np + 1 - j] / 2)->omega;
  check = (check * 31 + (int32_t)(tot % 100000)) % 1000003;
}
