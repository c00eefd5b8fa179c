/* 160 PID control loops with mode handling, each on a simulated second-order process */
#include <stdbool.h>
#include "st.h"

enum pid_mode { PID_OFF, PID_MANUAL, PID_AUTO };

typedef struct {
    float kp, tn, tv, tf, out_min, out_max, deadband, max_rate;
} PidPar;

typedef struct { float x, y; } Point;

typedef struct {
    float pv;
    bool hi, lo;
    float ring[8];
    int16_t nring;
} Sensor;

typedef struct {
    float out;
    bool busy;
} Ramp;

typedef struct {
    float out;
    bool lim_hi, lim_lo;
    float i, d, pv_old;
} Pid;

typedef struct {
    float out;
    float x1;
} Process;

static float limit(float mn, float in, float mx)
{
    if (in < mn)
        in = mn;
    if (in > mx)
        in = mx;
    return in;
}

/* sensor: linearization by a curve of ten points, mean of eight samples, limit alarms */
static void sensor(Sensor *s, float raw, float hi, float lo, float hyst, const Point curve[10])
{
    int k;
    float lin, sum;

    if (raw <= curve[0].x) {
        lin = curve[0].y;
    } else if (raw >= curve[9].x) {
        lin = curve[9].y;
    } else {
        k = 1;
        while (raw > curve[k].x)
            k++;
        lin = curve[k - 1].y + (raw - curve[k - 1].x) * (curve[k].y - curve[k - 1].y)
              / (curve[k].x - curve[k - 1].x);
    }

    s->ring[s->nring] = lin;
    s->nring++;
    if (s->nring > 7)
        s->nring = 0;
    sum = 0.0f;
    for (k = 0; k < 8; k++)
        sum += s->ring[k];
    s->pv = sum / 8.0f;

    if (s->pv > hi)
        s->hi = true;
    else if (s->pv < hi - hyst)
        s->hi = false;
    if (s->pv < lo)
        s->lo = true;
    else if (s->pv > lo + hyst)
        s->lo = false;
}

/* set point ramp */
static void ramp(Ramp *s, float target, float up, float down, float cycle)
{
    if (s->out < target) {
        s->out += up * cycle;
        if (s->out > target)
            s->out = target;
    } else if (s->out > target) {
        s->out -= down * cycle;
        if (s->out < target)
            s->out = target;
    }
    s->busy = s->out != target;
}

static void pid(Pid *s, enum pid_mode mode, float sp, float pv, float man, float cycle, const PidPar *par)
{
    float err, p, raw, step;

    err = sp - pv;
    if ((err < 0.0f ? -err : err) < par->deadband)
        err = 0.0f;

    switch (mode) {
    case PID_OFF:
        s->out = par->out_min;
        s->i = 0.0f;
        s->d = 0.0f;
        s->lim_hi = false;
        s->lim_lo = false;
        break;

    case PID_MANUAL:
        s->out = limit(par->out_min, man, par->out_max);
        /* bumpless: the integrator follows */
        s->i = s->out - par->kp * err;
        s->d = 0.0f;
        s->lim_hi = false;
        s->lim_lo = false;
        break;

    case PID_AUTO:
        p = par->kp * err;
        if (par->tn > 0.0f) {
            if (!(s->lim_hi && err > 0.0f) && !(s->lim_lo && err < 0.0f))
                s->i = s->i + p * cycle / par->tn;
        } else {
            s->i = 0.0f;
        }
        s->d = s->d + (par->kp * par->tv * (s->pv_old - pv) / cycle - s->d) * cycle / (par->tf + cycle);
        raw = p + s->i + s->d;
        step = par->max_rate * cycle;
        raw = limit(s->out - step, raw, s->out + step);
        s->lim_hi = raw > par->out_max;
        s->lim_lo = raw < par->out_min;
        s->out = limit(par->out_min, raw, par->out_max);
        break;
    }
    s->pv_old = pv;
}

static void process(Process *s, float in, float gain, float t1, float t2, float load, float cycle)
{
    s->x1 = s->x1 + (in * gain - s->x1) * cycle / t1;
    s->out = s->out + (s->x1 - load - s->out) * cycle / t2;
}

#define LOOPS 160
#define CYCLE 0.1f

static Pid pids[LOOPS];
static Sensor sensors[LOOPS];
static Ramp ramps[LOOPS];
static Point curve[10];
static Process procs[LOOPS];
static PidPar pars[LOOPS];
static enum pid_mode modes[LOOPS];
static float sps[LOOPS];
static int16_t timers[LOOPS];
static bool init;

void scan(void)
{
    int i;
    float sum = 0.0f;
    int16_t limited = 0, alarms = 0, busy = 0;

    if (!init) {
        for (i = 0; i < LOOPS; i++) {
            int n = i + 1;
            pars[i].kp = 0.8f + (float)(n % 64) * 0.02f;
            pars[i].tn = 4.0f + (float)(n % 8);
            pars[i].tv = 0.3f;
            pars[i].tf = 0.2f;
            pars[i].out_min = 0.0f;
            pars[i].out_max = 100.0f;
            pars[i].deadband = 0.05f;
            pars[i].max_rate = 40.0f;
            sps[i] = 20.0f + (float)(n % 64);
            timers[i] = n * 3;
            modes[i] = PID_AUTO;
        }
        for (i = 0; i < 10; i++) {
            curve[i].x = (float)i * 13.0f;
            curve[i].y = (float)i * 11.0f + (float)(i * i) * 0.2f;
        }
        init = true;
    }

    for (i = 0; i < LOOPS; i++) {
        /* operator: changes the set point and now and then the mode */
        timers[i]++;
        if (timers[i] == 300) {
            sps[i] = 90.0f - (float)((i + 1) % 64);
        } else if (timers[i] == 600) {
            modes[i] = PID_MANUAL;
        } else if (timers[i] == 660) {
            modes[i] = PID_AUTO;
            sps[i] = 20.0f + (float)((i + 1) % 64);
        } else if (timers[i] == 900) {
            modes[i] = PID_OFF;
        } else if (timers[i] >= 930) {
            modes[i] = PID_AUTO;
            timers[i] = 0;
        }

        sensor(&sensors[i], procs[i].out, 80.0f, 15.0f, 2.0f, curve);
        ramp(&ramps[i], sps[i], 2.0f, 3.0f, CYCLE);
        pid(&pids[i], modes[i], ramps[i].out, sensors[i].pv, 35.0f, CYCLE, &pars[i]);
        process(&procs[i], pids[i].out, 1.2f, 2.0f, 5.0f, (float)timers[i] * 0.005f, CYCLE);

        sum = sum + pids[i].out + procs[i].out;
        if (pids[i].lim_hi || pids[i].lim_lo)
            limited++;
        if (sensors[i].hi || sensors[i].lo)
            alarms++;
        if (ramps[i].busy)
            busy++;
    }
    check = (int32_t)((uint32_t)check * 31u + (int32_t)(sum * 10.0f) + limited + alarms * 7 + busy * 13);
}
