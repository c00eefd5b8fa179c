#include "st.h"
#include <stdbool.h>

enum cip_step { CIP_IDLE, CIP_PRERINSE, CIP_CAUSTIC, CIP_INTERRINSE, CIP_ACID, CIP_FINALRINSE, CIP_DRAIN };

struct valve { bool out, fbk_open, fbk_closed, interlock, alarm, mismatch_old; };
struct inputs { bool high, low, manhole_shut, fill_req, drain_req, cip_req, next, sticky; };
struct plant { bool air, estop, reset, cip_busy, any_alarm; };
struct alarm { bool active, unack, horn, old; };
struct chain { enum cip_step step; bool supply, caustic, acid, ret, busy; };
struct tank {
    struct valve inlet, outlet, cip;
    struct chain chain;
    struct alarm high, fault;
    bool filling, draining, dirty;
};

static void valve_run(struct valve *v, const struct plant *p, bool automatic, bool permit, bool sticky)
{
    v->interlock = !permit || !p->air || p->estop;
    v->out = automatic && !v->interlock && !v->alarm;
    bool mismatch = (v->out && v->fbk_closed) || (!v->out && v->fbk_open) || (v->fbk_open && v->fbk_closed);
    v->alarm = (v->alarm || (mismatch && v->mismatch_old)) && !p->reset;
    v->mismatch_old = mismatch;
    if (!sticky) {
        v->fbk_open = v->out;
        v->fbk_closed = !v->out;
    }
}

static void alarm_run(struct alarm *a, bool cond, bool ack)
{
    if (cond && !a->old)
        a->unack = a->horn = true;
    if (ack)
        a->unack = a->horn = false;
    a->active = cond || a->unack;
    a->old = cond;
}

static void chain_run(struct chain *c, bool start, bool next, bool abort)
{
    if (abort)
        c->step = CIP_IDLE;
    switch (c->step) {
    case CIP_IDLE:       if (start && !abort) c->step = CIP_PRERINSE; break;
    case CIP_PRERINSE:   if (next) c->step = CIP_CAUSTIC; break;
    case CIP_CAUSTIC:    if (next) c->step = CIP_INTERRINSE; break;
    case CIP_INTERRINSE: if (next) c->step = CIP_ACID; break;
    case CIP_ACID:       if (next) c->step = CIP_FINALRINSE; break;
    case CIP_FINALRINSE: if (next) c->step = CIP_DRAIN; break;
    case CIP_DRAIN:      if (next) c->step = CIP_IDLE; break;
    }
    c->busy = c->step != CIP_IDLE;
    c->caustic = c->step == CIP_CAUSTIC;
    c->acid = c->step == CIP_ACID;
    c->supply = c->busy && c->step != CIP_DRAIN;
    c->ret = c->supply || c->step == CIP_DRAIN;
}

static int32_t tank_run(struct tank *t, const struct inputs *in, struct plant *p)
{
    chain_run(&t->chain, in->cip_req && !in->low && in->manhole_shut && !t->filling,
              in->next, p->estop || !in->manhole_shut);

    t->filling = (t->filling || (in->fill_req && !t->dirty)) && !in->high && !t->chain.busy && !p->estop;
    t->draining = (t->draining || in->drain_req) && in->low && !t->chain.busy && !t->filling;
    t->dirty = (t->dirty || t->draining) && t->chain.step != CIP_FINALRINSE;

    valve_run(&t->inlet, p, t->filling, !t->cip.fbk_open && !in->high, in->sticky);
    valve_run(&t->outlet, p, t->draining || t->chain.ret, t->inlet.fbk_closed || !t->filling,
              in->sticky && in->next);
    valve_run(&t->cip, p, t->chain.supply, !t->inlet.fbk_open && in->manhole_shut, false);

    alarm_run(&t->high, in->high && (t->filling || t->inlet.fbk_open), p->reset);
    alarm_run(&t->fault, t->inlet.alarm || t->outlet.alarm || t->cip.alarm, p->reset);
    p->any_alarm = p->any_alarm || t->high.active || t->fault.active;
    p->cip_busy = p->cip_busy || t->chain.busy;

    int32_t state = 0;
    if (t->inlet.out) state += 1;
    if (t->outlet.out) state += 2;
    if (t->cip.out) state += 4;
    if (t->high.horn != t->fault.horn) state += 8;
    if (t->fault.unack) state += 16;
    if (t->chain.caustic || t->chain.acid) state += 32;
    if (t->dirty) state += 64;
    return state;
}

static struct tank tanks[12];
static struct plant plant;
static uint32_t rnd = 0x12345678;
static int32_t scans;

void scan(void)
{
    uint32_t sum = (uint32_t)check;
    scans++;
    plant.air = scans % 50 != 0;
    plant.estop = scans % 211 == 210;
    plant.reset = scans % 16 == 15;
    plant.any_alarm = false;
    plant.cip_busy = false;

    for (int i = 0; i < 12; i++) {
        rnd ^= rnd << 13;
        rnd ^= rnd >> 17;
        rnd ^= rnd << 5;
        struct inputs in = {
            .high = (rnd & 0x7) == 0,
            .low = (rnd & 0x10) != 0,
            .manhole_shut = (rnd & 0xFE0) != 0,
            .fill_req = (rnd & 0x3000) == 0,
            .drain_req = (rnd & 0xC000) == 0,
            .cip_req = (rnd & 0x30000) == 0,
            .next = (rnd & 0x40000) != 0,
            .sticky = (rnd & 0x380000) == 0,
        };
        sum = sum * 31 + (uint32_t)tank_run(&tanks[i], &in, &plant);
    }
    if (plant.any_alarm) sum += 1;
    if (plant.cip_busy) sum += 2;
    check = (int32_t)sum;
}
