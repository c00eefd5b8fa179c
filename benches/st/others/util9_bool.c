/* Interlocks and sequence of 16 raw water pumps, collective alarms of the station */
#include <stdbool.h>
#include "st.h"

#define N_PUMPS 16

typedef struct {
    bool run_cmd, open_cmd, close_cmd;
    bool ready, trip, warning, new_alarm;
    bool lat_suction, lat_disch, lat_seal, lat_hot, lat_vib, lat_estop, lat_feedback;
    bool old_trip, old_warning, old_start;
    bool not_s0, s1, s2, s3, s4;
} pump_t;

typedef struct {
    bool automatic, start_cmd, stop_cmd, reset;
    bool suction_low, disch_high, seal_leak, motor_hot, vibration;
    bool valve_open, valve_closed, power_ok, estop, running;
    bool station_ok;
} pump_in_t;

static pump_t pump[N_PUMPS];
static uint32_t seed = 4711;
static bool horn, blink, station_ok = true;

static void pump_interlock(pump_t *p, const pump_in_t *in)
{
    p->lat_suction = (p->lat_suction || (in->suction_low && in->running)) && !(in->reset && !in->suction_low);
    p->lat_disch = (p->lat_disch || (in->disch_high && in->running && !in->valve_open)) && !(in->reset && !in->disch_high);
    p->lat_seal = (p->lat_seal || in->seal_leak) && !(in->reset && !in->seal_leak);
    p->lat_hot = (p->lat_hot || in->motor_hot) && !(in->reset && !in->motor_hot);
    p->lat_vib = (p->lat_vib || (in->vibration && in->running && p->s3)) && !(in->reset && !in->vibration);
    p->lat_estop = (p->lat_estop || in->estop) && !(in->reset && !in->estop);
    if (p->s3 && !in->running && !in->power_ok)
        p->lat_feedback = true;
    else if (in->reset)
        p->lat_feedback = false;

    p->trip = p->lat_suction || p->lat_disch || p->lat_hot || p->lat_estop || p->lat_feedback;
    p->warning = p->lat_seal || p->lat_vib || (in->valve_open && in->valve_closed) || !in->power_ok;
    p->ready = in->power_ok && !p->trip && !in->estop && !in->suction_low && in->station_ok
               && !(in->valve_open && in->valve_closed);

    bool start_edge = in->start_cmd && !p->old_start;
    p->old_start = in->start_cmd;

    bool t01 = !p->not_s0 && p->ready && (start_edge || (in->automatic && in->start_cmd && !in->stop_cmd));
    bool t12 = p->s1 && in->valve_open && !in->valve_closed;
    bool t23 = p->s2 && in->running;
    bool t34 = (p->s1 || p->s2 || p->s3) && (in->stop_cmd || p->trip || !in->station_ok);
    bool t40 = p->s4 && (in->valve_closed || p->lat_estop);
    if (t34) {
        p->s1 = p->s2 = p->s3 = false;
        p->s4 = true;
    } else if (t40) {
        p->s4 = false;
        p->not_s0 = false;
    } else if (t23) {
        p->s2 = false;
        p->s3 = true;
    } else if (t12) {
        p->s1 = false;
        p->s2 = true;
    } else if (t01) {
        p->not_s0 = true;
        p->s1 = true;
    }

    p->run_cmd = (p->s2 || p->s3) && !p->trip && !in->estop;
    p->open_cmd = (p->s1 || p->s2 || p->s3) && !in->valve_open;
    p->close_cmd = (p->s4 || !p->not_s0) && !in->valve_closed && !p->open_cmd;
    p->new_alarm = (p->trip && !p->old_trip) || (p->warning && !p->old_warning);
    p->old_trip = p->trip;
    p->old_warning = p->warning;
}

#define X(n) ((w >> (n)) & 1)

void scan(void)
{
    bool any_trip = false, any_warning = false, all_ready = true, any_run = false, two_trips = false;
    uint32_t bits = 0, w = 0;
    blink = !blink;
    for (int i = 0; i < N_PUMPS; i++) {
        pump_t *p = &pump[i];
        seed = seed * 1664525u + 1013904223u;
        w = seed;
        pump_in_t in = {
            .automatic = X(31),
            .start_cmd = X(30) || X(29),
            .stop_cmd = X(28) && X(27) && X(26),
            .reset = X(25) && X(24),
            .suction_low = X(23) && X(22) && X(21) && X(30),
            .disch_high = X(20) && X(19),
            .seal_leak = X(18) && X(17) && X(16),
            .motor_hot = X(15) && X(14) && X(27) && X(23),
            .vibration = X(13) && X(29),
            .valve_open = p->open_cmd || (X(12) && X(28)),
            .valve_closed = p->close_cmd && X(26),
            .power_ok = X(11) || X(22) || X(19),
            .estop = X(10) && X(20) && X(31) && X(16) && X(24),
            .running = p->run_cmd && (X(21) || X(18) || X(15)),
            .station_ok = station_ok,
        };
        pump_interlock(p, &in);

        if (any_trip && p->trip)
            two_trips = true;
        any_trip = any_trip || p->trip;
        any_warning = any_warning || p->warning;
        all_ready = all_ready && p->ready;
        any_run = any_run || p->run_cmd;
        bool horn_ack = X(14) && X(25) && !any_trip;
        horn = (horn || p->new_alarm) && !horn_ack;

        bits *= 2;
        if (p->run_cmd) bits += 1;
        if (p->open_cmd) bits += 5;
        if (p->close_cmd) bits += 11;
        if (p->trip) bits += 17;
        if (p->new_alarm != p->ready) bits += 23;
    }
    bool lamp = (any_trip && blink) || (any_warning && !any_trip) || (all_ready && !any_run);
    station_ok = !(two_trips && any_warning && lamp && X(30));
    if (horn) bits += 101;
    if (lamp) bits += 211;
    if (station_ok) bits += 307;
    check = (int32_t)((uint32_t)check * 31u + bits);
}
