/* Conveyor interlocks and burner safety of a float glass line */
#include "st.h"
#include <stdbool.h>

#define SECTIONS 32
#define BURNERS 8

typedef struct { bool photo, photo1, photo2, run, jam, full; } section_t;
typedef struct { bool flame, ignite, gas, lockout; } burner_t;

static uint32_t noise = 0x2545F491u;
static section_t sec[SECTIONS + 1];
static burner_t burner[BURNERS];
static bool start_mem, ack_mem;
static bool rev_mem = true; /* as F_TRIG: a signal that is low at the first call counts as an edge */
static bool line_on, purge_done, horn, fire_left, any_gas;
static int32_t edges;

static inline bool bit(uint32_t w, int n) { return (w >> n) & 1u; }
static inline uint32_t rol(uint32_t w, int n) { return (w << n) | (w >> (32 - n)); }

static inline bool rising(bool clk, bool *mem)
{
    bool q = clk && !*mem;
    *mem = clk;
    return q;
}

static inline bool falling(bool clk, bool *mem)
{
    bool q = !clk && *mem;
    *mem = clk;
    return q;
}

void scan(void)
{
    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;

    bool air_ok = (noise & 0x7u) != 0;
    bool gas_ok = (noise & 0x78u) != 0;
    bool cool_ok = (noise & 0x380u) != 0x380u;
    bool estop = (noise & 0x7C00u) == 0x7C00u;
    bool packer = (noise & 0x18000u) != 0;

    bool start = rising(bit(noise, 17), &start_mem);
    bool ack = rising(bit(noise, 18), &ack_mem);
    if (falling(bit(noise, 19) && bit(noise, 20), &rev_mem)) {
        fire_left = !fire_left;
        edges++;
    }

    line_on = (start && !estop) || (line_on && !(estop || (!air_ok && !cool_ok)));
    purge_done = !(estop || !air_ok) && (purge_done || (air_ok && cool_ok && !any_gas));
    bool permit = purge_done && gas_ok && !estop;

    sec[SECTIONS].run = packer && line_on;
    sec[SECTIONS].full = !packer;
    uint32_t run_word = 0, jam_word = 0;
    bool any_jam = false;
    for (int i = SECTIONS - 1; i >= 0; i--) {
        section_t *s = &sec[i];
        const section_t *next = &sec[i + 1];
        s->photo2 = s->photo1;
        s->photo1 = s->photo;
        s->photo = bit(noise, i);
        s->full = s->photo && s->photo1 && !next->run;
        s->jam = (s->jam || (s->run && s->photo && s->photo1 && s->photo2)) && !ack;
        s->run = ((start && next->run) || (s->run && line_on) || (next->run && s->photo && !s->photo1))
                 && !estop && !s->jam && !next->full;
        any_jam = any_jam || s->jam;
        run_word = (run_word << 1) | s->run;
        jam_word = (jam_word << 1) | s->jam;
    }

    bool any_lock = false;
    any_gas = false;
    uint32_t valve_word = 0;
    for (int i = 0; i < BURNERS; i++) {
        burner_t *b = &burner[i];
        bool side = (i < 4) == fire_left;
        b->flame = b->gas && (sec[i + 4].photo || sec[i + 14].photo);
        b->lockout = (b->lockout || (b->gas && !b->flame && !b->ignite)) && !ack;
        b->ignite = permit && side && !b->flame && !b->lockout && !b->ignite;
        b->gas = permit && side && !b->lockout && (b->ignite || b->flame);
        any_lock = any_lock || b->lockout;
        any_gas = any_gas || b->gas;
        valve_word = (valve_word << 2) | ((uint32_t)b->gas << 1) | b->lockout;
    }

    horn = any_lock || (any_jam && !line_on) || (horn && !ack);

    uint32_t c = (uint32_t)check * 31u + (run_word ^ rol(jam_word, 7) ^ rol(valve_word, 16));
    c += (uint32_t)edges;
    if (horn)
        c += 5;
    if (permit)
        c += 3;
    check = (int32_t)c;
}
