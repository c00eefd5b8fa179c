#include "iec_timers.h"
typedef struct { int level; bool lamp; Ton delay[4]; Tp pulse; Ctud buffer; Ctd batch; } Station;
typedef struct { int score; Station st[8]; } Line;
typedef struct { int score; Line l[10]; } Hall;
static Hall hall; static int32_t scans;
static void station(Station *s, bool enable, bool jam, int64_t base) {
  bool chain = enable;
  for (int i = 0; i < 4; i++) { ton(&s->delay[i], chain, base + 10000 * i); chain = s->delay[i].q; }
  tp(&s->pulse, chain, 20000);
  ctud(&s->buffer, s->pulse.q, jam, s->buffer.cv >= 9, false, 5);
  ctd(&s->batch, s->pulse.q && !jam, s->batch.q, 4);
  s->level = s->buffer.cv + s->batch.cv;
  s->lamp = s->buffer.qu || s->batch.q || s->pulse.q;
}
static void line(Line *l, int speed, int phase) {
  l->score = 0;
  for (int s = 1; s <= 7; s++) {
    station(&l->st[s], (phase + s) % 47 < 40, (phase + s * 3) % 11 == 0, 10000 * speed);
    if (l->st[s].lamp) l->score += l->st[s].level * s; else l->score--;
  }
}
void scan(void) {
  scans++;
  hall.score = 0;
  for (int i = -4; i <= 5; i++) {
    line(&hall.l[i + 4], (i < 0 ? -i : i) % 3 + 1, scans + i * 5 + 100);
    hall.score += hall.l[i + 4].score;
  }
  check = (check * 31 + hall.score + 1000) % 1000003;
}
