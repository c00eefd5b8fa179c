#include "iec_timers.h"
#include <stdio.h>
#include <stdlib.h>
typedef struct { char key[21]; uint32_t count; } Entry;
static Entry e[12]; static int32_t scans;
static void reverse(char *d, const char *s) { int n = strlen(s); for (int i = 0; i < n; i++) d[i] = s[n - 1 - i]; d[n] = 0; }
static void pad(char *d, int32_t n, int width) {
  char t[12]; int l = 0;
  do t[l++] = '0' + n % 10; while (n /= 10);
  while (l < width) t[l++] = '0';
  for (int i = 0; i < l; i++) d[i] = t[l - 1 - i];
  d[l] = 0;
}
static uint32_t hash(const char *s) { uint32_t h = 0x1505; for (; *s; s++) h = (h << 5 | h >> 27) ^ (unsigned char)*s; return h; }
static void sort(Entry *e) {
  int last = 10; bool sw;
  do {
    sw = false;
    for (int i = 0; i <= last; i++) if (strcmp(e[i].key, e[i + 1].key) > 0) { Entry t = e[i]; e[i] = e[i + 1]; e[i + 1] = t; sw = true; }
    last--;
  } while (sw && last >= 0);
}
void scan(void) {
  scans++; int32_t n = 0;
  for (int i = 0; i < 12; i++) {
    int32_t v = (scans * 7919 + i * 104729) % 10007; char t[21];
    pad(t, v, 6);
    e[i].key[0] = 'k'; reverse(e[i].key + 1, t);
    e[i].count = v;
  }
  sort(e);
  uint32_t d = 0;
  for (int i = 0; i < 12; i++) {
    d = (d << 1 | d >> 31) ^ hash(e[i].key);
    n += (int32_t)e[i].count * i + (int32_t)strtol(e[i].key + strlen(e[i].key) - 3, 0, 10);
  }
  check = (check * 31 + n % 1009 + (int32_t)(d & 0xFFFF)) % 1000003;
}
