/* 64 PID loops with filtered derivative, anti-windup, rate limit; each drives a second-order plant */
#include <stdbool.h>
#include "st.h"

#define N_LOOPS 64
#define N_SUB 4

typedef struct {
  float kp, ki, kd, alpha, out_min, out_max, rate;
} pid_param;

typedef struct {
  float sp, pv;
  bool manual;
  float man_value;
  float out;
  bool saturated;
  float integral, last_pv, deriv;
} pid_loop;

typedef struct {
  float u, gain, t1, t2;
  float y;
  float x;
} plant;

static float limitf(float mn, float in, float mx)
{
  if (in < mn)
    in = mn;
  if (in > mx)
    in = mx;
  return in;
}

static void pid_call(pid_loop *p, const pid_param *par)
{
  float limited;
  float err = p->sp - p->pv;
  p->deriv = p->deriv + par->alpha * ((p->last_pv - p->pv) - p->deriv);
  p->last_pv = p->pv;
  if (p->manual) {
    limited = limitf(par->out_min, p->man_value, par->out_max);
    p->integral = limited - par->kp * err;
    p->saturated = false;
  } else {
    float raw = par->kp * err + p->integral + par->kd * p->deriv;
    limited = limitf(par->out_min, raw, par->out_max);
    p->saturated = limited != raw;
    if (!p->saturated || (raw > limited && err < 0.0f) || (raw < limited && err > 0.0f))
      p->integral = p->integral + par->ki * err;
  }
  p->out = p->out + limitf(-par->rate, limited - p->out, par->rate);
}

static void plant_call(plant *p)
{
  p->x = p->x + p->t1 * (p->gain * p->u - p->x);
  p->y = p->y + p->t2 * (p->x - p->y);
}

static bool ready;
static pid_loop loops[N_LOOPS];
static plant plants[N_LOOPS];
static pid_param params[N_LOOPS];
static float setpoints[N_LOOPS];
static int16_t tick;

void scan(void)
{
  int i, s;
  if (!ready) {
    for (i = 0; i < N_LOOPS; i++) {
      params[i].kp = 0.8f + (float)(i % 8) * 0.1f;
      params[i].ki = 0.01f + (float)(i % 5) * 0.005f;
      params[i].kd = 0.2f;
      params[i].alpha = 0.3f;
      params[i].out_min = 0.0f;
      params[i].out_max = 100.0f;
      params[i].rate = 2.0f + (float)(i % 3);
      setpoints[i] = 20.0f + (float)i;
    }
    ready = true;
  }

  tick++;
  if (tick >= 1000)
    tick = 0;
  i = tick % N_LOOPS;
  setpoints[i] = 90.0f - setpoints[i] * 0.5f;

  int32_t n_sat = 0;
  s = 0;
  do {
    for (i = 0; i < N_LOOPS; i++) {
      loops[i].sp = setpoints[i];
      loops[i].pv = plants[i].y;
      loops[i].manual = (i % 16 == 15) && (tick < 200);
      loops[i].man_value = 35.0f;
      pid_call(&loops[i], &params[i]);
      plants[i].u = loops[i].out;
      plants[i].gain = 1.2f;
      plants[i].t1 = 0.05f;
      plants[i].t2 = 0.1f;
      plant_call(&plants[i]);
      if (loops[i].saturated)
        n_sat++;
    }
    s++;
  } while (s < N_SUB);

  float sum = 0.0f;
  for (i = 0; i < N_LOOPS; i++)
    sum = sum + plants[i].y + loops[i].out;
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum * 10.0f) + (uint32_t)n_sat);
}
