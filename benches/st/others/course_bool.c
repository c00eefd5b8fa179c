/* Course unit 1: relay logic. About 740 rungs per scan. */
#include "st.h"
#include <stdbool.h>

static uint32_t next_random(uint32_t seed)
{
    uint32_t x = seed ^ (seed << 13);
    x ^= x >> 17;
    return x ^ (x << 5);
}

static bool two_out_of_three(bool a, bool b, bool c)
{
    return (a && b) || (a && c) || (b && c);
}

typedef struct {
    bool contactor, fault, lamp_run, lamp_fault;
    bool ready, reset_old;
} DirectStarter;

static void direct_starter(DirectStarter *m, bool start, bool stop, bool overload, bool enable, bool reset)
{
    m->fault = overload || (m->fault && !(reset && !m->reset_old));
    m->reset_old = reset;
    m->ready = enable && !m->fault && !stop;
    m->contactor = (start || m->contactor) && m->ready;
    m->lamp_run = m->contactor && !m->fault;
    m->lamp_fault = (m->fault && !reset) || overload;
}

typedef struct {
    bool forward, backward, busy, blocked;
    bool ok, want_forward, want_reverse, conflict;
} ReversingStarter;

static void reversing_starter(ReversingStarter *a, bool go_forward, bool go_reverse, bool stop,
                              bool limit_front, bool limit_rear, bool overload)
{
    a->ok = !stop && !overload;
    a->conflict = go_forward && go_reverse;
    a->want_forward = go_forward && !a->conflict && !limit_front;
    a->want_reverse = go_reverse && !a->conflict && !limit_rear;
    a->forward = (a->want_forward || a->forward) && a->ok && !a->backward && !limit_front;
    a->backward = (a->want_reverse || a->backward) && a->ok && !a->forward && !limit_rear;
    a->busy = a->forward || a->backward;
    a->blocked = (limit_front && limit_rear) || a->conflict || (a->blocked && !stop);
}

static uint32_t seed = 0x1234567;
static bool inputs[64];
static DirectStarter motors[60];
static ReversingStarter axes[40];
static bool step0, step1, step2, step3, step4, step5, step6, step7;
static bool t01, t12, t23, t34, t45, t56, t67, t70;
static bool valve_fill, valve_drain, heater, mixer, pump, horn;
static bool level_low, level_mid, level_high, temp_ok, door_closed, emergency, ack;
static bool alarm_level, alarm_temp, alarm_door, alarm_any, first;
static bool safe, automatic, manual, mode_request;

void scan(void)
{
    seed = next_random(seed);
    uint32_t bits = seed;
    for (int i = 0; i < 32; i++) {
        inputs[i + 32] = inputs[i] ^ inputs[i + 32];
        inputs[i] = (bits & 1) != 0;
        bits >>= 1;
    }

    int32_t active = 0;
    for (int i = 0; i < 60; i++) {
        direct_starter(&motors[i], inputs[i], inputs[i + 1] && inputs[i + 3],
                       inputs[i + 2] && inputs[i + 4] && inputs[i],
                       inputs[i + 3] || inputs[i + 1], inputs[i + 4]);
        if (motors[i].lamp_run)
            active += 1;
        if (motors[i].lamp_fault)
            active += 100;
    }

    for (int i = 0; i < 40; i++) {
        reversing_starter(&axes[i], inputs[i], inputs[i + 5],
                          inputs[i + 9] && inputs[i + 10],
                          inputs[i + 11] && inputs[i + 1],
                          inputs[i + 12] && inputs[i + 2],
                          motors[i].fault && inputs[i + 20]);
        if (axes[i].busy && !axes[i].blocked)
            active += 10000;
    }

    level_low = inputs[0] || inputs[1];
    level_mid = level_low && inputs[2];
    level_high = level_mid && inputs[3];
    temp_ok = two_out_of_three(inputs[4], inputs[5], inputs[6]);
    door_closed = two_out_of_three(inputs[7], inputs[8], !inputs[9]);
    emergency = inputs[10] && inputs[11] && inputs[12] && inputs[13];
    ack = inputs[14];
    mode_request = inputs[15] && inputs[16];
    safe = !emergency && (door_closed || !mixer);
    automatic = (mode_request || automatic) && safe && !(inputs[17] && inputs[18] && inputs[19]);
    manual = !automatic && safe;

    t01 = step0 && automatic && !level_mid;
    t12 = step1 && level_high;
    t23 = step2 && temp_ok;
    t34 = step3 && inputs[20];
    t45 = step4 && (inputs[21] || inputs[22]);
    t56 = step5 && !level_mid;
    t67 = step6 && !level_low;
    t70 = step7 && ack;
    step1 = (step1 || t01) && !t12 && safe;
    step2 = (step2 || t12) && !t23 && safe;
    step3 = (step3 || t23) && !t34 && safe;
    step4 = (step4 || t34) && !t45 && safe;
    step5 = (step5 || t45) && !t56 && safe;
    step6 = (step6 || t56) && !t67 && safe;
    step7 = (step7 || t67) && !t70 && safe;
    step0 = !(step1 || step2 || step3 || step4 || step5 || step6 || step7);

    valve_fill = step1 || (manual && inputs[23] && !level_high);
    heater = (step2 || step3) && level_mid && !alarm_temp;
    mixer = (step3 || step4) && door_closed && safe;
    valve_drain = step5 || step6 || (manual && inputs[24]);
    pump = valve_drain && level_low && !valve_fill;
    alarm_level = (level_high && valve_fill) || (alarm_level && !ack);
    alarm_temp = (heater && temp_ok && inputs[25]) || (alarm_temp && !ack);
    alarm_door = (mixer && !door_closed) || (alarm_door && !ack);
    first = (alarm_level || alarm_temp || alarm_door) && !alarm_any;
    alarm_any = alarm_level || alarm_temp || alarm_door;
    horn = (first || horn) && alarm_any && !ack;

    if (pump) active += 7;
    if (horn) active += 13;
    if (heater != mixer) active += 29;
    if (step0 || step7) active += 31;
    check = (check * 31 + active) % 1000003;
}
