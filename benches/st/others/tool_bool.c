/* Boolean networks, with && and || */
#include <stdbool.h>
#include "st.h"

struct conveyor {
    bool start, stop, estop_ok, guard_ok, auto_mode;
    bool part_in, part_out, overload, up_ready, down_ready;
    bool motor, ready, fault, lamp_green, lamp_red, horn, request;
    bool safe, enable, seal, jam, jam_latch, part_old, part_edge, occupied;
    bool release, step1, step2, step3, ack;
};

static void conveyor(struct conveyor *c)
{
    c->safe = c->estop_ok && c->guard_ok;
    c->enable = c->safe && !c->overload && !c->jam_latch;
    c->ack = c->start && c->stop && !c->motor;
    c->seal = (c->start || c->seal) && !c->stop && c->enable;
    c->part_edge = c->part_in && !c->part_old;
    c->part_old = c->part_in;
    c->occupied = (c->part_edge || c->occupied) && !c->part_out;
    c->jam = c->occupied && c->part_edge && !c->down_ready;
    c->jam_latch = (c->jam || c->jam_latch) && !c->ack;
    c->step1 = c->enable && c->auto_mode && c->occupied && !c->step3;
    c->step2 = ((c->step1 && c->down_ready) || c->step2) && c->enable && !c->part_out;
    c->step3 = (c->step2 && c->part_out) || (c->step3 && !c->up_ready);
    c->release = c->step2 && c->down_ready && !c->jam;
    c->motor = c->enable && ((c->seal && !c->auto_mode) || (c->auto_mode && (c->release || (!c->occupied && c->up_ready))));
    c->ready = c->enable && !c->occupied && (c->auto_mode || c->seal);
    c->fault = !c->safe || c->overload || c->jam_latch;
    c->request = c->auto_mode && c->ready && !c->up_ready;
    c->lamp_green = c->motor || (c->ready && !c->fault);
    c->lamp_red = c->fault || (c->stop && !c->motor);
    c->horn = (c->start && !c->seal && c->enable) || (c->jam && !c->ack);
}

struct press {
    bool left_hand, right_hand, curtain, upper_limit, lower_limit;
    bool die_locked, air_ok, mode_setup, estop_ok;
    bool valve_down, valve_up, brake, done, alarm;
    bool both_hands, hands_old, start_pulse, safe, cycle, stroke, returning, muting, tie;
};

static void press_cell(struct press *p)
{
    p->safe = p->estop_ok && p->air_ok && p->die_locked;
    p->muting = p->returning && !p->upper_limit;
    p->both_hands = p->left_hand && p->right_hand;
    p->start_pulse = p->both_hands && !p->hands_old;
    p->hands_old = p->both_hands;
    p->tie = (p->left_hand != p->right_hand) && p->cycle;
    p->cycle = ((p->start_pulse && p->upper_limit) || p->cycle) && p->safe && (p->curtain || p->muting) && !p->done;
    p->stroke = p->cycle && !p->returning && (p->both_hands || p->mode_setup);
    p->returning = ((p->stroke && p->lower_limit) || p->returning) && !p->upper_limit;
    p->valve_down = p->stroke && !p->lower_limit && !p->tie;
    p->valve_up = p->returning || (p->mode_setup && p->left_hand && !p->right_hand);
    p->brake = !p->valve_down && !p->valve_up;
    p->done = p->cycle && p->upper_limit && !p->stroke;
    p->alarm = (p->tie || !p->safe || (p->valve_down && p->valve_up) || p->alarm) && !(p->mode_setup && p->brake);
}

static uint32_t lfsr = 0xACE12B57u;
static bool inp[32];
static struct conveyor conv[24];
static struct press press[12];
static bool zone_a, zone_b, zone_c, any_fault, all_ready, hall_run, hall_horn, hall_stop;
static bool seq_a, seq_b, seq_c, seq_d, drain, refill, pump_a, pump_b, pump_sel, night;

void scan(void)
{
    bool fb = ((lfsr ^ (lfsr >> 10) ^ (lfsr >> 30) ^ (lfsr >> 31)) & 1u) == 1u;
    lfsr <<= 1;
    if (fb)
        lfsr |= 1u;
    for (int i = 0; i < 32; i++)
        inp[i] = ((lfsr >> i) & 1u) == 1u;

    int16_t n = 0;
    any_fault = false;
    all_ready = true;
    for (int i = 0; i < 24; i++) {
        struct conveyor *c = &conv[i];
        int j = i % 20;
        c->start = inp[j];
        c->stop = inp[j + 3] && inp[31];
        c->estop_ok = inp[j + 1] || !hall_stop;
        c->guard_ok = inp[j + 2] || inp[j + 7];
        c->auto_mode = !inp[30] || inp[j + 4];
        c->part_in = inp[j + 5];
        c->part_out = inp[j + 9];
        c->overload = inp[j + 6] && inp[j + 8] && inp[29];
        c->up_ready = inp[j + 10];
        c->down_ready = inp[j + 11];
        conveyor(c);
        any_fault = any_fault || c->fault;
        all_ready = all_ready && (c->ready || c->motor);
        if (c->motor) n = (int16_t)(n + 1);
        if (c->lamp_green && !c->lamp_red) n = (int16_t)(n + 3);
        if (c->horn || c->request) n = (int16_t)(n + 5);
    }
    for (int i = 0; i < 12; i++) {
        struct press *p = &press[i];
        p->left_hand = inp[i];
        p->right_hand = inp[i + 1];
        p->curtain = inp[i + 3] || inp[i + 4];
        p->upper_limit = inp[i + 5];
        p->lower_limit = inp[i + 7] && !inp[i + 5];
        p->die_locked = inp[i + 9] || inp[i + 11];
        p->air_ok = !hall_stop || inp[i + 12];
        p->mode_setup = inp[i + 15] && inp[i + 18];
        p->estop_ok = true;
        press_cell(p);
        any_fault = any_fault || p->alarm;
        if (p->valve_down) n = (int16_t)(n + 7);
        if (p->valve_up) n = (int16_t)(n + 11);
        if (p->done) n = (int16_t)(n + 13);
    }

    zone_a = conv[0].motor || conv[1].motor || (conv[2].motor && conv[3].ready);
    zone_b = (conv[8].motor && !conv[9].fault) || conv[10].ready;
    zone_c = (conv[16].motor || conv[17].motor) && (conv[18].ready || conv[19].ready);
    night = inp[20] && inp[21] && !inp[22];
    hall_stop = ((inp[23] && inp[24] && inp[25]) || hall_stop) && !(inp[26] && !night);
    hall_run = (zone_a || zone_b || zone_c || (hall_run && inp[27])) && !hall_stop;
    hall_horn = (any_fault && !night) || (hall_stop && inp[28]);
    seq_a = hall_run && !seq_b && !seq_c && !seq_d;
    seq_b = ((seq_a && zone_a) || seq_b) && !seq_c && hall_run;
    seq_c = ((seq_b && zone_b) || seq_c) && !seq_d && hall_run;
    seq_d = ((seq_c && zone_c) || seq_d) && inp[12];
    pump_sel = pump_sel != (seq_d && inp[13]);
    drain = (seq_d || drain) && !inp[14];
    refill = ((!drain && inp[15]) || refill) && !(inp[16] && inp[17]);
    pump_a = ((drain && !pump_sel) || (refill && pump_sel)) && !hall_stop;
    pump_b = ((drain && pump_sel) || (refill && !pump_sel)) && !hall_stop;

    int32_t word1 = 0;
    if (hall_run) word1 += 1;
    if (hall_horn) word1 += 2;
    if (seq_a || seq_c) word1 += 4;
    if (seq_b || seq_d) word1 += 8;
    if (pump_a) word1 += 16;
    if (pump_b) word1 += 32;
    if (all_ready) word1 += 64;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n + (uint32_t)word1 * 1000u);
}
