#include <stdbool.h>
#include "st.h"

struct segment {
    bool run, free, request, fault;
    bool occupied, jam, motor, pec_in_old, pec_out_old;
};

static uint32_t seed = 4711;
static bool pec[9];
static bool est_latch, gate_latch, air_latch, auto_mode, ack_old;
static struct segment seg[8];
static bool s_idle = true, s_recv, s_raise, s_send, s_lower, s_error;
static bool lift_free, y_up, y_down, y_belt;
static bool fault_old, horn;

static uint32_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed;
}

static inline bool bit(uint32_t w, int n)
{
    return (w >> n) & 1;
}

static void segment(struct segment *s, bool automatic, bool estop_ok, bool motor_prot,
                    bool pec_in, bool pec_out, bool next_free, bool prev_request,
                    bool jog, bool ack)
{
    bool entry = pec_in && !s->pec_in_old;
    bool leave = !pec_out && s->pec_out_old;
    s->pec_in_old = pec_in;
    s->pec_out_old = pec_out;

    s->occupied = (s->occupied || entry) && !leave;
    s->motor = (s->motor && !ack) || !motor_prot;
    s->jam = (s->jam && !ack) || (s->run && pec_in && pec_out && !next_free);

    s->fault = s->motor || s->jam;
    s->request = s->occupied && pec_out && !s->fault;
    s->free = !s->occupied && !s->fault && estop_ok;
    s->run = estop_ok && !s->fault &&
             ((automatic && ((s->occupied && (!pec_out || next_free)) ||
                             (prev_request && s->free))) ||
              (!automatic && jog));
}

void scan(void)
{
    uint32_t w1 = next_random();
    uint32_t w2 = next_random();

    bool prot[8];
    for (int i = 0; i <= 8; i++)
        pec[i] = bit(w1, 8 + i);
    for (int i = 0; i < 8; i++)
        prot[i] = ((w2 >> (9 + i)) & 7) != 0;
    bool jog = bit(w1, 20);
    bool ack_btn = bit(w1, 21) && bit(w1, 22);
    bool estop1 = bit(w1, 23) || bit(w1, 24) || bit(w1, 25);
    bool estop2 = bit(w1, 26) || bit(w1, 27) || bit(w1, 28);
    bool gate = bit(w2, 20) || bit(w2, 21) || bit(w1, 29);
    bool key_auto = bit(w2, 22) || bit(w2, 23);
    bool lift_up = bit(w2, 24);
    bool lift_down = bit(w2, 25);
    bool air_ok = bit(w2, 26) || bit(w2, 27) || bit(w2, 28);

    bool ack = ack_btn && !ack_old;
    ack_old = ack_btn;
    est_latch = (est_latch && !ack) || !(estop1 && estop2);
    gate_latch = (gate_latch && !ack) || (!gate && auto_mode);
    air_latch = (air_latch && !ack) || !air_ok;
    bool estop_ok = !est_latch && !gate_latch;
    auto_mode = key_auto && estop_ok && (auto_mode || ack || !jog);

    bool next_free = lift_free;
    bool any_fault = false;
    for (int i = 7; i >= 0; i--) {
        bool prev = i > 0 ? seg[i - 1].request : pec[0];
        segment(&seg[i], auto_mode, estop_ok, prot[i], pec[i], pec[i + 1],
                next_free, prev, jog, ack);
        next_free = seg[i].free;
        any_fault = any_fault || seg[i].fault;
    }

    bool t_recv = s_idle && seg[7].request && lift_down && auto_mode;
    bool t_raise = s_recv && !pec[8] && !seg[7].run;
    bool t_send = s_raise && lift_up && !lift_down;
    bool t_lower = s_send && (!pec[4] || !auto_mode);
    bool t_idle = s_lower && lift_down && !lift_up;
    bool t_error = (s_raise || s_lower) && lift_up && lift_down;
    bool t_quit = s_error && ack;

    s_idle = (s_idle || t_idle || t_quit) && !t_recv;
    s_recv = (s_recv || t_recv) && !t_raise;
    s_raise = (s_raise || t_raise) && !t_send && !t_error;
    s_send = (s_send || t_send) && !t_lower;
    s_lower = (s_lower || t_lower) && !t_idle && !t_error;
    s_error = (s_error || t_error) && !t_quit;

    lift_free = s_idle && lift_down && !air_latch;
    y_up = s_raise && estop_ok && !air_latch && !y_down;
    y_down = s_lower && estop_ok && !air_latch && !y_up;
    y_belt = (s_recv || s_send) && estop_ok;

    any_fault = any_fault || est_latch || gate_latch || air_latch || s_error;
    bool new_fault = any_fault && !fault_old;
    fault_old = any_fault;
    horn = (horn || new_fault) && !ack && any_fault;
    bool red = any_fault;
    bool yellow = !any_fault && !auto_mode;
    bool green = auto_mode && !any_fault;

    uint32_t image = 0;
    for (int i = 0; i < 8; i++) {
        image = image * 2 + (seg[i].run != seg[i].fault);
        image = image * 2 + (seg[i].free || seg[i].request);
    }
    image = image * 2 + (y_up || y_down);
    image = image * 2 + y_belt;
    image = image * 2 + s_idle;
    image = image * 2 + s_error;
    image = image * 2 + horn;
    image = image * 2 + red;
    image = image * 2 + yellow;
    image = image * 2 + green;
    check = (int32_t)((uint32_t)check * 31u + image);
}
