/* 32 servo drives in cascade: 32 position controllers over 32 speed controllers */
#include <stdbool.h>
#include <math.h>
#include "st.h"

typedef struct { float kp, ki, kd, max, dead, ff; } CtrlPar;
typedef struct { float out, e1, e2; bool sat; } CtrlState;

typedef struct {
    CtrlPar pos_par, vel_par;
    CtrlState pos, vel;
    float pos_set, pos_act, vel_act, load;
} Drive;

static float limitf(float mn, float in, float mx)
{
    if (in < mn) in = mn;
    if (in > mx) in = mx;
    return in;
}

static float dead_band(float in, float dead)
{
    if (in > dead) return in - dead;
    if (in < -dead) return in + dead;
    return 0.0f;
}

static float pos_ctrl(const CtrlPar *p, CtrlState *s, float err, float feed)
{
    float e = dead_band(err, p->dead);
    s->out = p->kp * e + p->kd * (e - s->e1) + p->ff * feed;
    s->e1 = e;
    s->sat = fabsf(s->out) > p->max;
    s->out = limitf(-p->max, s->out, p->max);
    return s->out;
}

static float vel_ctrl(const CtrlPar *p, CtrlState *s, float err)
{
    float delta = p->kp * (err - s->e1) + p->ki * err + p->kd * (err - 2.0f * s->e1 + s->e2);
    s->e2 = s->e1;
    s->e1 = err;
    float n = s->out + delta;
    s->sat = false;
    if (n > p->max) {
        n = p->max;
        s->sat = true;
    } else if (n < -p->max) {
        n = -p->max;
        s->sat = true;
    }
    s->out = n;
    return n;
}

#define DT 0.001f

static bool init;
static Drive drives[32];
static int32_t scan_no;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 32; i++) {
            Drive *d = &drives[i];
            d->pos_par.kp = 20.0f + 0.25f * i;
            d->pos_par.kd = 0.5f;
            d->pos_par.max = 300.0f;
            d->pos_par.dead = 0.01f;
            d->pos_par.ff = 0.9f;
            d->vel_par.kp = 0.8f;
            d->vel_par.ki = 0.05f;
            d->vel_par.kd = 0.01f;
            d->vel_par.max = 60.0f;
            d->load = 0.05f + 0.002f * i;
        }
        init = true;
    }
    scan_no++;
    float sum = 0.0f;
    int16_t sat = 0;
    for (int i = 0; i < 32; i++) {
        Drive *d = &drives[i];
        int16_t phase = (int16_t)((scan_no + 25 * i) % 2000);
        float feed;
        if (phase < 600)
            feed = 150.0f;
        else if (phase < 1000)
            feed = 0.0f;
        else if (phase < 1600)
            feed = -150.0f;
        else
            feed = 0.0f;
        d->pos_set = d->pos_set + feed * DT;

        float vel_set = pos_ctrl(&d->pos_par, &d->pos, d->pos_set - d->pos_act, feed);
        float torque = vel_ctrl(&d->vel_par, &d->vel, vel_set - d->vel_act);

        d->vel_act = d->vel_act + (torque - d->vel_act * 0.02f) * DT / d->load;
        d->pos_act = d->pos_act + d->vel_act * DT;

        if (d->pos.sat || d->vel.sat)
            sat++;
        sum = sum + fabsf(d->pos_set - d->pos_act) * 100.0f + torque;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)sum + sat));
}
