#include <stdbool.h>
#include "st.h"

struct pump_field { bool auto_sel, start_pb, stop_pb, thermal, seal_leak, suction_ok, run_fb; };
struct pump { bool cmd, ready, trip, fb_miss, man_run; };
struct chain {
    bool s0, s1, s2, s3, s4, s5;
    bool v_inlet, v_outlet, v_drain, blower, bw_pump, busy;
};
struct alarm_pt { bool old, unacked, lamp, horn; };

static struct pump_field field[6];
static struct pump pump[6];
static struct chain filt[4] = { {.s0 = true}, {.s0 = true}, {.s0 = true}, {.s0 = true} };
static struct alarm_pt alarms[16];
static uint32_t rnd = 4711;
static bool demand, any_trip;

static uint32_t next_rnd(void) { return rnd = rnd * 1664525u + 1013904223u; }
static inline bool bit(uint32_t w, int n) { return (w >> n) & 1u; }
static inline void add(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }

static void pump_logic(struct pump *p, const struct pump_field *f, bool dem, bool permit, bool ack)
{
    p->trip = f->thermal || f->seal_leak || (p->fb_miss && p->cmd && !f->run_fb) || (p->trip && !ack);
    p->fb_miss = p->cmd && !f->run_fb;
    p->ready = permit && f->suction_ok && !p->trip;
    p->man_run = (f->start_pb || p->man_run) && !f->stop_pb && !f->auto_sel && p->ready;
    p->cmd = p->ready && ((f->auto_sel && dem) || p->man_run);
}

static void chain_run(struct chain *c, bool start, bool permit, bool drained, bool air_ok,
                      bool water_ok, bool filled, bool abort)
{
    bool t01 = c->s0 && start && permit && !abort;
    bool t12 = c->s1 && drained;
    bool t23 = c->s2 && air_ok;
    bool t34 = c->s3 && water_ok;
    bool t45 = c->s4 && !drained;
    bool t50 = c->s5 && filled;

    c->s0 = (c->s0 || t50 || abort) && !t01;
    c->s1 = (c->s1 || t01) && !t12 && !abort;
    c->s2 = (c->s2 || t12) && !t23 && !abort;
    c->s3 = (c->s3 || t23) && !t34 && !abort;
    c->s4 = (c->s4 || t34) && !t45 && !abort;
    c->s5 = (c->s5 || t45) && !t50 && !abort;

    c->v_inlet = c->s0 || c->s5;
    c->v_outlet = c->s0;
    c->v_drain = c->s1 || c->s2 || c->s3 || c->s4;
    c->blower = c->s2 || (c->s3 && air_ok);
    c->bw_pump = c->s3 || c->s4;
    c->busy = !c->s0;
}

static void alarm_run(struct alarm_pt *a, bool cond, bool ack)
{
    if (cond && !a->old)
        a->unacked = true;
    else if (ack)
        a->unacked = false;
    a->old = cond;
    a->horn = a->unacked;
    a->lamp = cond || a->unacked;
}

void scan(void)
{
    uint32_t w = next_rnd();
    bool tank_low = bit(w, 31) && bit(w, 30);
    bool tank_high = bit(w, 29) && !tank_low;
    bool e_stop = bit(w, 28) && bit(w, 27) && bit(w, 26) && bit(w, 25);
    bool ack_pb = bit(w, 24) && bit(w, 23);
    demand = (tank_low || demand) && !tank_high;
    bool permit = !e_stop && !(any_trip && tank_high);

    any_trip = false;
    int32_t bits = 0;
    for (int i = 0; i < 6; i++) {
        struct pump_field *f = &field[i];
        struct pump *p = &pump[i];
        w = next_rnd();
        f->auto_sel = bit(w, 31) || bit(w, 30);
        f->start_pb = bit(w, 29);
        f->stop_pb = bit(w, 28) && bit(w, 27);
        f->thermal = bit(w, 26) && bit(w, 25) && bit(w, 24);
        f->seal_leak = bit(w, 23) && bit(w, 22) && bit(w, 21) && bit(w, 20);
        f->suction_ok = bit(w, 19) || bit(w, 18) || bit(w, 17);
        f->run_fb = bit(w, 16) || bit(w, 15);
        pump_logic(p, f, demand, permit, ack_pb);
        any_trip = any_trip || p->trip;
        bits = bits * 8 + p->cmd * 4 + p->ready * 2 + p->trip;
    }
    add(bits);

    bool any_busy = false;
    for (int i = 0; i < 4; i++) {
        struct chain *c = &filt[i];
        w = next_rnd();
        chain_run(c, bit(w, 31), permit && !any_busy, bit(w, 30), bit(w, 29) || bit(w, 28),
                  bit(w, 27), bit(w, 26), e_stop || (bit(w, 25) && bit(w, 24) && bit(w, 23)));
        any_busy = any_busy || c->busy;
        add(c->v_inlet + c->v_outlet * 2 + c->v_drain * 4 + c->blower * 8 + c->bw_pump * 16 + c->busy * 32);
    }

    for (int i = 0; i < 6; i++) {
        alarm_run(&alarms[i], pump[i].trip, ack_pb);
        alarm_run(&alarms[i + 6], !field[i].suction_ok && pump[i].ready, ack_pb);
    }
    alarm_run(&alarms[12], tank_low && !demand, ack_pb);
    alarm_run(&alarms[13], tank_high, ack_pb);
    alarm_run(&alarms[14], e_stop, ack_pb && !e_stop);
    alarm_run(&alarms[15], any_trip && any_busy, ack_pb);
    bool horn = false;
    bits = 0;
    for (int i = 0; i < 16; i++) {
        horn = horn || alarms[i].horn;
        bits = bits * 2 + alarms[i].lamp;
    }
    add(bits);
    if (horn)
        check = (int32_t)((uint32_t)check + 1u);
}
