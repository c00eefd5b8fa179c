#include <stdbool.h>
#include "st.h"

typedef struct {
    bool estop_ok, air_ok, automatic, reset, cip, line_run, upstream_ok, any_fault, any_jam, parity;
} Bus;

typedef struct {
    bool start, stop, door, bottle_in, bottle_out, jam_eye, manual, jog, overload, level_low, level_high, press_ok;
} Inputs;

typedef struct { bool mem; } Edge;

typedef struct {
    bool coil, opened, closed, fault, coil_old;
    Edge rise, fall;
} Valve;

typedef struct {
    bool contactor, tripped, started, stopped, seal;
    Edge on, off, start;
} Motor;

typedef struct {
    Valve fill, vent, clamp;
    Motor conv, cap;
    Edge in, out, new_fault;
    bool jam, present, fill_done, blink, ack;
    bool ready, fault, lamp_g, lamp_y, lamp_r, horn;
} Station;

static bool rising(Edge *e, bool clk) { bool q = clk && !e->mem; e->mem = clk; return q; }
static bool falling(Edge *e, bool clk) { bool q = !clk && !e->mem; e->mem = !clk; return q; }

static void valve(Valve *v, bool open, bool close, bool interlock, bool reset, bool noise)
{
    v->coil = !(close | !interlock | v->fault) & ((open & interlock & !v->fault) | v->coil);
    v->opened = v->coil_old & v->coil & !noise;
    v->closed = !v->coil_old & !v->coil;
    bool r = rising(&v->rise, v->opened);
    bool f = falling(&v->fall, v->closed);
    bool set = (v->opened & v->closed) | (f & !v->coil) | (r & noise) | (noise & open & close);
    v->fault = set | (!(reset & !noise) & v->fault);
    v->coil_old = v->coil;
}

static void motor(Motor *m, bool start, bool stop, bool enable, bool jog, bool overload, bool reset)
{
    m->tripped = (overload & m->contactor) | (m->tripped & !reset);
    bool s = rising(&m->start, start);
    m->seal = (s | m->seal) & !stop & enable & !m->tripped;
    m->contactor = m->seal | (jog & !m->seal & enable & !m->tripped);
    m->started = rising(&m->on, m->contactor);
    m->stopped = falling(&m->off, m->contactor);
}

static void station(Station *s, Bus *bus, const Inputs *in)
{
    bool safe = bus->estop_ok & bus->air_ok & !in->door;
    bool bin = rising(&s->in, in->bottle_in);
    bool bout = falling(&s->out, in->bottle_out);
    s->present = (bin | s->present) & !bout;
    s->jam = (in->jam_eye & s->present & s->conv.contactor) | (!(bus->reset & !in->jam_eye) & s->jam);
    bool auto_run = bus->automatic & !in->manual & safe & !s->jam & bus->upstream_ok;
    bool clamp_req = s->present & (auto_run ^ (in->manual & in->jog));
    bool fill_req = s->clamp.opened & !s->fill_done & (in->level_low | !in->level_high) & in->press_ok & !bus->cip;
    s->fill_done = (in->level_high & s->fill.coil) | (s->fill_done & s->present);

    valve(&s->clamp, clamp_req, !s->present | s->fill_done, safe, bus->reset, in->jam_eye & in->door);
    valve(&s->fill, fill_req | (bus->cip & safe), in->level_high & !bus->cip, safe & !s->vent.fault, bus->reset,
          in->overload & in->stop);
    valve(&s->vent, s->fill.coil & in->press_ok, !s->fill.coil, safe | bus->cip, bus->reset,
          in->manual & in->jog & in->stop);
    motor(&s->conv, in->start | (auto_run & !s->clamp.coil), in->stop | s->fill.coil, safe & !s->jam,
          in->jog & in->manual, in->overload & in->jam_eye, bus->reset);
    motor(&s->cap, s->fill_done & auto_run, !s->present | in->stop, safe, in->jog & !in->manual & in->start,
          in->overload & in->level_low, bus->reset);

    s->fault = s->fill.fault | s->vent.fault | s->clamp.fault | s->conv.tripped | s->cap.tripped;
    bool nf = rising(&s->new_fault, s->fault | s->jam);
    s->ack = (s->ack | bus->reset) & !nf;
    s->horn = (nf | s->horn) & !s->ack & !in->stop;
    s->blink = !s->blink & (s->fault | s->jam);
    s->lamp_r = s->fault & (s->blink | s->ack);
    s->lamp_y = s->jam | (in->manual & !s->fault);
    s->lamp_g = auto_run & !s->fault & !s->lamp_y;
    s->ready = safe & !s->fault & !s->jam & (s->conv.contactor | s->cap.contactor | s->present);

    bus->any_fault |= s->fault;
    bus->any_jam |= s->jam;
    bus->upstream_ok = s->ready | !s->present;
    bus->parity ^= s->conv.started ^ s->cap.stopped ^ s->lamp_g ^ s->vent.closed ^ s->lamp_r;
}

static Station stations[16];
static Inputs inputs[16];
static Bus bus;
static uint32_t seed = 0x12345678u;

static uint32_t next_random(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x;
}

#define BIT(n) ((bool)((r >> (n)) & 1u))

void scan(void)
{
    uint32_t r = next_random(seed);
    bus.estop_ok = BIT(0) | BIT(1) | BIT(2) | BIT(3);
    bus.air_ok = BIT(4) | BIT(5) | BIT(6);
    bus.automatic = (bus.automatic | BIT(7)) & !(BIT(8) & BIT(9));
    bus.reset = BIT(10) & BIT(11) & !bus.line_run;
    bus.cip = BIT(12) & BIT(13) & BIT(14) & !bus.automatic;
    bus.upstream_ok = BIT(15) | BIT(16);
    bus.any_fault = bus.any_jam = bus.parity = false;

    for (int i = 0; i < 16; i++) {
        r = next_random(r);
        Inputs *in = &inputs[i];
        in->start = BIT(0) & BIT(20);
        in->stop = BIT(1) & BIT(2) & BIT(3);
        in->door = BIT(4) & BIT(5) & BIT(6) & BIT(7);
        in->bottle_in = BIT(8);
        in->bottle_out = BIT(9) | BIT(21);
        in->jam_eye = BIT(10) & BIT(11) & BIT(12);
        in->manual = BIT(13) & BIT(14);
        in->jog = BIT(15);
        in->overload = BIT(16) & BIT(17) & BIT(18);
        in->level_low = BIT(19);
        in->level_high = BIT(22) & !BIT(19);
        in->press_ok = BIT(23) | BIT(24);
        station(&stations[i], &bus, in);
    }
    seed = r;
    bus.line_run = !bus.any_fault & !bus.any_jam & bus.automatic;

    uint32_t w = 0;
    for (int i = 0; i < 16; i++)
        w = w * 2 + (stations[i].ready ^ stations[i].horn ^ stations[i].lamp_y);
    if (bus.parity) w += 65536;
    if (bus.line_run) w += 131072;
    check = (int32_t)((uint32_t)check * 31u + w + 1u);
}
