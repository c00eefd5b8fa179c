/* Rotary assembly table: twelve stations with interlocks, step chains, latches and alarms */
#include "st.h"
#include <stdbool.h>

enum step { STEP_IDLE, STEP_INFEED, STEP_CLAMP, STEP_PROCESS, STEP_RELEASE, STEP_OUTFEED, STEP_FAULT };

struct inputs {
    bool part_at_infeed, part_in_place, part_at_outfeed;
    bool clamp_closed, clamp_open, tool_up, tool_down;
    bool guard_closed, air_ok, drive_ok;
};

struct outputs {
    bool conveyor, clamp_close, tool_lower, vacuum;
    bool lamp_green, lamp_yellow, lamp_red, horn;
};

struct station_io {
    struct inputs in;
    struct outputs out;
};

struct alarm {
    bool active, unseen, last_cause;
};

struct station {
    enum step step;
    bool free, fault;
    struct alarm guard, air, drive, sensor;
};

#define STATIONS 12

static uint32_t pattern = 0x1234ABCD;
static struct station_io ios[STATIONS];
static struct station stations[STATIONS];

static uint32_t next_pattern(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x;
}

static int32_t pack_outputs(const struct outputs *o)
{
    return o->conveyor | o->clamp_close << 1 | o->tool_lower << 2 | o->vacuum << 3 |
           o->lamp_green << 4 | o->lamp_yellow << 5 | o->lamp_red << 6 | o->horn << 7;
}

static void alarm_update(struct alarm *a, bool cause, bool ack)
{
    bool edge = cause && !a->last_cause;
    a->last_cause = cause;
    a->active = cause || (a->active && !ack);
    a->unseen = !ack && (edge || a->unseen);
}

static void station_update(struct station *s, struct station_io *io, bool enable, bool ack, bool next_free)
{
    const struct inputs *in = &io->in;
    struct outputs *out = &io->out;
    bool running = s->step != STEP_IDLE && s->step != STEP_FAULT;

    alarm_update(&s->guard, running && !in->guard_closed, ack);
    alarm_update(&s->air, !in->air_ok && (out->clamp_close || out->vacuum), ack);
    alarm_update(&s->drive, !in->drive_ok && (out->conveyor || out->tool_lower), ack);
    alarm_update(&s->sensor, (in->clamp_closed && in->clamp_open) || (in->tool_up && in->tool_down), ack);

    bool fault = s->guard.active || s->air.active || s->drive.active || s->sensor.active;
    bool interlock = enable && in->guard_closed && in->air_ok && in->drive_ok && !fault;
    s->fault = fault;

    enum step step = fault ? STEP_FAULT : s->step;
    switch (step) {
    case STEP_IDLE:
        if (interlock && in->part_at_infeed && in->clamp_open && in->tool_up)
            step = STEP_INFEED;
        break;
    case STEP_INFEED:
        if (in->part_in_place)
            step = STEP_CLAMP;
        break;
    case STEP_CLAMP:
        if (in->clamp_closed && !in->clamp_open)
            step = STEP_PROCESS;
        break;
    case STEP_PROCESS:
        if (in->tool_down && in->clamp_closed)
            step = STEP_RELEASE;
        break;
    case STEP_RELEASE:
        if (in->tool_up && in->clamp_open)
            step = STEP_OUTFEED;
        break;
    case STEP_OUTFEED:
        if (in->part_at_outfeed && next_free)
            step = STEP_IDLE;
        break;
    case STEP_FAULT:
        if (!fault)
            step = STEP_IDLE;
        break;
    }
    s->step = step;
    s->free = step == STEP_IDLE;

    out->conveyor = interlock && (step == STEP_INFEED || (step == STEP_OUTFEED && next_free));
    out->clamp_close = step == STEP_CLAMP || step == STEP_PROCESS;
    out->tool_lower = interlock && step == STEP_PROCESS && in->clamp_closed;
    out->vacuum = (step == STEP_CLAMP || step == STEP_PROCESS || step == STEP_RELEASE) && !in->tool_down;
    out->lamp_green = interlock && !s->free;
    out->lamp_yellow = enable && (s->free || (step == STEP_OUTFEED && !next_free));
    out->lamp_red = fault;
    out->horn = s->guard.unseen || s->air.unseen || s->drive.unseen || s->sensor.unseen;
}

void scan(void)
{
    pattern = next_pattern(pattern);
    bool ack = (pattern & 0x70000000) == 0;
    bool enable = (pattern & 0x0F000000) != 0;
    bool any_fault = false;

    for (int i = 0; i < STATIONS; i++) {
        struct station_io *io = &ios[i];
        uint32_t p = pattern = next_pattern(pattern);
        io->in.part_at_infeed = (p & 0x0003) != 0;
        io->in.part_in_place = io->out.conveyor && (p & 0x0004) != 0;
        io->in.part_at_outfeed = (p & 0x0018) != 0;
        io->in.clamp_closed = io->out.clamp_close && (p & 0x0060) != 0;
        io->in.clamp_open = !io->out.clamp_close && (p & 0x0180) != 0;
        io->in.tool_down = io->out.tool_lower && (p & 0x0600) != 0;
        io->in.tool_up = !io->out.tool_lower || (p & 0x0003F800) == 0;
        io->in.guard_closed = (p & 0x00FC0000) != 0;
        io->in.air_ok = (p & 0x1F000000) != 0;
        io->in.drive_ok = (p & 0xF8000000) != 0;
        bool next_free = i < STATIONS - 1 ? stations[i + 1].free : true;
        station_update(&stations[i], io, enable, ack, next_free);
        any_fault |= stations[i].fault;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)pack_outputs(&io->out));
    }
    if (any_fault)
        check = (int32_t)((uint32_t)check + 1u);
}
