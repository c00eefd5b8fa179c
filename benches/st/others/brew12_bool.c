/* Valve matrix, CIP routes, bottle conveyors and reject tracking. */
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define VALVES 32
#define ROUTES 8
#define CONVEYORS 24

struct valve {
    bool solenoid, fault;
    bool sol_last, ack_last;
};

struct route {
    bool active, done, lock_product;
    bool request_last, supply_off_last;
};

struct conveyor {
    bool run, jam;
    bool cell_last;
};

struct tracker {
    uint32_t track;
    bool pusher, label;
    bool clock_last;
};

static struct valve valves[VALVES];
static struct route routes[ROUTES];
static struct conveyor conveyors[CONVEYORS];
static struct tracker reject;
static uint32_t seed = 12345;

static inline uint32_t next_seed(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed;
}

static inline bool bit(uint32_t w, int n)
{
    return (w >> n) & 1u;
}

static inline uint32_t rol(uint32_t w, int n)
{
    return (w << n) | (w >> (32 - n));
}

static inline uint32_t ror(uint32_t w, int n)
{
    return (w >> n) | (w << (32 - n));
}

static void valve_step(struct valve *v, bool open_req, bool close_req, bool interlock,
                       bool fb_open, bool fb_closed, bool ack)
{
    bool ack_edge = ack && !v->ack_last;
    v->ack_last = ack;

    if (close_req || !interlock || v->fault)
        v->solenoid = false;
    else if (open_req)
        v->solenoid = true;

    if ((fb_open && fb_closed) || (v->solenoid && v->sol_last && fb_closed && !fb_open))
        v->fault = true;
    else if (ack_edge)
        v->fault = false;

    v->sol_last = v->solenoid;
}

static void route_step(struct route *r, bool request, bool abort, bool tank_empty,
                       bool supply_ok, bool product_off)
{
    bool request_edge = request && !r->request_last;
    bool supply_fall = !supply_ok && !r->supply_off_last; /* as F_TRIG: also in the first scan */
    r->request_last = request;
    r->supply_off_last = !supply_ok;

    r->active = (r->active || (request_edge && tank_empty && product_off)) && !abort && !supply_fall;
    r->done = supply_fall && !abort;
    r->lock_product = r->active || (request && tank_empty);
}

static void conveyor_step(struct conveyor *c, bool start, bool stop, bool guard_ok,
                          bool photocell, bool downstream, bool ack)
{
    bool cell_edge = photocell && !c->cell_last;
    c->cell_last = photocell;

    if (ack)
        c->jam = false;
    if (cell_edge && c->run && !downstream)
        c->jam = true;
    c->run = (c->run || (start && downstream)) && !stop && guard_ok && !c->jam;
}

static void tracker_step(struct tracker *t, bool clock, bool bad)
{
    bool edge = clock && !t->clock_last;
    t->clock_last = clock;
    if (edge)
        t->track = (t->track << 1) | bad;
    t->pusher = edge && bit(t->track, 12);
    t->label = bit(t->track, 20) && !bit(t->track, 21);
}

void scan(void)
{
    uint32_t open = next_seed();
    uint32_t close = next_seed() & rol(open, 7);
    uint32_t fb = next_seed() & ror(open, 11) & rol(close, 3);
    uint32_t misc = next_seed();
    bool ack = bit(misc, 31) && bit(misc, 30);
    bool estop = ((misc >> 26) & 0xF) == 0xF;

    for (int g = 0; g < ROUTES; g++) {
        struct route *r = &routes[g];
        route_step(r, bit(misc, g + 8), estop, bit(open, g + 16) || r->active,
                   bit(misc, g + 16) || bit(close, g),
                   !valves[4 * g].solenoid && !valves[4 * g + 1].solenoid);
    }

    uint32_t sol = 0, fault = 0, run = 0;
    for (int i = 0; i < VALVES; i++) {
        struct valve *v = &valves[i];
        const struct route *r = &routes[i / 4];
        bool fb_open = v->solenoid ^ bit(fb, i);
        if (i % 4 == 3)
            valve_step(v, r->active, r->done, !estop && r->lock_product, fb_open, !v->solenoid, ack);
        else
            valve_step(v, bit(open, i), bit(close, i), !estop && !r->lock_product,
                       fb_open, !v->solenoid, ack);
        sol |= (uint32_t)v->solenoid << i;
        fault |= (uint32_t)v->fault << i;
    }

    bool down = bit(misc, 0) || bit(misc, 1);
    for (int i = CONVEYORS - 1; i >= 0; i--) {
        struct conveyor *c = &conveyors[i];
        conveyor_step(c, bit(open, i) || bit(misc, 2), estop || (bit(close, i) && bit(fb, i)),
                      !(bit(fb, i + 8) && bit(misc, 4)), bit(misc, i), down, ack);
        down = c->run;
        run |= (uint32_t)c->run << i;
        fault ^= (uint32_t)c->jam << i;
    }

    tracker_step(&reject, bit(misc, 5), bit(open, 3) && !bit(close, 9));
    if (reject.pusher)
        run |= 1u << 30;
    if (reject.label)
        run |= 1u << 31;

    check = (int32_t)((uint32_t)check * 31u + (sol ^ rol(run, 5) ^ ror(fault, 9) ^ reject.track));
}
