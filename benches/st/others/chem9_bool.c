#include <stdbool.h>
#include "st.h"

typedef struct {
    bool lvl_empty, lvl_a, lvl_b, lvl_hh, temp_ok, temp_low, temp_hh, pres_hh;
    bool vent_open, agit_run, cool_flow, hatch_shut, react_end, line_free;
    bool cmd_start, cmd_hold, cmd_reset, cmd_ack;
} reactor_in;

typedef struct {
    bool feed_a, feed_b, agit, steam, cool, drain, vent, lamp, horn;
} reactor_out;

typedef struct { bool active, unacked, lamp, old; } alarm_latch;

typedef struct {
    reactor_out q;
    bool done, trip;
    bool s_fill_a, s_fill_b, s_heat, s_react, s_cool, s_drain;
    bool held, start_old;
    alarm_latch level, temp, pres, agit, cool;
} reactor;

static void alarm_update(alarm_latch *a, bool cond, bool inhibit, bool ack, bool flash)
{
    a->active = cond && !inhibit;
    if (a->active && !a->old)
        a->unacked = true;
    else if (ack)
        a->unacked = false;
    a->lamp = (a->unacked && flash) || (a->active && !a->unacked);
    a->old = a->active;
}

static void reactor_update(reactor *r, const reactor_in *in, bool estop, bool flash)
{
    bool s1 = estop || in->temp_hh || in->pres_hh || (in->lvl_hh && (r->s_fill_a || r->s_fill_b));
    bool rs = in->cmd_reset && !in->temp_hh && !in->pres_hh;
    bool trip = r->trip = s1 || (r->trip && !rs);

    r->held = (r->held || in->cmd_hold) && !in->cmd_reset && !trip;
    bool run = !trip && !r->held;

    bool start = in->cmd_start && !r->start_old;
    r->start_old = in->cmd_start;
    bool idle = !(r->s_fill_a || r->s_fill_b || r->s_heat || r->s_react || r->s_cool || r->s_drain);
    bool t_a = idle && start && in->hatch_shut && run;
    bool t_b = r->s_fill_a && in->lvl_a && run;
    bool t_heat = r->s_fill_b && in->lvl_b && in->agit_run && run;
    bool t_react = r->s_heat && in->temp_ok && !in->temp_low && run;
    bool t_cool = r->s_react && in->react_end && run;
    bool t_drain = r->s_cool && in->temp_low && in->line_free && run;
    bool t_end = r->s_drain && in->lvl_empty && run;

    r->s_fill_a = (r->s_fill_a || t_a) && !t_b && !trip;
    r->s_fill_b = (r->s_fill_b || t_b) && !t_heat && !trip;
    r->s_heat = (r->s_heat || t_heat) && !t_react && !trip;
    r->s_react = (r->s_react || t_react) && !t_cool && !trip;
    r->s_cool = ((r->s_cool || t_cool) && !t_drain) || (trip && (r->s_heat || r->s_react));
    r->s_drain = (r->s_drain || t_drain) && !t_end && !trip;
    r->done = t_end;

    reactor_out *q = &r->q;
    bool perm_feed = run && in->hatch_shut && in->vent_open && !in->lvl_hh;
    bool perm_heat = run && in->agit_run && !in->temp_hh && !q->cool;
    q->feed_a = r->s_fill_a && perm_feed && !in->lvl_a;
    q->feed_b = r->s_fill_b && perm_feed && !in->lvl_b && !q->feed_a;
    q->agit = (r->s_fill_b || r->s_heat || r->s_react || r->s_cool) && in->hatch_shut && !estop;
    q->steam = (r->s_heat || (r->s_react && in->temp_low)) && perm_heat;
    q->cool = r->s_cool || (r->s_react && !in->temp_low && !in->temp_ok) || (trip && in->temp_hh);
    q->drain = r->s_drain && run && in->line_free && !q->feed_a && !q->feed_b;
    q->vent = trip || in->pres_hh || r->s_fill_a || r->s_fill_b || q->drain;

    alarm_update(&r->level, in->lvl_hh, idle, in->cmd_ack, flash);
    alarm_update(&r->temp, in->temp_hh, false, in->cmd_ack, flash);
    alarm_update(&r->pres, in->pres_hh, r->s_drain, in->cmd_ack, flash);
    alarm_update(&r->agit, q->agit != in->agit_run, estop, in->cmd_ack, flash);
    alarm_update(&r->cool, q->cool && !in->cool_flow, r->held, in->cmd_ack, flash);
    q->lamp = r->level.lamp || r->temp.lamp || r->pres.lamp || r->agit.lamp || r->cool.lamp;
    q->horn = r->level.unacked || r->temp.unacked || r->pres.unacked || r->agit.unacked || r->cool.unacked;
}

static reactor reactors[6];
static uint32_t field[6];
static uint32_t seed = 4711;
static uint32_t scan_no;
static int32_t batches;

static inline bool bit(uint32_t w, int n) { return (w >> n) & 1; }

void scan(void)
{
    scan_no++;
    bool flash = scan_no % 16 < 8;
    bool estop = scan_no % 1000 == 999;
    uint32_t sum = (uint32_t)check;

    for (int i = 0; i < 6; i++) {
        seed = seed * 1664525u + 1013904223u;
        field[i] ^= 1u << (seed >> 27);
        uint32_t w = field[i];
        reactor_in x = {
            .lvl_empty = bit(w, 0),
            .lvl_a = bit(w, 1),
            .lvl_b = bit(w, 2),
            .lvl_hh = bit(w, 3) && bit(w, 20) && bit(w, 21),
            .temp_ok = bit(w, 4),
            .temp_low = bit(w, 5),
            .temp_hh = bit(w, 6) && bit(w, 22) && bit(w, 23),
            .pres_hh = bit(w, 7) && bit(w, 24) && bit(w, 25),
            .vent_open = bit(w, 8) || bit(w, 26),
            .agit_run = bit(w, 9) || bit(w, 27),
            .cool_flow = bit(w, 10) || bit(w, 28),
            .hatch_shut = bit(w, 11) || bit(w, 29),
            .react_end = bit(w, 12),
            .line_free = bit(w, 13),
            .cmd_start = bit(w, 14),
            .cmd_hold = bit(w, 15) && bit(w, 30),
            .cmd_reset = bit(w, 16),
            .cmd_ack = bit(w, 17),
        };
        reactor *r = &reactors[i];
        reactor_update(r, &x, estop, flash);

        const reactor_out *q = &r->q;
        uint32_t bits = q->feed_a | q->feed_b << 1 | q->agit << 2 | q->steam << 3 | q->cool << 4
            | q->drain << 5 | q->vent << 6 | q->lamp << 7 | q->horn << 8 | r->trip << 9;
        if (r->done)
            batches++;
        sum = sum * 31 + bits;
    }
    check = (int32_t)(sum * 31 + (uint32_t)batches);
}
