#include "iec_timers.h"
typedef struct { int32_t sp, pv; int64_t integ; int32_t hist[4]; uint8_t head; int32_t last, period; } Loop;
typedef struct { char name[13]; Loop loops[9]; } Zone;
static Zone zones[8]; static int32_t scans, now;
static int32_t clip(int64_t x, int32_t lim) { return x < -lim ? -lim : x > lim ? lim : (int32_t)x; }
static int32_t dead(int32_t e, int32_t w) { return (e < 0 ? -e : e) < w ? 0 : e; }
static int32_t control(Loop *p) {
  int32_t dt = now - p->last;
  if (dt < p->period) return p->hist[p->head];
  p->last = now;
  int32_t err = dead(p->sp - p->pv, 5);
  p->integ = clip(p->integ + (int64_t)err * dt, 400000);
  int32_t slope = err - p->hist[(p->head + 2) % 4];
  p->head = (p->head + 1) % 4;
  p->hist[p->head] = err;
  return clip((int64_t)err * 3 + p->integ / 256 + (int64_t)slope * 100 / dt, 10000);
}
void scan(void) {
  scans++; now += 10;
  int32_t sum = 0;
  for (int z = 0; z < 8; z++) for (int l = 1; l <= 8; l++) {
    Loop *p = &zones[z].loops[l];
    if (scans == 1) p->period = 10 + 10 * (l / 5);
    p->sp = (scans / 40 + z * 13 + l * 7) % 100 * 10;
    int32_t out = control(p);
    p->pv += (out - p->pv) / 16;
    sum += (p->pv < 0 ? -p->pv : p->pv) + p->head;
  }
  check = (check * 31 + sum % 100003) % 1000003;
}
