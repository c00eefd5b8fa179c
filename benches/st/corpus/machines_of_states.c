#include "iec_timers.h"
typedef enum { Idle, Filling, Heating, Mixing, Draining, Cleaning, Failed } Step;
typedef struct { bool inlet, outlet, heater, mixer, alarm; } Valves;
typedef struct { Step state; uint8_t ticks; Valves v; uint16_t done; } Tank;
static Tank tanks[100]; static int32_t scans; static uint32_t lfsr = 0x1234ABCD;
static bool sensor(uint32_t b, int nr, bool inv) { return ((b >> nr) & 1) != inv; }
static void sequencer(Tank *t, uint32_t bits) {
  bool full = sensor(bits, 0, false), hot = sensor(bits, 1, false), empty = sensor(bits, 2, true);
  bool estop = sensor(bits, 5, false) && sensor(bits, 6, false) && sensor(bits, 7, false);
  Step old = t->state;
  if (estop && t->state != Failed) { t->state = Failed; t->v = (Valves){0}; t->v.alarm = true; return; }
  switch (t->state) {
  case Idle: t->v = (Valves){0}; if (empty) t->state = Filling; break;
  case Filling: t->v.inlet = !full; if (full) t->state = hot ? Mixing : Heating; break;
  case Heating: t->v.heater = !hot; if (hot || t->ticks > 5) t->state = Mixing; break;
  case Mixing: t->v.heater = false; t->v.mixer = t->ticks % 2 == 0; if (t->ticks >= 3) t->state = Draining; break;
  case Draining: case Cleaning:
    t->v.mixer = false; t->v.outlet = !empty;
    if (empty) { if (t->state == Draining) t->state = Cleaning; else { t->state = Idle; t->done = (t->done + 1) % 1000; } }
    break;
  default: if (t->ticks > 2 && !estop) { t->v.alarm = false; t->state = Idle; }
  }
  if (t->state == old) { if (t->ticks < 200) t->ticks++; } else t->ticks = 0;
}
void scan(void) {
  scans++; int32_t sum = 0;
  for (int i = 99; i >= 0; i--) {
    lfsr = (lfsr & 1) ? (lfsr >> 1) ^ 0xEDB88320u : lfsr >> 1;
    Tank *t = &tanks[i];
    sequencer(t, lfsr);
    sum += t->done + t->ticks;
    if (t->v.inlet) sum += 1;
    if (t->v.outlet) sum += 3;
    if (t->v.heater) sum += 7;
    if (t->v.mixer) sum += 13;
    if (t->v.alarm) sum += 17;
  }
  check = (check * 31 + sum) % 1000003;
}
