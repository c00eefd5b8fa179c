#include "iec_timers.h"
typedef struct { bool req, ack, run, fault; int cnt; } Cell;
typedef struct { bool latch, prio, e, f; bool busy; } Interlock;
typedef struct { Interlock l[9]; uint16_t mask; } Rack;
static Rack racks[17]; static Cell cells[17][9]; static int32_t scans;
static void interlock(Interlock *s, Cell *c, bool up, bool down, bool stop) {
  bool t = (up && !stop) || (c->ack && (down != c->run));
  s->latch = !(stop || c->fault) && (t || s->latch);
  s->prio = (down && !up) || (!c->ack && s->prio);
  bool eq = rtrig(&s->e, s->latch), fq = ftrig(&s->f, s->prio || t);
  if (eq) { c->cnt = (c->cnt + 1) % 100; c->ack = !c->ack; }
  else if (fq && !up) c->fault = !c->fault;
  else if (stop) c->fault = false;
  c->run = s->latch && !s->prio;
  c->req = up != down;
  s->busy = c->run || (c->req && !c->fault);
}
static void rack(Rack *r, Cell *c, uint16_t p) {
  r->mask = 0; bool prev = false;
  for (int i = 1; i <= 8; i++) {
    interlock(&r->l[i], &c[i], (p >> i) & 1, prev, ((p >> (i + 4)) & 3) == 3);
    prev = r->l[i].busy;
    if (prev) r->mask |= 1 << i;
  }
}
void scan(void) {
  scans++;
  for (int i = 1; i <= 16; i++) {
    rack(&racks[i], cells[i], (scans * 37 + i * 1237) % 65536);
    check = (check * 31 + racks[i].mask + cells[i][3].cnt + cells[i][7].cnt) % 1000003;
  }
}
