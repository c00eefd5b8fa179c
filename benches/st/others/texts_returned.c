#include "iec_timers.h"
typedef struct { int id; char name[17], path[65]; } Device;
static Device dev[9]; static int32_t scans;
static int bracket(char *d, const char *s) { int n = strlen(s); d[0] = '['; memcpy(d + 1, s, n); d[n + 1] = ']'; d[n + 2] = 0; return n + 2; }
static int pair(char *d, const char *a, const char *b) { int n = bracket(d, a); d[n++] = '/'; return n + bracket(d + n, b); }
static void tidy(char *s) {
  char *p = strstr(s, "][");
  if (p) { *p = '-'; memmove(p + 1, p + 2, strlen(p + 2) + 1); }
  while ((p = strchr(s, '/'))) { memmove(p + 2, p + 1, strlen(p + 1) + 1); p[0] = p[1] = ':'; }
}
static void full(char *d, const Device *a, const Device *b) {
  int n = pair(d, a->name, b->name);
  char t[25]; int m = bracket(t, a->name);
  strcpy(d + n, m > 3 ? t + m - 3 : t);
  tidy(d);
}
void scan(void) {
  scans++;
  if (scans == 1) {
    static const char *const names[] = { "pump", "valve", "mixer", "ab", "conveyor", "oven12", "x/y", "tank" };
    for (int i = 0; i < 8; i++) strcpy(dev[i + 1].name, names[i]);
  }
  int32_t n = 0;
  char *nm = dev[scans % 8 + 1].name; char first = nm[0]; int l = strlen(nm);
  memmove(nm, nm + 1, l - 1); nm[l - 1] = first;
  for (int i = 1; i <= 8; i++) {
    int j = (i * 3 + scans % 5) % 8 + 1;
    char *p = dev[i].path;
    full(p, &dev[i], &dev[j]);
    char *e = strchr(p, 'e');
    n += (int)strlen(p) * i + (e ? (int)(e - p) + 1 : 0) * 3;
    if (strcmp(p, dev[j].path) > 0) n += 1;
    if (strcmp(p, "nothing") == 0 || strncmp(p, "[p", 2) == 0) n += 7;
  }
  check = (check * 31 + n) % 1000003;
}
