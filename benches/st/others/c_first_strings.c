/* 40 rounds of string work */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAXLEN 80

typedef struct { uint8_t len; char s[MAXLEN]; } str_t;

static const str_t digits = {16, "0123456789ABCDEF"};
static const str_t motor = {5, "Motor"};
static const str_t dash = {1, "-"};
static const str_t mark = {3, "<x>"};
static const str_t oh = {2, "or"};

static void str_copy(str_t *d, const str_t *a)
{
  d->len = a->len;
  memcpy(d->s, a->s, a->len);
}

static void str_append(str_t *d, const str_t *a)
{
  int n = a->len;
  if (d->len + n > MAXLEN) n = MAXLEN - d->len;
  memcpy(d->s + d->len, a->s, n);
  d->len += n;
}

/* d must not be a; len characters from position pos (from 1) on */
static void str_mid(str_t *d, const str_t *a, int len, int pos)
{
  if (pos > a->len) len = 0;
  else if (len > a->len - pos + 1) len = a->len - pos + 1;
  d->len = len;
  memcpy(d->s, a->s + pos - 1, len);
}

static void str_left(str_t *d, const str_t *a, int len)
{
  if (len > a->len) len = a->len;
  d->len = len;
  memcpy(d->s, a->s, len);
}

static void str_right(str_t *d, const str_t *a, int len)
{
  if (len > a->len) len = a->len;
  d->len = len;
  memcpy(d->s, a->s + a->len - len, len);
}

/* in place: len characters from pos on become b */
static void str_replace(str_t *d, const str_t *b, int len, int pos)
{
  int tail = pos - 1 + len, n_tail, n_b = b->len;
  if (tail > d->len) tail = d->len;
  n_tail = d->len - tail;
  if (pos - 1 + n_b > MAXLEN) n_b = MAXLEN - (pos - 1);
  if (pos - 1 + n_b + n_tail > MAXLEN) n_tail = MAXLEN - (pos - 1 + n_b);
  memmove(d->s + pos - 1 + n_b, d->s + tail, n_tail);
  memcpy(d->s + pos - 1, b->s, n_b);
  d->len = pos - 1 + n_b + n_tail;
}

/* behind the character pos */
static void str_insert(str_t *d, const str_t *b, int pos)
{
  str_replace(d, b, 0, pos + 1);
}

static void str_delete(str_t *d, int len, int pos)
{
  int tail = pos - 1 + len;
  if (pos > d->len) return;
  if (tail > d->len) tail = d->len;
  memmove(d->s + pos - 1, d->s + tail, d->len - tail);
  d->len = pos - 1 + d->len - tail;
}

static int str_find(const str_t *a, const str_t *b)
{
  for (int i = 0; i + b->len <= a->len; i++)
    if (memcmp(a->s + i, b->s, b->len) == 0) return i + 1;
  return 0;
}

static int str_cmp(const str_t *a, const str_t *b)
{
  int n = a->len < b->len ? a->len : b->len;
  int d = memcmp(a->s, b->s, n);
  return d ? d : a->len - b->len;
}

static str_t names[40];
static bool init_done;
static int32_t n_scan;

void scan(void)
{
  str_t text, part, head, tail, digit, best;
  int i, j, p;
  int32_t sum;

  if (!init_done) {
    for (i = 0; i < 40; i++) {
      str_copy(&names[i], &motor);
      str_mid(&digit, &digits, 1, 1 + i / 8);
      str_append(&names[i], &digit);
      str_mid(&digit, &digits, 1, 1 + i % 8);
      str_append(&names[i], &digit);
    }
    init_done = true;
  }
  /* one digit of one name changes */
  str_mid(&digit, &digits, 1, 1 + n_scan * 7 % 16);
  str_replace(&names[n_scan % 40], &digit, 1, 6 + n_scan / 40 % 2);

  sum = 0;
  best.len = 0;
  for (i = 0; i < 40; i++) {
    j = (i * 3 + n_scan) % 40;
    str_copy(&text, &names[i]);
    str_append(&text, &dash);
    str_append(&text, &names[j]);
    str_mid(&part, &text, 5, 1 + i % 8);
    str_replace(&text, &part, 3, 2);
    str_insert(&text, &mark, 1 + i % 6);
    str_delete(&text, 2, 4 + i % 3);
    sum += str_find(&text, &oh) * 3;
    str_right(&tail, &names[j], 2);
    p = str_find(&text, &tail);
    if (p > 0) sum += p * 5;
    str_left(&head, &text, 6);
    str_right(&tail, &text, 7);
    if (str_cmp(&head, &tail) < 0) sum += i;
    if (str_cmp(&names[i], &names[j]) == 0) sum += 100;
    if (str_cmp(&tail, &best) > 0) {
      str_copy(&best, &tail);
      sum += 2 * i;
    }
    sum += text.len;
  }
  check = (check * 13 + sum) % 1000003;
  n_scan++;
}
