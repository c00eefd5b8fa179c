/* Packaging line: drive interlocks, mode latches, product shift register */
#include <stdbool.h>
#include "st.h"

typedef struct {
    bool start_prev, reset_prev, idle_prev;
    bool run, fault, ready, stopped;
} conveyor_t;

typedef struct {
    bool start_prev, reset_prev, fault_prev, blink;
    bool safety_ok, automatic, manual, running;
    bool horn, green, red, yellow;
} mode_t_;

typedef struct {
    bool estop_ok, doors_ok, air_ok, pb_start, pb_stop, pb_reset;
    bool sel_auto, sel_manual, line_fault;
} mode_in_t;

static conveyor_t conv[24];
static mode_t_ mode;
static uint32_t rnd1 = 0x12345678u, rnd2 = 0x0BADCAFEu, rnd3 = 0x600DF00Du;
static uint32_t run, fault, ready, stopped, track, reject;

static inline uint32_t xorshift(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x;
}

static inline uint32_t rol(uint32_t x, unsigned n)
{
    return (x << n) | (x >> (32 - n));
}

static inline bool bit(uint32_t x, int n)
{
    return (x >> n) & 1u;
}

static inline bool rising(bool *prev, bool now)
{
    bool q = now && !*prev;
    *prev = now;
    return q;
}

/* Like F_TRIG: also true in the first call, when the signal is off from the start. */
static inline bool falling(bool *off_prev, bool now)
{
    bool q = !now && !*off_prev;
    *off_prev = !now;
    return q;
}

static void conveyor(conveyor_t *c, bool start, bool stop, bool reset,
                     bool guard_ok, bool motor_ok, bool downstream)
{
    bool start_edge = rising(&c->start_prev, start);
    bool reset_edge = rising(&c->reset_prev, reset);

    c->fault = !motor_ok || (c->run && !guard_ok) || (c->fault && !reset_edge);
    c->ready = !c->fault && guard_ok && motor_ok;
    c->run = !(stop || !c->ready) && ((start_edge && c->ready && downstream) || c->run);
    c->stopped = falling(&c->idle_prev, c->run);
}

static void mode_manager(mode_t_ *m, const mode_in_t *in)
{
    bool start_edge = rising(&m->start_prev, in->pb_start);
    bool reset_edge = rising(&m->reset_prev, in->pb_reset);

    m->safety_ok = !(!in->estop_ok || (!in->doors_ok && m->automatic)) && (reset_edge || m->safety_ok);
    m->automatic = in->sel_auto && !in->sel_manual && m->safety_ok;
    m->manual = in->sel_manual && !in->sel_auto;
    m->running = !(in->pb_stop || !m->safety_ok || !in->air_ok || m->manual) &&
                 ((start_edge && m->automatic && in->air_ok) || m->running);

    bool fault_edge = rising(&m->fault_prev, in->line_fault);
    m->blink = !m->blink;
    m->horn = fault_edge || (start_edge && !m->running);
    m->green = m->running || (m->safety_ok && m->blink);
    m->red = !m->safety_ok || (in->line_fault && m->blink);
    m->yellow = m->manual != (in->line_fault && !m->blink);
}

void scan(void)
{
    rnd1 = xorshift(rnd1);
    rnd2 = xorshift(rnd2);
    rnd3 = xorshift(rnd3);

    uint32_t w_start = rnd1;
    uint32_t w_stop = rnd1 & rnd2 & rnd3;
    uint32_t w_reset = rnd3;
    uint32_t w_guard = rnd1 | rnd2 | ~rnd3;
    uint32_t w_motor = rnd2 | rnd3 | rol(rnd1, 9);

    mode_in_t in = {
        .estop_ok = bit(rnd1, 0) || bit(rnd2, 1) || bit(rnd3, 2) || bit(rnd1, 3),
        .doors_ok = bit(rnd1, 4) || bit(rnd2, 5),
        .air_ok = bit(rnd1, 6) || bit(rnd2, 7) || bit(rnd3, 8),
        .pb_start = bit(rnd3, 9),
        .pb_stop = bit(rnd1, 10) && bit(rnd2, 11) && bit(rnd3, 12),
        .pb_reset = bit(rnd2, 13),
        .sel_auto = bit(rnd1, 14) || bit(rnd2, 15),
        .sel_manual = bit(rnd1, 16) && bit(rnd2, 17) && bit(rnd3, 18),
        .line_fault = fault != 0,
    };
    mode_manager(&mode, &in);

    run = fault = ready = stopped = 0;
    bool downstream = true;
    for (int i = 23; i >= 0; i--) {
        conveyor_t *c = &conv[i];
        conveyor(c, bit(w_start, i), bit(w_stop, i) || !mode.safety_ok, bit(w_reset, i),
                 bit(w_guard, i), bit(w_motor, i), downstream || mode.manual);
        downstream = c->run || i % 4 == 0;
        run |= (uint32_t)c->run << i;
        fault |= (uint32_t)c->fault << i;
        ready |= (uint32_t)c->ready << i;
        stopped |= (uint32_t)c->stopped << i;
    }

    bool infeed = bit(rnd2, 20) && bit(run, 0);
    bool bad = infeed && bit(rnd3, 21);
    track = track << 1 | infeed;
    reject = reject << 1 | bad;
    bool eject = bit(track, 12) && bit(reject, 12) && !bit(fault, 12);
    if (eject)
        track &= ~(1u << 12);

    uint32_t out = (uint32_t)mode.safety_ok | (uint32_t)mode.automatic << 1 |
                   (uint32_t)mode.manual << 2 | (uint32_t)mode.running << 3 |
                   (uint32_t)mode.horn << 4 | (uint32_t)mode.green << 5 |
                   (uint32_t)mode.red << 6 | (uint32_t)mode.yellow << 7 |
                   (uint32_t)eject << 8;

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + (run ^ rol(fault, 5) ^ rol(ready, 11) ^ rol(stopped, 17));
    sum = sum * 31 + (out ^ rol(track, 9) ^ rol(reject, 19));
    check = (int32_t)sum;
}
