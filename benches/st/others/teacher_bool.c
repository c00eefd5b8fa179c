#include <stdbool.h>
#include "st.h"

#define STATIONS 20

typedef struct {
    bool enable, automatic, start, stop;
    bool part_before, part_after;
    bool clamp_home, clamp_end;
    bool tool_ok, door, ack;
    bool run, conveyor, clamp, tool, done, fault, ready;
    bool lamp_green, lamp_yellow, lamp_red;
    bool start_old, start_pulse, ack_old, ack_pulse;
    bool interlock, part_mem;
    bool step_load, step_clamp, step_work, step_release;
} station_t;

static void station(station_t *s)
{
    s->start_pulse = s->start && !s->start_old;
    s->start_old = s->start;
    s->ack_pulse = s->ack && !s->ack_old;
    s->ack_old = s->ack;

    s->interlock = s->enable && !s->door && s->tool_ok;
    s->fault = (s->fault || (s->run && !s->interlock) || (s->clamp_home && s->clamp_end && s->tool)) && !s->ack_pulse;
    s->run = (s->run || s->start_pulse || (s->automatic && s->part_before)) && !s->stop && !s->fault && s->interlock;

    s->step_load = (s->step_load || (s->run && s->part_before && !s->part_mem && !s->step_work)) && !s->step_clamp && !s->fault;
    s->part_mem = (s->part_mem || s->step_load) && !(s->step_release && !s->part_after) && !s->fault;
    s->step_clamp = (s->step_clamp || (s->step_load && s->clamp_home)) && !s->step_work && !s->fault;
    s->step_work = (s->step_work || (s->step_clamp && s->clamp_end)) && !s->step_release && s->run;
    s->step_release = (s->step_release || (s->step_work && s->tool_ok && !s->clamp_end)) && !s->step_load && !s->part_after;

    s->clamp = s->step_clamp || s->step_work;
    s->conveyor = s->run && (s->step_load || s->step_release) && !s->clamp;
    s->tool = s->step_work && s->interlock;
    s->done = s->step_release && !s->part_after;
    s->ready = !s->run && s->interlock && !s->fault;
    s->lamp_green = s->run && !s->fault;
    s->lamp_yellow = s->ready || (s->run != s->conveyor);
    s->lamp_red = s->fault || !s->enable;
}

static uint32_t seed = 12345;
static bool input[32];
static station_t st[STATIONS];
static bool line_on, line_auto, line_stop, any_fault, all_ready, horn, horn_ack, full;

void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    uint32_t noise = seed;
    for (int i = 0; i < 32; i++) {
        input[i] = (noise & 0x80000000u) != 0;
        noise <<= 1;
    }

    line_stop = input[0] && input[1] && input[2];
    line_on = (line_on || input[3]) && !line_stop;
    line_auto = line_on && (line_auto || input[4]) && !(input[5] && input[6]);
    horn_ack = (horn_ack || input[7]) && any_fault;
    horn = any_fault && !horn_ack;

    any_fault = false;
    all_ready = true;
    for (int i = 0; i < STATIONS; i++) {
        station_t *s = &st[i];
        bool prev = input[8];
        if (i > 0)
            prev = st[i - 1].done || input[i + 8];
        bool next = full;
        if (i < STATIONS - 1)
            next = st[i + 1].clamp;
        s->enable = line_on || input[i];
        s->automatic = line_auto;
        s->start = input[i + 1];
        s->stop = line_stop;
        s->part_before = prev;
        s->part_after = next;
        s->clamp_home = !s->clamp || input[i + 2];
        s->clamp_end = s->clamp && input[i + 3];
        s->tool_ok = input[i + 4] || input[i + 5] || input[i + 6];
        s->door = input[i + 7] && input[i + 9] && input[i + 11];
        s->ack = input[i + 10];
        station(s);
        any_fault = any_fault || s->fault;
        all_ready = all_ready && s->ready;
    }
    full = st[STATIONS - 1].done && input[31];

    for (int i = 0; i < STATIONS; i++) {
        if (st[i].conveyor)
            check += 1;
        if (st[i].tool)
            check += 3;
        if (st[i].lamp_green)
            check += 7;
        if (st[i].lamp_yellow)
            check += 19;
        if (st[i].lamp_red)
            check += 101;
    }
    if (horn || all_ready)
        check += 1009;
}
