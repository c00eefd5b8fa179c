/* Boolean networks: starters, rungs, a ring, a chain, edges, latches. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool last; } Edge;
static inline bool rising(Edge *e, bool clk)  { bool q = clk && !e->last; e->last = clk; return q; }
/* F_TRIG of the standard: M keeps NOT CLK */
static inline bool falling(Edge *e, bool clk) { bool q = !clk && e->last; e->last = clk; return q; }

typedef struct { bool running, fault; Edge reset; } Motor;

static inline void motor_run(Motor *m, bool start, bool stop, bool overload, bool permit, bool reset)
{
    bool r = rising(&m->reset, reset);
    m->fault = (m->fault || (overload && m->running)) && !r;
    m->running = (start || m->running) && !stop && permit && !m->fault;
}

static inline uint32_t rol(uint32_t x, int n) { return x << n | x >> (32 - n); }

static uint32_t seed = 12345;
static bool din[32], chain[32], ring[16] = { true };
static Motor motor[32];
static Edge rise[16], fall[16];
static bool rise_q[16], fall_q[16], latch_s[8], latch_r[8];
static bool auto_mode, cycle, horn, clamp, unclamp, home, tool;
static int32_t edges;

void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    uint32_t in = seed ^ seed >> 13;
    for (int i = 0; i < 32; i++)
        din[i] = in >> i & 1;

    bool door_closed = din[0] || din[1];
    bool guard_ok = din[2] || !din[3];
    bool air_ok = din[4] || din[5] || din[6];
    bool oil_ok = din[7] || (air_ok && din[8]);
    bool estop_ok = !(din[9] && din[10] && din[11]);
    bool safe = door_closed && guard_ok && estop_ok;
    bool ready = safe && air_ok && oil_ok;
    auto_mode = (din[12] || auto_mode) && !din[13] && estop_ok;
    cycle = ((ready && auto_mode && din[14]) || cycle) && safe && !din[15];
    clamp = (cycle && !unclamp) || (din[16] && !auto_mode);
    unclamp = !clamp && (din[17] || home);
    bool spindle = clamp && cycle && !tool;
    bool coolant = spindle && (din[18] != din[19]);
    bool feed = spindle && (coolant || din[20]) && !home;
    home = (!feed && din[21]) || (home && !din[22]);
    tool = (tool && !din[23]) || (din[24] && !spindle);
    bool vacuum = (clamp != unclamp) && air_ok;
    bool green = cycle && ready;
    bool yellow = auto_mode && !cycle;
    bool red = !safe || !oil_ok;
    horn = red && !yellow && (din[25] || horn);

    if (din[26] && ready) {
        bool last = ring[15];
        for (int i = 15; i > 0; i--)
            ring[i] = ring[i - 1];
        ring[0] = last;
    }

    chain[0] = estop_ok;
    for (int i = 1; i < 32; i++)
        chain[i] = (chain[i - 1] || din[i]) && !(din[31 - i] && ring[i % 16]);

    uint32_t out_motor = 0, out_fault = 0, out_misc = 0;
    for (int i = 0; i < 32; i++) {
        Motor *m = &motor[i];
        motor_run(m, din[i],
                  din[(i + 7) % 32] && din[(i + 19) % 32],
                  din[(i + 3) % 32] && !chain[i],
                  chain[i] || !motor[(i + 1) % 32].running,
                  din[(i + 11) % 32]);
        out_motor = out_motor << 1 | m->running;
        out_fault = out_fault << 1 | m->fault;
    }

    for (int i = 0; i < 16; i++) {
        rise_q[i] = rising(&rise[i], motor[i].running);
        fall_q[i] = falling(&fall[i], chain[i + 16]);
        if (rise_q[i] || fall_q[i])
            edges++;
    }
    for (int i = 0; i < 8; i++) {
        latch_s[i] = rise_q[i] || (latch_s[i] && !fall_q[i + 8]);
        latch_r[i] = !fall_q[i] && (latch_r[i] || rise_q[i + 8]);
        out_misc = out_misc << 2 | latch_s[i] | latch_r[i] << 1;
    }
    for (int i = 0; i < 16; i++)
        if (ring[i])
            out_misc |= 0x10000u << i;
    if (green)  out_misc ^= 0x01000000u;
    if (yellow) out_misc ^= 0x02000000u;
    if (red)    out_misc ^= 0x04000000u;
    if (horn)   out_misc ^= 0x08000000u;
    if (vacuum) out_misc ^= 0x10000000u;
    if (feed)   out_misc ^= 0x20000000u;
    if (tool)   out_misc ^= 0x40000000u;

    check = (int32_t)((out_motor ^ rol(out_fault, 7) ^ rol(out_misc, 13)) + (uint32_t)edges);
}
