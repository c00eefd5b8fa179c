#include <stdbool.h>
#include "st.h"

#define STATIONS 16
#define STEPS 8

struct motor { bool run, fault, lamp, seen; };

static uint32_t seed = 12345;
static struct motor motors[STATIONS];
static bool start_btn[STATIONS], stop_btn[STATIONS], overload[STATIONS];
static bool door[STATIONS], occupied[STATIONS];
static bool chain[STEPS] = { true };
static bool blink, horn, horn_mem;

static bool two_of_three(bool a, bool b, bool c)
{
    return (a && b) || (a && c) || (b && c);
}

static bool bit(uint32_t w, int n)
{
    return (w >> n) & 1;
}

static void motor_update(struct motor *m, bool start, bool stop, bool over, bool closed,
                         bool enable, bool ack)
{
    m->fault = over || (m->run && !closed) || (m->fault && !ack);
    m->seen = m->fault && (m->seen || ack);
    m->run = (start || m->run) && !stop && !m->fault && closed && enable;
    m->lamp = (m->fault && !m->seen && blink) || (m->fault && m->seen) || (m->run && !m->fault);
}

void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    uint32_t in = seed;
    blink = !blink;
    bool ack = bit(in, 31) && bit(in, 30);
    bool emergency = bit(in, 29) && bit(in, 28) && bit(in, 27) && bit(in, 26) && bit(in, 25);
    for (int i = 0; i < STATIONS; i++) {
        in = in << 5 | in >> 27;
        start_btn[i] = bit(in, 7) || bit(in, 12);
        stop_btn[i] = bit(in, 9) && bit(in, 14) && bit(in, 19);
        overload[i] = bit(in, 8) && bit(in, 13) && bit(in, 18) && bit(in, 23);
        door[i] = two_of_three(bit(in, 11), bit(in, 16), !bit(in, 21)) || !bit(in, 26);
        occupied[i] = bit(in, 10) != bit(in, 15);
    }

    for (int i = 0; i < STATIONS; i++) {
        bool avail = i == STATIONS - 1 || motors[i + 1].run || !occupied[i + 1];
        bool enable = !emergency && avail && (!chain[0] || start_btn[i]);
        motor_update(&motors[i], start_btn[i], stop_btn[i], overload[i], door[i], enable, ack);
    }

    bool alarm = false, any = false, all = true;
    for (int i = 0; i < STATIONS; i++) {
        alarm = alarm || motors[i].fault;
        any = any || motors[i].run;
        all = all && (motors[i].run || motors[i].fault);
    }
    bool clk = alarm || emergency;
    bool edge = clk && !horn_mem;
    horn_mem = clk;
    horn = edge || (horn && !ack);

    bool t[STEPS];
    t[0] = chain[0] && start_btn[0] && !emergency;
    t[1] = chain[1] && motors[0].run;
    t[2] = chain[2] && (motors[1].run || motors[2].run);
    t[3] = chain[3] && any && !horn;
    t[4] = chain[4] && two_of_three(motors[3].run, motors[4].run, motors[5].run);
    t[5] = chain[5] && (occupied[6] != occupied[7]);
    t[6] = chain[6] && !(stop_btn[8] || stop_btn[9]);
    t[7] = chain[7] && (all || ack || !alarm || motors[15].lamp);
    chain[0] = ((chain[0] || t[STEPS - 1]) && !t[0]) || emergency;
    for (int i = 1; i < STEPS; i++)
        chain[i] = (chain[i] || t[i - 1]) && !t[i] && !emergency;

    int32_t bits = 0;
    for (int i = 0; i < STATIONS; i++) {
        bits *= 2;
        if (motors[i].run != motors[i].lamp)
            bits += 1;
        if (motors[i].fault)
            bits += 3;
    }
    for (int i = 0; i < STEPS; i++)
        if (chain[i])
            bits += 1000 * (i + 1);
    if (horn)
        bits += 77;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)bits);
}
