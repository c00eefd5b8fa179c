#include "iec_timers.h"
enum { N = 2001 };
static bool field[N]; static int32_t scans;
static int fill(bool *a, int n, bool v) { for (int i = 0; i < n; i++) a[i] = v; return n; }
static int strike(bool *a, int n, int first, int step) {
  int r = 0;
  for (int i = first; i < n; i += step) if (a[i]) { a[i] = false; r++; }
  return r;
}
void scan(void) {
  scans++;
  int skip = scans % 500;
  int left = fill(field, N, true);
  for (int p = 2; p <= 100; p++) {
    if (!field[p]) continue;
    if (p * p > N - 1) break;
    left -= strike(field, N, p * p, p);
  }
  int sum = 0;
  for (int p = N - 1; p >= skip; p--) if (field[p]) sum += p;
  check = (check * 31 + left + sum) % 1000003;
}
