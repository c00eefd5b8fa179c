/* 64 control loops: flow, pressure, chlorine, pH, each with a simple model of the process */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N_LOOPS 64
#define DT 0.1f

typedef enum { MANUAL, AUTOMATIC, TRACKING } pid_mode_t;

typedef struct {
    float kp, ti, td, out_min, out_max, dead_band, ramp;
} pid_para_t;

typedef struct {
    float out;
    bool lim_high, lim_low, dev_alarm;
    float sp_ramp, integ, dfilt, old_pv;
    int16_t dev_count;
} pid_fb_t;

static pid_fb_t loop[N_LOOPS];
static pid_para_t para[N_LOOPS];
static float pv[N_LOOPS], sp[N_LOOPS];
static int32_t scans;
static bool init;

static float limit(float lo, float x, float hi)
{
    if (x < lo) return lo;
    if (x > hi) return hi;
    return x;
}

static void pid(pid_fb_t *l, const pid_para_t *pa, float s, float v, pid_mode_t mode, float man_out, float dt)
{
    if (s > l->sp_ramp + pa->ramp * dt)
        l->sp_ramp += pa->ramp * dt;
    else if (s < l->sp_ramp - pa->ramp * dt)
        l->sp_ramp -= pa->ramp * dt;
    else
        l->sp_ramp = s;

    float err = l->sp_ramp - v;
    if (fabsf(err) < pa->dead_band)
        err = 0.0f;

    float p = pa->kp * err;
    l->dfilt += 0.25f * ((l->old_pv - v) / dt - l->dfilt);
    float d = pa->kp * pa->td * l->dfilt;
    l->old_pv = v;

    if (mode == AUTOMATIC) {
        float raw = p + l->integ + d;
        l->lim_high = raw >= pa->out_max;
        l->lim_low = raw <= pa->out_min;
        l->out = limit(pa->out_min, raw, pa->out_max);
        if ((!l->lim_high && !l->lim_low) || (l->lim_high && err < 0.0f) || (l->lim_low && err > 0.0f)) {
            if (pa->ti > 0.0f)
                l->integ += pa->kp * err * dt / pa->ti;
        }
    } else {
        float target = mode == MANUAL ? man_out : v;
        l->out = limit(pa->out_min, target, pa->out_max);
        l->integ = l->out - p - d;
        l->lim_high = l->lim_low = false;
    }
    l->integ = limit(pa->out_min, l->integ, pa->out_max);

    if (fabsf(s - v) > 10.0f) {
        if (l->dev_count < 20)
            l->dev_count++;
    } else
        l->dev_count = 0;
    l->dev_alarm = l->dev_count >= 20;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N_LOOPS; i++) {
            int n = i + 1;
            para[i] = (pid_para_t){ 1.0f, 10.0f, 0.0f, 0.0f, 100.0f, 0.05f, 5.0f };
            para[i].kp = 0.5f + (float)(n % 8) * 0.25f;
            para[i].ti = 2.0f + (float)(n % 5);
            if (n % 3 == 0)
                para[i].td = 0.2f;
            para[i].ramp = 2.0f + (float)(n % 7) * 3.0f;
            sp[i] = 20.0f + (float)n;
        }
        init = true;
    }
    scans++;
    sp[scans % 64] = (float)((int32_t)((uint32_t)scans * 37u) % 90);
    float load = (float)(scans % 200) * 0.05f;

    float out_sum = 0.0f;
    int32_t alarms = 0, limits = 0;
    for (int i = 0; i < N_LOOPS; i++) {
        pid_mode_t mode;
        int32_t phase = (scans + (i + 1) * 5) % 400;
        if (phase < 10)
            mode = MANUAL;
        else if (phase < 15)
            mode = TRACKING;
        else
            mode = AUTOMATIC;
        pid(&loop[i], &para[i], sp[i], pv[i], mode, 35.0f, DT);
        pv[i] += (loop[i].out - load - pv[i]) * 0.08f;
        out_sum += loop[i].out;
        if (loop[i].dev_alarm)
            alarms++;
        if (loop[i].lim_high)
            limits++;
        else if (loop[i].lim_low)
            limits += 100;
    }
    check = (int32_t)((uint32_t)check * 13u + (uint32_t)((int32_t)lrintf(out_sum * 10.0f) + alarms * 7 + limits));
}
