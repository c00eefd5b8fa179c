/* 200 calls of a measuring-channel block, which in turn calls functions and a nested block */
#include <stdbool.h>
#include "st.h"

static int32_t scale_raw(int16_t raw, int32_t lo, int32_t hi)
{
  return lo + raw * (hi - lo) / 27648;
}

static int32_t clamp_d(int32_t mn, int32_t v, int32_t mx)
{
  if (v < mn)
    return mn;
  else if (v > mx)
    return mx;
  return v;
}

static int32_t min_d(int32_t a, int32_t b) { return a < b ? a : b; }
static int32_t max_d(int32_t a, int32_t b) { return a > b ? a : b; }

static int32_t median3(int32_t a, int32_t b, int32_t c)
{
  return max_d(min_d(a, b), min_d(max_d(a, b), c));
}

static int16_t next_state(int16_t state, int32_t v, int32_t warn, int32_t alarm)
{
  int16_t r = state;
  switch (state) {
  case 0:
    if (v >= warn)
      r = 1;
    break;
  case 1:
    if (v >= alarm)
      r = 2;
    else if (v < warn - 50)
      r = 0;
    break;
  case 2:
    if (v < alarm - 50)
      r = 3;
    break;
  case 3:
    if (v < warn)
      r = 0;
    else if (v >= alarm)
      r = 2;
    break;
  default:
    r = 0;
  }
  return r;
}

#define LEN_W 4
typedef struct {
  int32_t value;
  int32_t sum;
  int32_t buf[LEN_W];
  int16_t pos;
} moving_sum;

static void moving_sum_call(moving_sum *m)
{
  m->sum = m->sum - m->buf[m->pos] + m->value;
  m->buf[m->pos] = m->value;
  m->pos++;
  if (m->pos >= LEN_W)
    m->pos = 0;
}

typedef struct {
  int16_t raw;
  int32_t lo, hi;
  bool enable;
  int32_t value;
  int16_t state;
  bool changed;
  int32_t h1, h2;
  moving_sum avg;
} channel;

static void channel_call(channel *c, int32_t *total, int32_t *n_alarms)
{
  if (!c->enable) {
    c->changed = c->state != 0;
    c->state = 0;
    return;
  }
  int32_t lo = c->lo, hi = c->hi;
  int32_t scaled = clamp_d(lo, scale_raw(c->raw, lo, hi), hi);
  c->avg.value = median3(scaled, c->h1, c->h2);
  moving_sum_call(&c->avg);
  c->h2 = c->h1;
  c->h1 = scaled;
  c->value = c->avg.sum / 4;
  int16_t new_state = next_state(c->state, c->value, lo + (hi - lo) / 2, lo + (hi - lo) * 3 / 4);
  c->changed = new_state != c->state;
  c->state = new_state;
  *total = *total + c->value;
  if (c->changed && c->state == 2)
    *n_alarms = *n_alarms + 1;
}

#define N_CH 200
static channel ch[N_CH];
static int16_t raws[N_CH];
static int32_t seed = 17;
static int32_t alarms;

void scan(void)
{
  int32_t total = 0, states = 0, changes = 0;
  if (alarms > 1000000)
    alarms = 0;
  int i = 0;
  while (i < N_CH) {
    seed = (seed * 421 + 1663) % 7875;
    raws[i] = raws[i] + (int16_t)(seed / 2);
    if (raws[i] > 27648)
      raws[i] = raws[i] - 27648;
    ch[i].raw = raws[i];
    ch[i].lo = -500;
    ch[i].hi = 1500 + i * 10;
    ch[i].enable = seed > 200;
    channel_call(&ch[i], &total, &alarms);
    states += ch[i].state;
    if (ch[i].changed)
      changes++;
    i++;
  }
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)(total + states * 5 + changes * 3 + alarms));
}
