#include "st.h"

static uint8_t factor[10000];
static int32_t scans;

void scan(void)
{
  int n, m, top, found = 0, last = 0, twins = 0;
  scans++;
  top = 9000 + scans % 1000;
  for (n = 0; n <= top; n++)
    factor[n] = 0;
  for (m = 4; m <= top; m += 2)
    factor[m] = 2;
  for (n = 3; n * n <= top; n += 2)
    if (!factor[n])
      for (m = n * n; m <= top; m += 2 * n)
        if (!factor[m])
          factor[m] = n;
  for (n = 2; n <= top; n++)
    if (!factor[n]) {
      found++;
      if (n - last == 2)
        twins++;
      last = n;
    } else
      found += factor[n] & 1;
  check = (check + found + 3 * twins + last) % 1000003;
}
