/* Tank farm: interlocks, alarms, valves and step chains of eight process tanks */
#include <stdbool.h>
#include "st.h"

#define TANKS 8

typedef enum { STEP_IDLE, STEP_FILL, STEP_AGITATE, STEP_STORE, STEP_EMPTY, STEP_CIP, STEP_FAULT } tank_step;

typedef struct {
    bool level_ll, level_l, level_h, level_hh;
    bool manhole_closed, air_ok, inlet_fb, outlet_fb;
    bool cip_supply_ok, cip_return_ok, agitator_ok, temp_ok;
    bool cmd_fill, cmd_empty, cmd_cip, cmd_reset;
} tank_inputs;

typedef struct {
    bool inlet, outlet, cip_inlet, cip_return, agitator, horn, lamp;
} tank_outputs;

typedef struct { bool active, unacked, lamp, last; } alarm_t;
typedef struct { bool out, fault, prev; } valve_t;
typedef struct {
    tank_step step;
    bool filling, emptying, cleaning, mixing, dirty;
} sequence_t;

typedef struct {
    alarm_t overfill, manhole, air, temp, probe, cip;
    sequence_t seq;
    valve_t inlet, outlet, cip_in, cip_ret;
    bool uses_cip, faulted;
} tank_t;

static uint32_t noise = 12345;
static tank_inputs inputs[TANKS];
static tank_outputs outputs[TANKS];
static tank_t tanks[TANKS];

static void alarm_update(alarm_t *a, bool condition, bool enable, bool ack)
{
    a->active = (condition && enable) || (a->active && !ack);
    a->unacked = (a->active && !a->last) || (a->unacked && !ack);
    a->lamp = a->active || a->unacked;
    a->last = a->active;
}

static bool valve_update(valve_t *v, bool autom, bool manual, bool manual_cmd, bool interlock, bool feedback, bool reset)
{
    v->fault = (v->fault && !reset) || (v->prev && v->out && !feedback && !manual);
    v->prev = v->out;
    v->out = ((autom && !manual) || (manual && manual_cmd)) && interlock && !v->fault;
    return v->out;
}

static void sequence_update(sequence_t *s, const tank_inputs *in, bool permit, bool trip)
{
    if (trip)
        s->step = STEP_FAULT;

    switch (s->step) {
    case STEP_IDLE:
        if (in->cmd_cip && in->level_ll && permit)
            s->step = STEP_CIP;
        else if (in->cmd_fill && !s->dirty && permit)
            s->step = STEP_FILL;
        break;
    case STEP_FILL:
        s->dirty = true;
        if (in->level_h || in->level_hh)
            s->step = STEP_AGITATE;
        break;
    case STEP_AGITATE:
        if (in->temp_ok && in->agitator_ok)
            s->step = STEP_STORE;
        break;
    case STEP_STORE:
        if (in->cmd_empty && permit)
            s->step = STEP_EMPTY;
        else if (!in->temp_ok)
            s->step = STEP_AGITATE;
        break;
    case STEP_EMPTY:
        if (in->level_ll)
            s->step = STEP_IDLE;
        break;
    case STEP_CIP:
        if (in->cip_supply_ok && in->cip_return_ok && !in->level_l) {
            s->dirty = false;
            s->step = STEP_IDLE;
        }
        break;
    case STEP_FAULT:
        if (in->cmd_reset && !trip)
            s->step = STEP_IDLE;
        break;
    }

    s->filling = s->step == STEP_FILL;
    s->emptying = s->step == STEP_EMPTY;
    s->cleaning = s->step == STEP_CIP;
    s->mixing = s->step == STEP_AGITATE || s->step == STEP_STORE;
}

static void tank_update(tank_t *t, bool manual, bool plant_ok, bool cip_free, const tank_inputs *in, tank_outputs *out)
{
    sequence_t *s = &t->seq;
    bool ack = in->cmd_reset;

    alarm_update(&t->overfill, in->level_hh && in->level_h, s->filling, ack);
    alarm_update(&t->manhole, !in->manhole_closed, s->filling || s->cleaning, ack);
    alarm_update(&t->air, !in->air_ok, plant_ok, ack);
    alarm_update(&t->temp, !in->temp_ok, s->mixing, ack);
    alarm_update(&t->probe, (in->level_hh && in->level_ll) || (in->level_h && !in->level_l), true, ack);
    alarm_update(&t->cip, in->cip_return_ok && !in->cip_supply_ok, s->cleaning, ack);

    bool trip = (t->manhole.active && t->manhole.unacked && t->probe.active)
        || (t->air.active && t->overfill.active)
        || (t->inlet.fault && t->outlet.fault);
    sequence_update(s, in, plant_ok && in->air_ok && (cip_free || !in->cmd_cip), trip);

    out->inlet = valve_update(&t->inlet, s->filling, manual, in->cmd_fill,
        !in->level_hh && in->manhole_closed && in->air_ok && !s->cleaning, in->inlet_fb, ack);
    out->outlet = valve_update(&t->outlet, s->emptying || (s->cleaning && in->level_l), manual, in->cmd_empty,
        in->air_ok && !t->inlet.out && !(s->filling || trip), in->outlet_fb, ack);
    out->cip_inlet = valve_update(&t->cip_in, s->cleaning && in->cip_supply_ok, manual, in->cmd_cip,
        cip_free && !t->inlet.out && in->manhole_closed && !in->level_h, in->cip_supply_ok, ack);
    out->cip_return = valve_update(&t->cip_ret, s->cleaning || t->cip_in.out, false, false,
        !t->outlet.fault && !t->inlet.out, in->cip_return_ok, ack);

    out->agitator = (s->mixing || (out->agitator && !in->level_ll)) && in->manhole_closed && in->agitator_ok;
    out->horn = t->overfill.unacked || t->manhole.unacked || t->air.unacked
        || t->temp.unacked || t->probe.unacked || t->cip.unacked;
    out->lamp = t->overfill.lamp || t->manhole.lamp || t->air.lamp || t->temp.lamp || t->probe.lamp || t->cip.lamp;
    t->uses_cip = out->cip_inlet || out->cip_return;
    t->faulted = s->step == STEP_FAULT;
}

static inline bool bit(uint16_t w, int n) { return (w >> n) & 1; }

static void read_inputs(uint16_t w, tank_inputs *in)
{
    in->level_ll = bit(w, 0);
    in->level_l = bit(w, 1);
    in->level_h = bit(w, 2);
    in->level_hh = bit(w, 3) && bit(w, 2);
    in->manhole_closed = bit(w, 4) || bit(w, 0);
    in->air_ok = bit(w, 5) || bit(w, 9) || bit(w, 1);
    in->inlet_fb = bit(w, 6) || bit(w, 2);
    in->outlet_fb = bit(w, 7) || bit(w, 3);
    in->cip_supply_ok = bit(w, 8);
    in->cip_return_ok = bit(w, 9);
    in->agitator_ok = bit(w, 10);
    in->temp_ok = bit(w, 11);
    in->cmd_fill = bit(w, 12);
    in->cmd_empty = bit(w, 13);
    in->cmd_cip = bit(w, 14);
    in->cmd_reset = bit(w, 15);
}

void scan(void)
{
    bool cip_busy = false, any_horn = false, any_fault = false;

    for (int i = 0; i < TANKS; i++) {
        tank_inputs *in = &inputs[i];
        tank_outputs *out = &outputs[i];

        noise = noise * 1664525u + 1013904223u;
        read_inputs((uint16_t)(noise >> 16), in);
        tank_update(&tanks[i], in->cmd_reset && in->cmd_fill, !any_fault || in->temp_ok, !cip_busy, in, out);
        cip_busy = cip_busy || tanks[i].uses_cip;
        any_horn = any_horn || out->horn;
        any_fault = any_fault || tanks[i].faulted;

        uint32_t bits = 0;
        if (out->inlet) bits += 1;
        if (out->outlet) bits += 2;
        if (out->cip_inlet) bits += 4;
        if (out->cip_return) bits += 8;
        if (out->agitator) bits += 16;
        if (out->lamp) bits += 32;
        if (any_horn) bits += 64;
        if (any_fault) bits += 128;
        check = (int32_t)((uint32_t)check * 31u + bits);
    }
}
