#include "iec_timers.h"
typedef struct { double x, y; uint8_t kind; } Point;
typedef struct { Point pts[5]; int32_t born; int32_t at; char title[16]; } Track;
typedef struct { Track tracks[5]; Track best; } Sector;
static Sector w[5], prev[5]; static int32_t scans;
static Point centre(const Track *t) {
  Point c = {0};
  for (int i = 0; i < 5; i++) { c.x += t->pts[i].x * 0.25; c.y += t->pts[i].y * 0.25; if (t->pts[i].kind > c.kind) c.kind = t->pts[i].kind; }
  return c;
}
static Track move(const Track *t, double dx, double dy) {
  Track m = *t;
  for (int i = 0; i < 5; i++) {
    double x = t->pts[i].x + dx;
    m.pts[i].x = x > 100 ? 100 : x < -100 ? -100 : x;
    m.pts[i].y = t->pts[4 - i].y * 0.5 + dy;
    switch (i) {
    case 0: m.pts[i].kind = t->pts[i].kind; break;
    case 1: m.pts[i].kind = t->pts[i].kind + 1; break;
    case 2: m.pts[i].kind = 3; break;
    case 3: m.pts[i].kind = t->pts[2].kind; break;
    default: m.pts[i].kind = 5;
    }
  }
  m.at = t->at + 1;
  return m;
}
void scan(void) {
  scans++; int32_t n = 0; double sum = 0;
  memcpy(prev, w, sizeof w);
  for (int s = 0; s < 5; s++) {
    for (int i = 1; i <= 4; i++) {
      Track *t = &w[s].tracks[i];
      if (scans % 200 == 1) {
        t->born = 19781; t->at = 36000;
        t->pts[2].kind = 1; t->pts[3].kind = 1; t->pts[1].kind = 0; t->pts[0].kind = 0;
      }
      *t = move(t, (double)(s - i) * 0.5, (double)(scans % 16));
      Point c = centre(t);
      if (c.x + c.y > sum || i == 1) w[s].best = *t;
      sum = sum * 0.5 + c.x - c.y + (double)c.kind;
      if (t->at >= 36300) n += s;
    }
    n += (int32_t)(w[s].best.pts[2].x - prev[4 - s].best.pts[3].y) + w[s].best.pts[1].kind;
    n += (19784 - w[s].best.born) * 86400 % 1000;
  }
  if (scans > 1) memcpy(w[2].tracks, prev[1].tracks, sizeof w[2].tracks);
  int32_t x = n + (int32_t)sum; if (x < 0) x = -x;
  check = (check * 31 + x % 10007) % 1000003;
}
