/* 64 control loops: PID with modes, setpoint ramp and limits, each with a simulated plant. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define LOOPS 64

typedef struct { float kp, ti, td, out_min, out_max, sp_rate, dead_band; } pid_par_t;

typedef struct {
    int16_t mode;
    float sp, pv, out, out_man;
    pid_par_t par;
    bool alm_hi, alm_dev, limited;
} loop_t;

typedef struct { float sp_ramp, integ, pv_old, d_filt; } pid_fb_t;
typedef struct { float x1, y; } plant_t;

static loop_t loops[LOOPS];
static pid_fb_t pids[LOOPS];
static plant_t plants[LOOPS];
static bool init;
static int16_t scan_no;
static int32_t seed = 1;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline float dead_band(float x, float width)
{
    if (x > width)
        return x - width;
    if (x < -width)
        return x + width;
    return 0.0f;
}

static void pid(pid_fb_t *s, loop_t *l, float ts)
{
    const pid_par_t *par = &l->par;

    s->sp_ramp += limit(-par->sp_rate, l->sp - s->sp_ramp, par->sp_rate);
    float err = dead_band(s->sp_ramp - l->pv, par->dead_band);
    float p = par->kp * err;
    s->d_filt += 0.2f * ((s->pv_old - l->pv) / ts - s->d_filt);
    s->pv_old = l->pv;

    switch (l->mode) {
    case 0: /* manual: track */
        l->out = limit(par->out_min, l->out_man, par->out_max);
        s->integ = l->out - p;
        l->limited = false;
        break;
    case 1:
    case 2: { /* automatic; 2 without D */
        float raw = p + s->integ;
        if (l->mode == 1)
            raw += par->kp * par->td * s->d_filt;
        l->out = limit(par->out_min, raw, par->out_max);
        l->limited = l->out != raw;
        if (!l->limited && par->ti > 0.0f)
            s->integ += par->kp * ts / par->ti * err;
        break;
    }
    default: /* shut down */
        l->out = par->out_min;
        s->integ = 0.0f;
        l->limited = true;
        break;
    }
    l->alm_hi = l->pv > 90.0f;
    l->alm_dev = fabsf(l->sp - l->pv) > 5.0f;
}

static inline void plant(plant_t *p, float u, float dist)
{
    p->x1 += 0.02f * (u + dist - p->x1);
    p->y += 0.1f * (p->x1 - p->y);
}

void scan(void)
{
    if (!init) {
        init = true;
        for (int i = 0; i < LOOPS; i++) {
            int n = i + 1;
            loops[i].mode = 1;
            loops[i].sp = 20.0f + (float)n * 0.5f;
            loops[i].par = (pid_par_t){
                .kp = 1.0f + (float)(n % 7) * 0.3f,
                .ti = 2.0f + (float)(n % 11) * 0.5f,
                .td = (float)(n % 3) * 0.1f,
                .out_max = 100.0f,
                .sp_rate = 0.5f,
                .dead_band = 0.05f,
            };
        }
    }

    if (++scan_no >= 20) {
        scan_no = 0;
        seed = seed * 171 % 30269;
        loop_t *l = &loops[seed % 64];
        l->sp = (float)(seed % 80) + 5.0f;
        l->mode = seed / 64 % 4;
        l->out_man = (float)(seed % 101);
    }

    int32_t sum = 0;
    for (int i = 0; i < LOOPS; i++) {
        loop_t *l = &loops[i];
        l->pv = plants[i].y;
        pid(&pids[i], l, 0.1f);
        plant(&plants[i], l->out, (float)((scan_no + i + 1) % 9) * 0.1f);
        sum += (int32_t)(l->out * 100.0f) + (int32_t)(plants[i].y * 100.0f);
        if (l->alm_hi || l->alm_dev)
            sum += i + 1;
        if (l->limited)
            sum += 1000;
    }
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)sum);
}
