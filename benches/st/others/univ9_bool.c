#include "st.h"
#include <stdbool.h>

#define DRIVES 16
#define CHAINS 8
#define ALARMS 24

struct drive { bool run, fault, ready, start_mem, run_mem; };
struct alarm_point { bool pending, horn, lamp, signal_mem; };
struct chain {
    bool fill, heat, mix, drain, safe, busy;
    bool valve_in, heater, mixer, valve_out, idle;
};

static struct drive drives[DRIVES];
static struct chain chains[CHAINS];
static struct alarm_point alarms[ALARMS];
static uint32_t seed = 12345;
static bool emergency, flash;

static bool bit(uint32_t w, int n) { return (w >> n) & 1; }
static bool two_of_three(bool a, bool b, bool c) { return (a && b) || (b && c) || (a && c); }

static void drive_update(struct drive *d, bool start, bool stop, bool permit,
                         bool overload, bool feedback, bool reset)
{
    d->fault = (d->fault | overload | (d->run_mem & d->run & !feedback)) & !(reset & !overload);
    d->ready = permit & !d->fault & !stop;
    d->run_mem = d->run;
    d->run = ((start & !d->start_mem) | d->run) & d->ready;
    d->start_mem = start;
}

static void alarm_update(struct alarm_point *a, bool signal, bool ack, bool flash_on)
{
    bool rising = signal & !a->signal_mem;
    a->signal_mem = signal;
    a->pending = (a->pending | rising) & !(ack & !rising);
    a->horn = (a->horn | rising) & a->pending;
    a->lamp = (a->pending & flash_on) | (signal & !a->pending);
}

static void chain_update(struct chain *c, bool go, bool full, bool hot, bool mixed,
                         bool empty, bool abort)
{
    bool t1 = !c->busy & go & !abort;
    bool t2 = c->fill & full;
    bool t3 = c->heat & hot;
    bool t4 = c->mix & mixed;
    bool t5 = c->drain & empty;
    bool t6 = c->safe & empty & !abort;
    c->fill = (c->fill | t1) & !t2 & !abort;
    c->heat = (c->heat | t2) & !t3 & !abort;
    c->mix = (c->mix | t3) & !t4 & !abort;
    c->drain = (c->drain | t4) & !t5 & !abort;
    c->safe = (c->safe | (abort & c->busy)) & !t6;
    c->busy = c->fill | c->heat | c->mix | c->drain | c->safe;
    c->valve_in = c->fill & !full;
    c->heater = c->heat | (c->mix & !hot);
    c->mixer = c->heat | c->mix;
    c->valve_out = c->drain | c->safe;
    c->idle = !c->busy;
}

static void add_check(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    uint32_t buttons = seed;
    seed = seed * 1664525u + 1013904223u;
    uint32_t sensors = seed;
    flash = !flash;

    bool guard_ok = two_of_three(bit(sensors, 31), bit(sensors, 30), bit(buttons, 31))
                    || bit(buttons, 29);
    emergency = (!guard_ok && bit(buttons, 30))
                || (emergency && !(bit(sensors, 28) && guard_ok));

    for (int i = DRIVES - 1; i >= 0; i--) {
        bool permit = !emergency;
        if (i < DRIVES - 1)
            permit &= drives[i + 1].run | bit(sensors, 27);
        drive_update(&drives[i],
                     bit(buttons, i + 8),
                     bit(buttons, 28) & bit(buttons, i + 4) & bit(sensors, i),
                     permit,
                     bit(sensors, i + 8) & bit(sensors, i + 5) & bit(buttons, i + 3),
                     drives[i].run & !(bit(sensors, i + 10) & bit(buttons, i)),
                     bit(sensors, 26));
    }

    for (int i = 0; i < CHAINS; i++)
        chain_update(&chains[i],
                     drives[2 * i].run | drives[2 * i + 1].ready,
                     bit(buttons, i + 12), bit(buttons, i + 16),
                     bit(sensors, i + 12), bit(sensors, i + 16),
                     emergency | (drives[2 * i].fault & drives[2 * i + 1].fault));

    bool horn = false;
    for (int i = 0; i < ALARMS; i++) {
        bool signal = i < DRIVES ? drives[i].fault
                    : chains[i - 16].valve_out & !chains[i - 16].mixer & emergency;
        alarm_update(&alarms[i], signal, bit(sensors, 25), flash);
        horn |= alarms[i].horn;
    }

    uint32_t image = 0;
    for (int i = 0; i < DRIVES; i++)
        image = image * 2 + (drives[i].run ^ drives[i].ready);
    add_check(image);
    image = 0;
    for (int i = 0; i < CHAINS; i++)
        image = image * 8 + chains[i].valve_in + chains[i].heater * 2u + chains[i].idle * 4u;
    add_check(image);
    image = horn;
    for (int i = 0; i < ALARMS; i++)
        image = image * 2 + alarms[i].lamp;
    add_check(image);
}
