/* 500 timers and counters: 150 TON, 100 TOF, 100 TP, 100 CTU, 50 CTD, all from phase generators */
#include <stdbool.h>
#include "st.h"

#define N_TON 150
#define N_TOF 100
#define N_TP 100
#define N_CTU 100
#define N_CTD 50
#define N_ALL 500

typedef struct { bool in, q, m; int32_t pt, et; uint32_t start; } ton_t;
typedef struct { bool in, q, run; int32_t pt, et; uint32_t start; } tof_t;
typedef struct { bool in, q, m, run; int32_t pt, et; uint32_t start; } tp_t;
typedef struct { bool cu, r, q, m; int16_t pv, cv; } ctu_t;
typedef struct { bool cd, ld, q, m; int16_t pv, cv; } ctd_t;

static uint32_t now_ms;

static void ton(ton_t *t, bool in, int32_t pt)
{
  t->in = in;
  t->pt = pt;
  if (!in) {
    t->q = false;
    t->et = 0;
  } else {
    if (!t->m)
      t->start = now_ms;
    if (!t->q) {
      int32_t el = (int32_t)(now_ms - t->start);
      if (el >= pt) {
        t->q = true;
        t->et = pt;
      } else {
        t->et = el;
      }
    }
  }
  t->m = in;
}

static void tof(tof_t *t, bool in, int32_t pt)
{
  t->in = in;
  t->pt = pt;
  if (in) {
    t->q = true;
    t->et = 0;
    t->run = false;
  } else if (t->q) {
    if (!t->run) {
      t->run = true;
      t->start = now_ms;
    }
    int32_t el = (int32_t)(now_ms - t->start);
    if (el >= pt) {
      t->q = false;
      t->et = pt;
    } else {
      t->et = el;
    }
  }
}

static void tp(tp_t *t, bool in, int32_t pt)
{
  t->in = in;
  t->pt = pt;
  if (t->run) {
    int32_t el = (int32_t)(now_ms - t->start);
    if (el >= pt) {
      t->run = false;
      t->q = false;
      t->et = in ? pt : 0;
    } else {
      t->et = el;
    }
  } else if (in && !t->m) {
    t->start = now_ms;
    t->et = 0;
    t->run = pt > 0;
    t->q = t->run;
  } else if (!in) {
    t->et = 0;
  }
  t->m = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
  c->cu = cu;
  c->r = r;
  c->pv = pv;
  if (r)
    c->cv = 0;
  else if (cu && !c->m && c->cv < INT16_MAX)
    c->cv++;
  c->m = cu;
  c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
  c->cd = cd;
  c->ld = ld;
  c->pv = pv;
  if (ld)
    c->cv = pv;
  else if (cd && !c->m && c->cv > INT16_MIN)
    c->cv--;
  c->m = cd;
  c->q = c->cv <= 0;
}

static bool ready;
static ton_t tons[N_TON];
static tof_t tofs[N_TOF];
static tp_t tps[N_TP];
static ctu_t ctus[N_CTU];
static ctd_t ctds[N_CTD];
static int32_t presets[N_ALL];
static int16_t limits[N_ALL];
static int16_t phase[N_ALL];
static int16_t period[N_ALL];
static int16_t on_time[N_ALL];
static bool stim[N_ALL];

void scan(void)
{
  int i, k;
  now_ms = (uint32_t)(now_us / 1000);
  if (!ready) {
    for (i = 0; i < N_ALL; i++) {
      period[i] = 5 + (i * 7) % 41;
      on_time[i] = 1 + (i * 3) % period[i];
      phase[i] = i % period[i];
      presets[i] = 2 + (i * 13) % 29;
      limits[i] = 2 + i % 9;
    }
    ready = true;
  }

  for (i = 0; i < N_ALL; i++) {
    phase[i]++;
    if (phase[i] >= period[i])
      phase[i] = 0;
    stim[i] = phase[i] < on_time[i];
  }

  int32_t active = 0, elapsed = 0, counts = 0;
  k = 0;
  for (i = 0; i < N_TON; i++) {
    ton(&tons[i], stim[k], presets[k]);
    if (tons[i].q)
      active += 1;
    elapsed += tons[i].et;
    k++;
  }
  for (i = 0; i < N_TOF; i++) {
    tof(&tofs[i], stim[k], presets[k]);
    if (tofs[i].q)
      active += 3;
    elapsed += tofs[i].et;
    k++;
  }
  for (i = 0; i < N_TP; i++) {
    tp(&tps[i], stim[k], presets[k]);
    if (tps[i].q)
      active += 5;
    elapsed += tps[i].et;
    k++;
  }
  i = 0;
  while (i < N_CTU) {
    ctu(&ctus[i], stim[k] && !tons[i].q, ctus[i].q, limits[k]);
    counts += ctus[i].cv;
    i++;
    k++;
  }
  i = 0;
  do {
    ctd(&ctds[i], stim[k] || tps[i].q, ctds[i].q, limits[k]);
    counts += ctds[i].cv;
    i++;
    k++;
  } while (i < N_CTD);

  check = (int32_t)((uint32_t)check * 31u + (uint32_t)(active * 7 + elapsed + counts * 3));
}
