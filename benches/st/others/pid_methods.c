#include "iec_timers.h"
typedef struct { float kp, ki, kd, lo, hi; } Tuning;
typedef struct { float out, integral, last; } Pid;
static Tuning T = { 1.5f, 0.25f, 0.05f, -50.0f, 50.0f }; static Pid loops[65]; static float temp[65]; static int32_t scans;
static float clampf(float x, const Tuning *t) { return x > t->hi ? t->hi : x < t->lo ? t->lo : x; }
static float step(Pid *p, float sp, float pv, float dt, const Tuning *t) {
  float err = sp - pv;
  p->integral = clampf(p->integral + err * dt * t->ki, t);
  p->out = clampf(t->kp * err + p->integral + t->kd * (err - p->last) / dt, t);
  p->last = err;
  return p->out;
}
void scan(void) {
  scans++;
  float bias = (float)(scans / 50 % 20) - 30.0f, total = 0;
  for (int i = 1; i <= 64; i++) {
    float u = step(&loops[i], bias + (float)i, temp[i], 0.1f, &T);
    temp[i] = temp[i] + (u - temp[i] * 0.5f) * 0.05f;
    float o = loops[i].out; if (o < 0) o = -o;
    total = total + o + temp[i] * 0.1f;
  }
  int32_t x = (int32_t)(total * 4.0f); if (x < 0) x = -x;
  check = (check * 31 + x % 10007) % 1000003;
}
