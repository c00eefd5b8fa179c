#include "iec_timers.h"
typedef struct { int64_t preset, started; bool active; uint16_t count; } Timer;
static Timer timers[500]; static int32_t scans, gExpired; static int64_t gNow; static Ton gTick;
static void start(Timer *t) { if (t->active) return; t->active = true; t->started = gNow; }
static void stop(Timer *t) { t->active = false; }
static int64_t elapsed(Timer *t) { if (!t->active) return 0; int64_t e = gNow - t->started; return e < t->preset ? e : t->preset; }
static bool expired(Timer *t) { bool r = t->active && elapsed(t) >= t->preset; if (r) gExpired++; return r; }
static uint16_t run(Timer *t, bool cmd) {
  if (cmd) start(t); else stop(t);
  if (expired(t)) { t->count = (t->count + 1) % 500; stop(t); }
  return t->count;
}
void scan(void) {
  scans++;
  ton(&gTick, !gTick.q, 50000);
  gNow += 10000;
  int32_t n = (int32_t)(gTick.et / 1000);
  for (int i = 0; i < 500; i++) {
    if (scans == 1) timers[i].preset = (20 + i % 10 * 10) * 1000;
    n += run(&timers[i], (scans + i) % 37 < 25);
    n += (int32_t)(elapsed(&timers[i]) / 1000) / 10;
  }
  check = (check * 31 + n + gExpired) % 1000003;
}
