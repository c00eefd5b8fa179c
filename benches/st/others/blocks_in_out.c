#include "iec_timers.h"
typedef struct { uint32_t total; uint16_t peak; bool low; } Meter;
typedef struct { uint8_t pos; bool alarm; } Valve;
typedef struct { int32_t alarms; Meter own; Valve v1, v2; } Pipe;
static Pipe pipes[200]; static Meter meters[10]; static int32_t scans;
static void meter(Meter *m, uint16_t flow) {
  m->total = (m->total + flow) % 1000000;
  uint16_t p = m->peak - m->peak / 16; m->peak = p > flow ? p : flow;
  m->low = flow < 20;
}
static void valve(Valve *v, Meter *m, uint16_t want) {
  meter(m, (uint16_t)(want * v->pos) / 10); v->alarm = m->low;
  if (v->alarm && v->pos < 100) { v->pos += 3; return; }
  if (m->peak > 500) v->pos /= 2; else if (v->pos > 0) v->pos--;
}
static void pipe(Pipe *p, Meter *shared, uint16_t want) {
  valve(&p->v1, &p->own, want);
  valve(&p->v2, shared, p->own.peak + 1);
  if (p->v1.alarm) p->alarms++;
  if (!p->v2.alarm) return;
  p->alarms = (p->alarms + p->v2.pos) % 10000;
}
void scan(void) {
  scans++; int32_t n = 0;
  for (int i = 0; i < 200; i++) { pipe(&pipes[i], &meters[i % 10], (scans * 13 + i * 29) % 90); n += pipes[i].alarms; }
  for (int i = 0; i < 10; i++) n += meters[i].total % 1000;
  check = (check * 31 + n % 100003) % 1000003;
}
