#include "iec_timers.h"
enum { MOTORS = 168 };
typedef struct { Ton on; Tof off; Ctu starts; int64_t limit; bool running; } Motor;
static Motor motors[MOTORS + 1]; static int32_t scans;
void scan(void) {
  scans++;
  if (scans == 1) for (int i = 1; i <= MOTORS; i++) motors[i].limit = 10000 * (i % 7 + 1);
  int32_t sum = 0; int64_t total = 0;
  for (int i = MOTORS; i >= 1; i--) {
    Motor *m = &motors[i];
    bool cmd = (scans + i) % 23 < 12;
    ton(&m->on, cmd, m->limit);
    tof(&m->off, m->on.q, m->limit + 20000);
    m->running = m->off.q;
    ctu(&m->starts, m->running, m->starts.cv > 20, 10);
    if (!m->running) continue;
    total += m->on.et + m->off.et;
    sum += m->starts.cv;
    if (m->starts.q) sum += 1;
  }
  for (int i = 1; i <= MOTORS; i += 2) if (motors[i].running) sum += i;
  check = (check * 31 + sum + (int32_t)(total / 10 / 1000)) % 1000003;
}
