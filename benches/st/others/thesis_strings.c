/* Text work: build telegrams, take them apart, edit, compare, convert */
#include <string.h>
#include "st.h"

#define N_MSG 16
#define LEN_S 80

typedef char str80[LEN_S + 1];

static void append(char *dst, const char *src)
{
  size_t n = strlen(dst), m = strlen(src);
  if (n + m > LEN_S)
    m = LEN_S - n;
  memcpy(dst + n, src, m);
  dst[n + m] = 0;
}

static void int_to_str(int32_t v, char *out)
{
  char tmp[12];
  int n = 0;
  uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
  do {
    tmp[n++] = (char)('0' + u % 10);
    u /= 10;
  } while (u);
  if (v < 0)
    *out++ = '-';
  while (n > 0)
    *out++ = tmp[--n];
  *out = 0;
}

static int32_t str_to_int(const char *s)
{
  int32_t v = 0;
  int neg = 0;
  if (*s == '-') {
    neg = 1;
    s++;
  }
  while (*s >= '0' && *s <= '9')
    v = v * 10 + (*s++ - '0');
  return neg ? -v : v;
}

/* position from 1, 0 if not there */
static int find(const char *s, const char *t)
{
  const char *p = strstr(s, t);
  return p ? (int)(p - s) + 1 : 0;
}

/* n characters from position p (from 1) */
static void mid(char *dst, const char *src, int n, int p)
{
  int len = (int)strlen(src);
  if (p > len || n < 0)
    n = 0;
  else if (p - 1 + n > len)
    n = len - (p - 1);
  memcpy(dst, src + p - 1, (size_t)n);
  dst[n] = 0;
}

static void left(char *dst, const char *src, int n)
{
  mid(dst, src, n, 1);
}

static void right(char *dst, const char *src, int n)
{
  int len = (int)strlen(src);
  if (n > len)
    n = len;
  memcpy(dst, src + len - n, (size_t)n + 1);
}

/* in place */
static void delete(char *s, int n, int p)
{
  int len = (int)strlen(s);
  if (p > len)
    return;
  if (p - 1 + n > len)
    n = len - (p - 1);
  memmove(s + p - 1, s + p - 1 + n, (size_t)(len - (p - 1) - n) + 1);
}

static void insert(char *s, const char *t, int p)
{
  int len = (int)strlen(s), m = (int)strlen(t);
  if (len + m > LEN_S)
    return;
  memmove(s + p + m, s + p, (size_t)(len - p) + 1);
  memcpy(s + p, t, (size_t)m);
}

static void replace(char *s, const char *t, int n, int p)
{
  delete(s, n, p);
  insert(s, t, p - 1);
}

static const char names[4][16] = {"Temp", "Pressure", "Flow", "Level"};
static const char units[4][8] = {"degC", "bar", "l/min", "mm"};
static str80 msgs[N_MSG];
static int32_t seed = 5;

void scan(void)
{
  str80 line, token, best;
  char key[21], num[21], h1[6], h2[6];
  int32_t acc = 0;
  int16_t value;
  int i, p, q;

  for (i = 0; i < N_MSG; i++) {
    seed = (seed * 421 + 1663) % 7875;
    value = (int16_t)(seed - 2000);
    strcpy(msgs[i], names[i % 4]);
    append(msgs[i], "[");
    int_to_str(i, num);
    append(msgs[i], num);
    append(msgs[i], "]=");
    int_to_str(value, num);
    append(msgs[i], num);
    append(msgs[i], " ");
    append(msgs[i], units[i % 4]);
    append(msgs[i], ";st=");
    int_to_str(seed * 13, num);
    append(msgs[i], num);
    append(msgs[i], ";");
    acc += (int32_t)strlen(msgs[i]);
  }

  for (i = 0; i < N_MSG; i++) {
    strcpy(line, msgs[i]);
    p = find(line, "=");
    q = find(line, " ");
    mid(num, line, q - p - 1, p + 1);
    value = (int16_t)str_to_int(num);
    acc += value;
    p = find(line, ";");
    while (p > 0) {
      left(token, line, p - 1);
      delete(line, p, 1);
      q = find(token, "=");
      left(key, token, q - 1);
      if (strcmp(key, "st") == 0) {
        right(num, token, (int)strlen(token) - q);
        acc += str_to_int(num) % 97;
      } else {
        acc += (int32_t)strlen(key);
      }
      p = find(line, ";");
    }
  }

  i = 0;
  do {
    strcpy(line, msgs[i]);
    p = find(line, "degC");
    if (p > 0) {
      replace(line, "Kelvin", 4, p);
    } else {
      p = find(line, "[");
      insert(line, "_act", p - 1);
    }
    p = find(line, ";st=");
    delete(line, 3, p + 1);
    acc += (int32_t)strlen(line) * 3 + p;
    strcpy(msgs[i], line);
    i++;
  } while (i < N_MSG);

  strcpy(best, msgs[0]);
  for (i = 1; i < N_MSG; i++) {
    if (strcmp(msgs[i], best) > 0) {
      strcpy(best, msgs[i]);
      acc += i;
    }
    left(h1, msgs[i], 5);
    left(h2, msgs[i - 1], 5);
    if (strcmp(h1, h2) == 0)
      acc += 100;
  }
  acc += (int32_t)strlen(best) + find(best, "];");

  check = (int32_t)((uint32_t)check * 31u + (uint32_t)acc);
}
