#include "st.h"
#include <stdbool.h>

enum { CONVEYORS = 32, ZONES = 4 };

struct conveyor {
    bool motor, fault, occupied, transfer, ready, lamp, horn;
    bool start_mem, entry_mem, exit_mem;
    bool run, fault_latch;
    bool flip, horn_off;
};

struct zone {
    bool released, mismatch;
    bool ack_mem, tripped;
};

struct inputs {
    bool start, stop, reset, safe, sensor_in, sensor_out, arriving, next_free;
};

static struct conveyor line[CONVEYORS];
static struct zone zones[ZONES];
static uint32_t noise = 0x2545F491u;

static bool rising(bool *mem, bool clk)
{
    bool q = clk && !*mem;
    *mem = clk;
    return q;
}

/* *mem holds the inverted signal, as in F_TRIG of the standard */
static bool falling(bool *mem, bool clk)
{
    bool q = !clk && !*mem;
    *mem = !clk;
    return q;
}

static bool two_out_of_three(bool a, bool b, bool c)
{
    return (a && b) || (b && c) || (a && c);
}

static uint32_t next_noise(void)
{
    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;
    return noise;
}

static void conveyor_run(struct conveyor *c, const struct inputs *in)
{
    bool started = rising(&c->start_mem, in->start && !in->stop);
    bool entered = rising(&c->entry_mem, in->sensor_in || in->arriving);
    bool left = falling(&c->exit_mem, in->sensor_out);

    bool collision = entered && c->occupied && !c->motor && in->sensor_out;
    c->fault_latch = (!in->safe || collision) || (c->fault_latch && !(in->reset && in->safe));
    c->fault = c->fault_latch;

    c->run = !(c->fault || (in->stop && !in->start)) && (c->run || (started && !c->fault));
    c->occupied = (c->occupied || entered) && !left;
    bool blocked = c->occupied && !in->next_free;
    c->motor = c->run && in->safe && (!blocked || in->sensor_in != in->sensor_out);
    c->transfer = c->motor && c->occupied && in->next_free && !in->sensor_in;
    c->ready = c->run && !c->occupied && !blocked;

    c->flip = c->flip != (left || (c->fault && !c->horn_off));
    c->horn_off = (c->horn_off || in->reset) && c->fault;
    c->horn = c->fault && !c->horn_off && c->flip;
    c->lamp = (c->fault && c->flip) || (c->run && !blocked) || (c->ready && c->motor == c->flip);
}

static void zone_run(struct zone *z, bool a, bool b, bool c, bool acknowledge)
{
    bool healthy = two_out_of_three(a, b, c);
    z->mismatch = a != b || b != c;
    bool ack = rising(&z->ack_mem, acknowledge);
    z->tripped = !healthy || (z->tripped && !(ack && !z->mismatch));
    z->released = healthy && !z->tripped;
}

void scan(void)
{
    for (int i = 0; i < ZONES; i++) {
        uint32_t w = next_noise();
        zone_run(&zones[i], (w & 0x1F) != 0, (w & 0x3E0) != 0, (w & 0x7C00) != 0,
                 (w & 0x18000) == 0);
    }

    uint32_t lamps = 0;
    int32_t active = 0;
    bool arriving = line[CONVEYORS - 1].transfer;
    for (int i = 0; i < CONVEYORS; i++) {
        uint32_t w = next_noise();
        int next = i == CONVEYORS - 1 ? 0 : i + 1;
        struct conveyor *c = &line[i];
        const struct zone *z = &zones[i / 8];
        struct inputs in = {
            .start = w >> 3 & 1,
            .stop = (w & 0x700) == 0,
            .reset = w >> 12 & 1,
            .safe = z->released,
            .sensor_in = (w >> 17 & 1) && (w >> 21 & 1),
            .sensor_out = w >> 26 & 1,
            .arriving = arriving,
            .next_free = !line[next].occupied,
        };
        conveyor_run(c, &in);
        arriving = c->transfer;
        lamps = lamps * 2 + (c->lamp != c->horn);
        if (c->motor)
            active += 1;
        if (c->ready && !z->mismatch)
            active += 100;
    }
    check = (int32_t)((uint32_t)check * 31u + lamps + (uint32_t)active);
}
