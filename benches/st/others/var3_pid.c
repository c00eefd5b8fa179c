#include "st.h"
typedef struct { float y; } pt1_t;
typedef struct { float y; } ramp_t;
typedef struct { float out; ramp_t sp_ramp; pt1_t filter; float i_part; } ctrl_t;
typedef struct {
    float total;
    ctrl_t fic1, fic2, lic1, pic1, tic1, tic2, qic1, sic1;
    float flow1, flow2, level, press, temp1, temp2, qual, speed;
} unit_t_;
static void pt1(pt1_t *f, float x, float k) { f->y = f->y + k * (x - f->y); }
static void ramp(ramp_t *r, float target, float rate)
{
    if (r->y < target - rate)
        r->y = r->y + rate;
    else if (r->y > target + rate)
        r->y = r->y - rate;
    else
        r->y = target;
}
static float minf(float a, float b) { return a < b ? a : b; }
static float maxf(float a, float b) { return a > b ? a : b; }
static void controller(ctrl_t *c, float setpoint, float meas, float gain, float reset_time, float filt)
{
    ramp(&c->sp_ramp, setpoint, 0.5f);
    pt1(&c->filter, meas, filt);
    float e = c->sp_ramp.y - c->filter.y;
    c->i_part = maxf(-100.0f, minf(100.0f, c->i_part + gain * e / reset_time));
    c->out = minf(100.0f, maxf(0.0f, gain * e + c->i_part));
}
static void process_unit(unit_t_ *u, float load, float base)
{
    controller(&u->fic1, base, u->flow1, 1.2f, 30.0f, 0.5f);
    u->flow1 = u->flow1 + 0.10f * (u->fic1.out - u->flow1);
    controller(&u->fic2, base + 5.0f, u->flow2, 1.1f, 25.0f, 0.5f);
    u->flow2 = u->flow2 + 0.12f * (u->fic2.out - u->flow2);
    controller(&u->lic1, 50.0f + load * 0.1f, u->level, 2.0f, 80.0f, 0.3f);
    u->level = u->level + 0.02f * (u->lic1.out - u->level);
    controller(&u->pic1, 20.0f + load * 0.2f, u->press, 0.9f, 40.0f, 0.4f);
    u->press = u->press + 0.08f * (u->pic1.out - u->press);
    controller(&u->tic1, u->tic2.out * 0.5f + 10.0f, u->temp1, 1.5f, 120.0f, 0.2f);
    u->temp1 = u->temp1 + 0.01f * (u->tic1.out - u->temp1);
    controller(&u->tic2, 60.0f - load * 0.1f, u->temp2, 1.4f, 110.0f, 0.2f);
    u->temp2 = u->temp2 + 0.015f * (u->tic2.out - u->temp2);
    controller(&u->qic1, u->flow1 * 0.5f + u->flow2 * 0.25f, u->qual, 0.7f, 60.0f, 0.3f);
    u->qual = u->qual + 0.03f * (u->qic1.out - u->qual);
    controller(&u->sic1, 40.0f + load, u->speed, 1.0f, 20.0f, 0.6f);
    u->speed = u->speed + 0.2f * (u->sic1.out - u->speed);
    u->total = u->flow1 + u->flow2 + u->level + u->press + u->temp1 + u->temp2 + u->qual + u->speed;
}
static unit_t_ north, south, east, west, boiler, dryer, mixer, tower;
static int16_t t;
void scan(void)
{
    float ld;
    t++;
    if (t >= 400) t = 0;
    if (t < 200) ld = 10.0f + (float)(t / 10); else ld = 30.0f;
    process_unit(&north, ld + 0.0f, 25.0f);
    process_unit(&south, ld + 1.0f, 28.0f);
    process_unit(&east, ld + 2.0f, 31.0f);
    process_unit(&west, ld + 3.0f, 34.0f);
    process_unit(&boiler, ld + 4.0f, 37.0f);
    process_unit(&dryer, ld + 5.0f, 40.0f);
    process_unit(&mixer, ld + 6.0f, 43.0f);
    process_unit(&tower, ld + 7.0f, 46.0f);
    check = (check % 100003) * 3 + (int32_t)((north.total + south.total + east.total + west.total + boiler.total + dryer.total + mixer.total + tower.total) * 8.0f);
}
