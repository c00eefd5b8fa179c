/* 500 standard function blocks, times in milliseconds */
#include <stdbool.h>
#include "st.h"

static int32_t now_ms;

typedef struct { bool q, prev; int32_t et, t0; } ton_t;
typedef struct { bool q, prev; int32_t et, t0; } tof_t;
typedef struct { bool q, prev; int32_t et, t0; } tp_t;
typedef struct { bool q, prev; int16_t cv; } ctu_t;
typedef struct { bool q, prev; int16_t cv; } ctd_t;
typedef struct { bool qu, qd, prev_u, prev_d; int16_t cv; } ctud_t;
typedef struct { bool q, m; } trig_t;

static void ton_step(ton_t *t, bool in, int32_t pt)
{
  if (!in) {
    t->q = false;
    t->et = 0;
  } else {
    if (!t->prev) t->t0 = now_ms;
    int32_t e = now_ms - t->t0;
    t->q = e >= pt;
    t->et = t->q ? pt : e;
  }
  t->prev = in;
}

static void tof_step(tof_t *t, bool in, int32_t pt)
{
  if (in) {
    t->q = true;
    t->et = 0;
  } else if (t->q) {
    if (t->prev) t->t0 = now_ms;
    int32_t e = now_ms - t->t0;
    t->q = e < pt;
    t->et = t->q ? e : pt;
  }
  t->prev = in;
}

static void tp_step(tp_t *t, bool in, int32_t pt)
{
  if (!t->q && in && !t->prev) {
    t->q = true;
    t->t0 = now_ms;
  }
  if (t->q) {
    int32_t e = now_ms - t->t0;
    t->q = e < pt;
    t->et = t->q ? e : pt;
  }
  if (!t->q && !in) t->et = 0;
  t->prev = in;
}

static void ctu_step(ctu_t *c, bool cu, bool r, int16_t pv)
{
  if (r) c->cv = 0;
  else if (cu && !c->prev && c->cv < INT16_MAX) c->cv++;
  c->prev = cu;
  c->q = c->cv >= pv;
}

static void ctd_step(ctd_t *c, bool cd, bool ld, int16_t pv)
{
  if (ld) c->cv = pv;
  else if (cd && !c->prev && c->cv > INT16_MIN) c->cv--;
  c->prev = cd;
  c->q = c->cv <= 0;
}

static void ctud_step(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
  bool up = cu && !c->prev_u, down = cd && !c->prev_d;
  c->prev_u = cu;
  c->prev_d = cd;
  if (r) c->cv = 0;
  else if (ld) c->cv = pv;
  else if (up && !down) { if (c->cv < INT16_MAX) c->cv++; }
  else if (down && !up) { if (c->cv > INT16_MIN) c->cv--; }
  c->qu = c->cv >= pv;
  c->qd = c->cv <= 0;
}

static void r_trig(trig_t *t, bool clk) { t->q = clk && !t->m; t->m = clk; }
static void f_trig(trig_t *t, bool clk) { t->q = !clk && !t->m; t->m = !clk; }

static bool init_done;
static int32_t n_scan;
static bool sig[128];
static int32_t pt[100];
static ton_t tn[100];
static tof_t tf[100];
static tp_t tpu[100];
static ctu_t cu[60];
static ctd_t cd[40];
static ctud_t cud[40];
static trig_t rt[30], ft[30];

void scan(void)
{
  int32_t i, sum;

  now_ms = (int32_t)(now_us / 1000);
  if (!init_done) {
    for (i = 0; i < 100; i++) pt[i] = 10 * (1 + i % 23);
    init_done = true;
  }
  for (i = 0; i < 128; i++)
    sig[i] = (n_scan + 3 * i) % (7 + i) < 3 + i / 2;

  sum = 0;
  for (i = 0; i < 100; i++) {
    ton_step(&tn[i], sig[i], pt[i]);
    if (tn[i].q) sum += i;
    sum += tn[i].et;
  }
  for (i = 0; i < 100; i++) {
    tof_step(&tf[i], sig[i + 7], pt[i]);
    if (tf[i].q) sum += 2 * i;
    sum += tf[i].et;
  }
  for (i = 0; i < 100; i++) {
    tp_step(&tpu[i], sig[i + 14], pt[i]);
    if (tpu[i].q) sum += 3 * i;
    sum += tpu[i].et;
  }
  for (i = 0; i < 60; i++) {
    ctu_step(&cu[i], sig[i], cu[i].q && sig[127 - i], 12);
    sum += cu[i].cv;
  }
  for (i = 0; i < 40; i++) {
    ctd_step(&cd[i], tn[i].q, sig[100 + i % 20], 25);
    if (cd[i].q) sum += 5;
    sum += cd[i].cv;
  }
  for (i = 0; i < 40; i++) {
    ctud_step(&cud[i], sig[i], tf[i + 10].q, cud[i].qu, sig[i + 60] && sig[i + 61] && !sig[i], 9);
    if (cud[i].qu) sum += 11;
    if (cud[i].qd) sum += 7;
    sum += cud[i].cv;
  }
  for (i = 0; i < 30; i++) {
    r_trig(&rt[i], tpu[i].q);
    f_trig(&ft[i], tn[i + 30].q);
    if (rt[i].q) sum += 13;
    if (ft[i].q) sum += 17;
  }
  check = (check * 17 + sum) % 1000003;
  n_scan++;
}
