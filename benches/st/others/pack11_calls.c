/* 40 units, each with ramp, filter, switch, counter and PackML state machine */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define UNITS 40

typedef enum {
    ST_CLEARING = 1, ST_STOPPED = 2, ST_STARTING = 3, ST_IDLE = 4, ST_EXECUTE = 6,
    ST_STOPPING = 7, ST_ABORTING = 8, ST_ABORTED = 9, ST_RESETTING = 15,
    ST_COMPLETING = 16, ST_COMPLETE = 17
} pack_state_t;

typedef struct { bool reset, start, stop, abort, clear, done; } pack_cmd_t;
typedef struct { pack_state_t state; int16_t state_no, changes, tick; } packml_t;
typedef struct { float out; bool in_pos; } ramp_t;
typedef struct { float out; } filter_t;
typedef struct { bool out; } hysteresis_t;
typedef struct { int16_t count; int32_t total; bool done, pulse_prev; } counter_t;

typedef struct {
    pack_cmd_t cmd;
    packml_t packml;
    ramp_t ramp;
    filter_t filter;
    hysteresis_t level_switch;
    counter_t counter;
} unit_t;

static unit_t units[UNITS];
static bool initialised;
static int scan_no;

static inline float clampf(float lo, float x, float hi)
{
    if (x < lo)
        return lo;
    if (x > hi)
        return hi;
    return x;
}

static inline float scalef(float in, float in_min, float in_max, float out_min, float out_max)
{
    return clampf(out_min, (in - in_min) / (in_max - in_min) * (out_max - out_min) + out_min, out_max);
}

static inline uint32_t hash(uint32_t h, uint32_t v)
{
    return h * 31u + v;
}

static void ramp(ramp_t *r, bool enable, float target, float step)
{
    float goal = enable ? target : 0.0f;
    r->out = clampf(r->out - step, goal, r->out + step);
    r->in_pos = r->out == goal;
}

static float filter(filter_t *f, float in, float factor)
{
    f->out += factor * (in - f->out);
    return f->out;
}

static bool hysteresis(hysteresis_t *h, float in, float low, float high)
{
    if (in >= high)
        h->out = true;
    else if (in <= low)
        h->out = false;
    return h->out;
}

static void counter(counter_t *c, bool pulse, bool reset, int16_t preset)
{
    if (reset) {
        c->count = 0;
    } else if (pulse && !c->pulse_prev) {
        c->count++;
        c->total++;
    }
    c->pulse_prev = pulse;
    c->done = c->count >= preset;
}

static void packml(packml_t *p, const pack_cmd_t *cmd, int16_t steps)
{
    pack_state_t old = p->state;
    pack_state_t next = old;

    p->tick++;
    bool complete = p->tick >= steps;
    p->state_no = (int16_t)old;

    switch (old) {
    case ST_STOPPED:    if (cmd->reset) next = ST_RESETTING; break;
    case ST_RESETTING:  if (complete) next = ST_IDLE; break;
    case ST_IDLE:       if (cmd->start) next = ST_STARTING; break;
    case ST_STARTING:   if (complete) next = ST_EXECUTE; break;
    case ST_EXECUTE:    if (cmd->done) next = ST_COMPLETING; break;
    case ST_COMPLETING: if (complete) next = ST_COMPLETE; break;
    case ST_COMPLETE:   if (cmd->reset) next = ST_RESETTING; break;
    case ST_STOPPING:   if (complete) next = ST_STOPPED; break;
    case ST_ABORTING:   if (complete) next = ST_ABORTED; break;
    case ST_ABORTED:    if (cmd->clear) next = ST_CLEARING; break;
    case ST_CLEARING:   if (complete) next = ST_STOPPED; break;
    }

    if (cmd->abort && next != ST_ABORTING && next != ST_ABORTED && next != ST_CLEARING)
        next = ST_ABORTING;
    else if (cmd->stop && (next == ST_STARTING || next == ST_EXECUTE || next == ST_IDLE ||
                           next == ST_RESETTING))
        next = ST_STOPPING;

    if (next != old) {
        p->tick = 0;
        p->changes = (p->changes + 1) % 1000;
    }
    p->state = next;
}

void scan(void)
{
    if (!initialised) {
        initialised = true;
        for (int i = 0; i < UNITS; i++)
            units[i].packml.state = ST_STOPPED;
    }
    scan_no = (scan_no + 1) % 4000;

    uint32_t h = 0;
    float sum = 0.0f;
    for (int i = 1; i <= UNITS; i++) {
        unit_t *u = &units[i - 1];
        int phase = (scan_no + i * 53) % 800;
        u->cmd.reset = phase % 50 == 1;
        u->cmd.start = phase % 50 == 20;
        u->cmd.stop = phase == 555;
        u->cmd.abort = phase == 700;
        u->cmd.clear = phase == 730;
        u->cmd.done = u->counter.done;
        packml(&u->packml, &u->cmd, 5 + i % 6);
        bool running = u->packml.state == ST_EXECUTE;

        float speed = scalef((float)phase, 100.0f, 500.0f, 20.0f, 120.0f);
        ramp(&u->ramp, running, speed, 2.5f);
        float level = filter(&u->filter, u->ramp.out + (float)((scan_no * 3 + i) % 16), 0.2f);
        hysteresis(&u->level_switch, level - (float)(phase % 13) * 4.0f, 0.0f, 10.0f);
        counter(&u->counter, u->level_switch.out && running,
                u->packml.state == ST_RESETTING, 12);

        sum += level;
        h = hash(h, (uint32_t)(u->packml.state_no + u->counter.total * 32 + u->packml.changes));
        if (u->ramp.in_pos)
            h = hash(h, (uint32_t)i);
    }
    check = (int32_t)hash((uint32_t)check, h + (uint32_t)lrintf(sum * 100.0f));
}
