/* Interlocks of twelve air handling units and of the plant they share */
#include <stdbool.h>
#include "st.h"

#define UNITS 12
#define BIT(w, n) ((((w) >> (n)) & 1u) != 0)

struct ahu_inputs {
    bool plant_release, start, stop, fire, frost, filter;
    bool supply_flow, extract_flow, supply_motor, extract_motor;
    bool damper_open, heat, cool, ack;
};

struct ahu {
    /* outputs */
    bool supply_fan, extract_fan, outside_damper, exhaust_damper;
    bool preheater_pump, heating_release, cooling_release, horn, alarm;
    uint16_t status, alarms;
    /* state */
    bool ack_prev, alarm_prev, stop_low;
    bool run;
    bool fire, frost, filter, supply_flow, extract_flow, supply_motor, extract_motor;
    bool supply_prev, extract_prev;
};

static struct ahu units[UNITS];
static uint32_t field = 0x2545F491u;
static bool fire_shutdown, pump_lead, boiler_low;

/* set-dominant and reset-dominant latches */
static inline bool sr(bool q, bool s, bool r) { return s || (q && !r); }
static inline bool rs(bool q, bool s, bool r) { return !r && (s || q); }

static void ahu_step(struct ahu *a, const struct ahu_inputs *in)
{
    bool ack = in->ack && !a->ack_prev;
    a->ack_prev = in->ack;
    bool stop = !in->stop && !a->stop_low;     /* F_TRIG: fires in its first call, too */
    a->stop_low = !in->stop;

    a->fire = sr(a->fire, in->fire, ack);
    a->frost = sr(a->frost, in->frost, ack && !a->fire);
    a->filter = sr(a->filter, in->filter && a->supply_fan, ack);
    a->supply_flow = sr(a->supply_flow, a->supply_fan && a->supply_prev && !in->supply_flow, ack);
    a->extract_flow = sr(a->extract_flow, a->extract_fan && a->extract_prev && !in->extract_flow, ack);
    a->supply_motor = sr(a->supply_motor, in->supply_motor, ack);
    a->extract_motor = sr(a->extract_motor, in->extract_motor, ack);

    bool hard_fault = a->fire || a->frost || a->supply_flow || a->supply_motor
                      || (a->extract_flow && a->extract_motor);
    a->alarm = hard_fault || a->filter || a->extract_flow || a->extract_motor;

    a->run = rs(a->run, in->start && in->plant_release, stop || hard_fault || !in->plant_release);
    a->supply_prev = a->supply_fan;
    a->extract_prev = a->extract_fan;
    a->outside_damper = a->run;
    a->exhaust_damper = a->run && !a->extract_motor;
    a->supply_fan = a->run && (in->damper_open || a->supply_fan);
    a->extract_fan = a->exhaust_damper && a->supply_fan && !a->extract_flow;

    a->preheater_pump = (a->supply_fan && in->heat) || a->frost;
    a->heating_release = a->preheater_pump && !a->fire;
    a->cooling_release = a->supply_fan && in->cool && !in->heat && !a->alarm;

    bool new_alarm = a->alarm && !a->alarm_prev;
    a->alarm_prev = a->alarm;
    a->horn = rs(a->horn, new_alarm, ack);

    a->status = (uint16_t)(a->run << 0 | a->supply_fan << 1 | a->extract_fan << 2
                | a->outside_damper << 3 | a->exhaust_damper << 4 | a->preheater_pump << 5
                | a->heating_release << 6 | a->cooling_release << 7 | a->horn << 8
                | a->alarm << 15);
    a->alarms = (uint16_t)(a->fire << 0 | a->frost << 1 | a->filter << 2 | a->supply_flow << 3
                | a->extract_flow << 4 | a->supply_motor << 5 | a->extract_motor << 6);
}

void scan(void)
{
    bool plant_release = !fire_shutdown;
    bool boiler = false, chiller = false, starting = false, any_fire = false, any_horn = false;
    uint32_t sum = (uint32_t)check;

    for (int i = 0; i < UNITS; i++) {
        struct ahu *a = &units[i];

        field ^= field << 13;
        field ^= field >> 17;
        field ^= field << 5;

        struct ahu_inputs in = {
            .plant_release = plant_release && !starting,
            .start = BIT(field, 0) || BIT(field, 1),
            .stop = BIT(field, 2) && BIT(field, 3) && BIT(field, 4),
            .fire = (field & 0x0003F800u) == 0x0003F800u,
            .frost = (field & 0x000003F0u) == 0x00000150u,
            .filter = BIT(field, 5) && BIT(field, 8) && BIT(field, 13),
            .supply_flow = BIT(field, 6) || BIT(field, 9) || BIT(field, 14) || BIT(field, 20),
            .extract_flow = BIT(field, 7) || BIT(field, 10) || BIT(field, 15) || BIT(field, 21),
            .supply_motor = (field & 0x00F80000u) == 0x00A80000u,
            .extract_motor = (field & 0x0F800000u) == 0x0A800000u,
            .damper_open = BIT(field, 22) || BIT(field, 24),
            .heat = BIT(field, 28) && !BIT(field, 29),
            .cool = BIT(field, 29),
            .ack = BIT(field, 30) && BIT(field, 31),
        };
        ahu_step(a, &in);

        boiler = boiler || a->heating_release;
        chiller = chiller || a->cooling_release;
        starting = a->outside_damper && !a->supply_fan;
        any_fire = any_fire || BIT(a->alarms, 0);
        any_horn = any_horn || a->horn;

        sum = sum * 31u + a->status;
        sum = sum * 31u + a->alarms;
    }

    fire_shutdown = sr(fire_shutdown, any_fire && boiler, !any_fire || BIT(field, 12));
    if (!boiler && !boiler_low)
        pump_lead = !pump_lead;
    boiler_low = !boiler;
    bool pump_a = boiler && (pump_lead || chiller);
    bool pump_b = boiler && (!pump_lead || chiller);

    uint32_t plant = (uint32_t)(plant_release << 0 | boiler << 1 | chiller << 2 | pump_a << 3
                     | pump_b << 4 | any_horn << 5 | fire_shutdown << 6 | any_fire << 7);
    check = (int32_t)(sum * 31u + plant);
}
