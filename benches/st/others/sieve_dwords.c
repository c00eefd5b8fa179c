#include "iec_timers.h"
static uint32_t flags[64]; static int32_t scans;
static bool setbit(uint32_t *b, int n) { b[n / 32] |= 1u << (n % 32); return true; }
static bool testbit(uint32_t *b, int n) { return b[n / 32] >> (n % 32) & 1; }
static int popcount(uint32_t w) { int n = 0; do { if (w & 1) n++; w >>= 1; } while (w); return n; }
void scan(void) {
  scans++;
  int limit = 1900 + scans % 100;
  for (int i = 0; i < 64; i++) flags[i] = 0;
  for (int p = 2; p * p <= limit; p++)
    if (!testbit(flags, p)) for (int k = p * p; k <= limit; k += p) setbit(flags, k);
  int count = 0; uint32_t acc = 0;
  for (int i = 63; i >= 0; i--) {
    if (i % 4 == 0) count += popcount(flags[i]);
    acc = (acc << 3 | acc >> 29) ^ flags[i];
  }
  check = (check * 31 + count + (int32_t)(acc & 0xFFFF)) % 1000003;
}
