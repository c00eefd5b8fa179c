/* Timers, counters and edges of IEC 61131-3 once more, as another one writes them in C, with times in microseconds. */
#include "st.h"
#include <stdint.h>
#include <stdbool.h>
#include <string.h>
typedef struct { bool q, run; int64_t et, start; } Ton;
static inline void ton(Ton *t, bool in, int64_t pt) {
  if (!in) { t->run = t->q = false; t->et = 0; return; }
  if (!t->run) { t->run = true; t->start = now_us; }
  int64_t e = now_us - t->start; if (e > pt) e = pt;
  t->et = e; t->q = e >= pt;
}
typedef struct { bool q, run; int64_t et, start; } Tof;
static inline void tof(Tof *t, bool in, int64_t pt) {
  if (in) { t->q = true; t->run = false; t->et = 0; return; }
  if (!t->q) return;
  if (!t->run) { t->run = true; t->start = now_us; }
  int64_t e = now_us - t->start; if (e > pt) e = pt;
  t->et = e; if (e >= pt) { t->q = false; t->run = false; }
}
typedef struct { bool q, run, last; int64_t et, start; } Tp;
static inline void tp(Tp *t, bool in, int64_t pt) {
  if (!t->run && in && !t->last && !t->q) { t->run = true; t->start = now_us; t->q = true; }
  if (t->run) { int64_t e = now_us - t->start; if (e > pt) e = pt; t->et = e;
    if (e >= pt) { t->q = false; t->run = false; } }
  if (!t->run && !in) t->et = 0;
  t->last = in;
}
typedef struct { bool q, last; int16_t cv; } Ctu;
static inline void ctu(Ctu *c, bool cu, bool r, int16_t pv) {
  if (r) c->cv = 0; else if (cu && !c->last && c->cv < 32767) c->cv++;
  c->last = cu; c->q = c->cv >= pv;
}
typedef struct { bool q, last; int16_t cv; } Ctd;
static inline void ctd(Ctd *c, bool cd, bool ld, int16_t pv) {
  if (ld) c->cv = pv; else if (cd && !c->last && c->cv > -32768) c->cv--;
  c->last = cd; c->q = c->cv <= 0;
}
typedef struct { bool qu, qd, lu, ld; int16_t cv; } Ctud;
static inline void ctud(Ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv) {
  bool u = cu && !c->lu, d = cd && !c->ld; c->lu = cu; c->ld = cd;
  if (r) c->cv = 0; else if (ld) c->cv = pv;
  else if (!(u && d)) { if (u && c->cv < 32767) c->cv++; else if (d && c->cv > -32768) c->cv--; }
  c->qu = c->cv >= pv; c->qd = c->cv <= 0;
}
static inline bool rtrig(bool *m, bool clk) { bool q = clk && !*m; *m = clk; return q; }
static inline bool ftrig(bool *m, bool clk) { bool q = !clk && !*m; *m = !clk; return q; }
