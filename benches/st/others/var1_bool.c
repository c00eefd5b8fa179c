/* && and || */
#include <stdbool.h>
#include "st.h"
typedef struct {
    bool run, fault, ready, horn, lamp;
    bool start_old, start_pulse, request, jam_mem, overload;
} conveyor_t;
static void conveyor(conveyor_t *c, bool start, bool stop, bool estop_ok, bool upstream_run,
                     bool full, bool jam, bool ack, bool auto_mode)
{
    c->start_pulse = start && !c->start_old;
    c->start_old = start;
    c->jam_mem = ((jam && c->run) || c->jam_mem) && !ack;
    c->overload = ((full && upstream_run && c->run) || c->overload) && !(ack && !full);
    c->fault = c->jam_mem || c->overload || !estop_ok;
    c->ready = estop_ok && !c->fault && !full;
    c->request = (c->start_pulse || (auto_mode && upstream_run) || c->request) && !stop && !c->fault;
    c->run = c->request && c->ready && (auto_mode || start || c->run);
    c->horn = (c->start_pulse && c->ready) || (c->fault && !c->horn);
    c->lamp = c->run || (c->fault && c->horn);
}
static conveyor_t conv[120];
static uint32_t seed = 12345;
#define BIT(x, n) (((x) >> (n)) & 1)
void scan(void)
{
    seed = seed * 1664525u + 1013904223u;
    uint32_t x = seed;
    bool up = BIT(x, 31);
    int32_t running = 0, faults = 0, lamps = 0;
    for (int16_t i = 0; i < 120; i++) {
        conveyor(&conv[i], BIT(x, 9), BIT(x, 10) && BIT(x, 11) && BIT(x, 12),
                 BIT(x, 13) || BIT(x, 14) || BIT(x, 15), up, BIT(x, 16) && BIT(x, 17),
                 BIT(x, 18) && BIT(x, 19) && BIT(x, 20), BIT(x, 21) && BIT(x, 22), BIT(x, 23));
        up = conv[i].run;
        if (conv[i].run) running += i;
        if (conv[i].fault) faults++;
        if (conv[i].lamp || conv[i].horn) lamps++;
        x = (x >> 3) | (x << 29);
    }
    check = (check % 100003) * 7 + running * 3 + faults * 5 + lamps;
}
