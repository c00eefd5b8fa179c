/* 64 PID loops with anti-windup, each on a lag of first order, sometimes disturbed */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define TS 0.01f

typedef struct {
  float integ, dfilt, pv_last;
  float out;
  bool sat;
} pid_ctl_t;

static void pid_step(pid_ctl_t *c, float sp, float pv, float kp, float ki, float kd, float lo, float hi)
{
  float err, u;

  err = sp - pv;
  c->dfilt = c->dfilt + 0.2f * ((c->pv_last - pv) / TS - c->dfilt);
  u = kp * err + c->integ + kd * c->dfilt;
  c->sat = true;
  if (u > hi) c->out = hi;
  else if (u < lo) c->out = lo;
  else {
    c->out = u;
    c->sat = false;
  }
  /* integrate only when that does not drive the output further into saturation */
  if (!c->sat || (u > hi && err < 0.0f) || (u < lo && err > 0.0f))
    c->integ = c->integ + ki * err * TS;
  c->pv_last = pv;
}

static pid_ctl_t pid[LOOPS];
static float y[LOOPS], sp[LOOPS], kp[LOOPS], tau[LOOPS], dist[LOOPS];
static bool init_done;
static int32_t n_scan, rnd;

void scan(void)
{
  int i, n_sat;
  float sum;

  if (!init_done) {
    for (i = 0; i < LOOPS; i++) {
      kp[i] = 1.5f + (float)i * 0.05f;
      tau[i] = 0.4f + (float)(i % 7) * 0.1f;
    }
    init_done = true;
  }

  rnd = (n_scan * 7919 + 101) % 65536;
  for (i = 0; i < LOOPS; i++) {
    if ((n_scan + 11 * i) % 200 == 0) {   /* a new set point */
      rnd = (rnd * 25173 + 13849) % 65536;
      sp[i] = (float)(rnd % 1000) / 10.0f;
    }
    if ((n_scan + 5 * i) % 64 == 0) {     /* a new disturbance */
      rnd = (rnd * 25173 + 13849) % 65536;
      dist[i] = (float)(rnd % 200 - 100) / 4.0f;
    }
  }

  sum = 0.0f;
  n_sat = 0;
  for (i = 0; i < LOOPS; i++) {
    pid_step(&pid[i], sp[i], y[i], kp[i], 2.0f, 0.02f, 0.0f, 100.0f);
    y[i] = y[i] + TS * ((1.2f * pid[i].out - y[i]) / tau[i] + dist[i]);
    sum = sum + pid[i].out - 0.5f * y[i];
    if (pid[i].sat) n_sat++;
  }
  check = (check + (int32_t)(sum * 10.0f) + 1000 * n_sat) % 1000003;
  n_scan++;
}
