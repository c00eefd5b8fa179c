/* Timers and counters of sixty rooms, ten air handling units and ten pumps: 500 of them */
#include <stdbool.h>
#include "st.h"

#define ROOMS 60
#define UNITS 10
#define PUMPS 10
#define MS(x) ((uint64_t)(x) * 1000u)

struct ton { bool q, in; uint64_t start, et; };
struct tof { bool q, in; uint64_t start, et; };
struct tp  { bool q, in; uint64_t start, et; };
struct ctu { bool q, cu; int16_t cv; };
struct ctd { bool q, cd; int16_t cv; };
struct ctud { bool qu, qd, cu, cd; int16_t cv; };

static inline void ton(struct ton *t, bool in, uint64_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
    t->in = in;
}

static inline void tof(struct tof *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else if (t->q) {
        if (t->in)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
    t->in = in;
}

static inline void tp(struct tp *t, bool in, uint64_t pt)
{
    if (t->q) {
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->in) {
        t->start = now_us;
        t->et = 0;
        t->q = true;
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static inline void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static inline void ctud(struct ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu;
    bool down = cd && !c->cd;

    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->cu = cu;
    c->cd = cd;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

struct room {
    bool occupied, light, boost, window_alarm, valve_exercise;
    uint16_t status;
    struct ton occupancy_delay;
    struct tof light_run_on;
    struct tp boost_pulse;
    struct ton window_delay;
    struct ton valve_idle;
    struct ctu presence;
    struct ctud persons;
};

struct ahu {
    bool fan, damper_fault, filter_alarm;
    int16_t fan_starts;
    uint16_t status;
    struct ton start_delay;
    struct tof fan_run_on;
    struct ton damper_supervision;
    struct ton filter_delay;
    struct ctu starts;
};

struct pump {
    bool on, service_due;
    struct tof run_on;
    struct tp exercise;
    struct ctd service;
};

static struct room rooms[ROOMS];
static struct ahu ahus[UNITS];
static struct pump pumps[PUMPS];
static int32_t scan_counter;

static void room_step(struct room *r, bool motion, bool window, bool boost, bool valve_closed, bool reset)
{
    ton(&r->occupancy_delay, motion, MS(60));
    r->occupied = r->occupancy_delay.q;
    tof(&r->light_run_on, r->occupied, MS(250));
    r->light = r->light_run_on.q;
    tp(&r->boost_pulse, boost && r->occupied, MS(150));
    r->boost = r->boost_pulse.q;
    ton(&r->window_delay, window && !r->boost, MS(80));
    r->window_alarm = r->window_delay.q;
    ton(&r->valve_idle, valve_closed && !r->valve_exercise, MS(400));
    r->valve_exercise = r->valve_idle.q;
    ctu(&r->presence, r->occupied, reset, 20);
    ctud(&r->persons, motion, window, reset, r->valve_exercise, 5);

    r->status = (uint16_t)(r->occupied << 0 | r->light << 1 | r->boost << 2
                | r->window_alarm << 3 | r->valve_exercise << 4 | r->presence.q << 5
                | r->persons.qu << 6 | r->persons.qd << 7
                | (r->occupancy_delay.et > MS(30)) << 8
                | (r->light_run_on.et > MS(100)) << 9);
}

static void ahu_step(struct ahu *a, bool release, bool filter_dirty, bool damper_end, bool maintenance)
{
    ton(&a->start_delay, release && !a->damper_fault, MS(100));
    tof(&a->fan_run_on, a->start_delay.q, MS(180));
    a->fan = a->fan_run_on.q;
    ton(&a->damper_supervision, release && !damper_end, MS(300));
    a->damper_fault = a->damper_supervision.q;
    ton(&a->filter_delay, a->fan && filter_dirty, MS(70));
    a->filter_alarm = a->filter_delay.q;
    ctu(&a->starts, a->fan, maintenance, 10);
    a->fan_starts = a->starts.cv;

    a->status = (uint16_t)(a->fan << 0 | a->damper_fault << 1 | a->filter_alarm << 2 | a->starts.q << 3);
}

static void pump_step(struct pump *p, bool demand, bool exercise, bool service)
{
    tof(&p->run_on, demand, MS(120));
    tp(&p->exercise, exercise && !p->run_on.q, MS(50));
    p->on = p->run_on.q || p->exercise.q;
    ctd(&p->service, p->on, service, 15);
    p->service_due = p->service.q;
}

void scan(void)
{
    int occupied = 0, window_alarms = 0, fans = 0, pumps_on = 0;
    uint32_t sum = (uint32_t)check;

    scan_counter++;

    for (int i = 0; i < ROOMS; i++) {
        struct room *r = &rooms[i];
        int32_t phase = scan_counter + (i + 1) * 7;

        room_step(r, phase % 40 < 15, phase % 90 > 70, phase % 53 < 4, phase % 130 > 60, phase % 1500 == 0);
        occupied += r->occupied;
        window_alarms += r->window_alarm;
        sum = sum * 31u + r->status;
    }

    for (int i = 0; i < UNITS; i++) {
        struct ahu *a = &ahus[i];
        int32_t phase = scan_counter + (i + 1) * 13;

        ahu_step(a, occupied > (i + 1) * 2 || window_alarms > 20,
                 phase % 200 > 150, phase % 70 > 20, phase % 2000 == 0);
        fans += a->fan;
        sum = sum * 31u + a->status + (uint32_t)a->fan_starts;
    }

    for (int i = 0; i < PUMPS; i++) {
        struct pump *p = &pumps[i];
        int32_t phase = scan_counter + (i + 1) * 11;

        pump_step(p, fans >= i + 1 && phase % 60 < 30, phase % 100 < 2, phase % 3000 == 0);
        pumps_on += p->on;
        if (p->service_due)
            sum += 1000u;
    }

    check = (int32_t)(sum * 31u + (uint32_t)(occupied + window_alarms + fans + pumps_on));
}
