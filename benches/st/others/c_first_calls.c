/* 200 objects whose step calls functions, and 500 calls of functions in a loop */
#include <stdbool.h>
#include "st.h"

static int32_t clamp(int32_t v, int32_t lo, int32_t hi)
{
  if (v < lo) return lo;
  if (v > hi) return hi;
  return v;
}

static int32_t scale(int32_t v, int32_t num, int32_t den, int32_t off)
{
  return v * num / den + off;
}

static int32_t blend(int32_t p, int32_t q, int32_t w)   /* w of 16 parts p, the rest q */
{
  return (p * w + q * (16 - w)) / 16;
}

static int32_t hash3(int32_t h, int32_t v, int32_t w)
{
  return (h * 31 + v * 7 + w) % 65521;
}

typedef struct {
  int32_t state;
  int32_t y, hits;
  bool high;
} cell_t;

static void cell_step(cell_t *c, int32_t in1, int32_t in2, bool hold)
{
  if (!hold)
    c->state = clamp(scale(c->state + in1, 3, 4, in2), -2000, 2000);
  c->y = blend(c->state, in1, 10);
  c->high = c->y > 500;
  if (c->high) c->hits = (c->hits + 1) % 1000;
}

static cell_t cells[200];
static int32_t n_scan;

void scan(void)
{
  int32_t i, prev, sum, rnd;

  rnd = (n_scan * 7919 + 5) % 65536;
  prev = rnd % 1000 - 500;
  sum = 0;
  for (i = 0; i < 200; i++) {
    cell_step(&cells[i], prev, (n_scan * 3 + i * 17) % 400 - 180, (n_scan + i) % 9 == 0);
    prev = cells[i].y;
    if (cells[i].high) sum++;
    sum += cells[i].hits;
  }
  for (i = 0; i < 500; i++) {
    if (i % 4 == 0)
      rnd = hash3(rnd, i, n_scan);
    else
      sum += clamp(scale(i - 250, n_scan % 50 + 1, 8, rnd % 64), -700, 900);
  }
  check = (check + sum + prev + rnd) % 1000003;
  n_scan++;
}
