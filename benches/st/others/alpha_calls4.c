/* Conveyor drives: command words, interlocks, state machines, 40 drives */
#include <stdbool.h>
#include "st.h"

typedef struct { bool start, stop, jog; int16_t mode; uint16_t permit; } DriveCmd;
typedef struct { uint16_t word; int32_t starts; int16_t faults; int32_t hours; } DriveStat;

static int16_t bits_set(uint16_t w)
{
    int16_t n = 0;
    while (w != 0) {
        if (w & 1) n++;
        w >>= 1;
    }
    return n;
}

static bool permitted(uint16_t have, int16_t mode)
{
    uint16_t need;
    switch (mode) {
    case 0: need = 0x000F; break;
    case 1: case 2: need = 0x0033; break;
    case 3: case 4: case 5: need = 0x0101; break;
    default: need = 0x0001; break;
    }
    return (have & need) == need;
}

typedef struct { bool rise, fall, old; } Edge;

static void edge(Edge *e, bool clk)
{
    e->rise = clk && !e->old;
    e->fall = !clk && e->old;
    e->old = clk;
}

typedef struct {
    bool contactor;
    int16_t state;
    Edge start_edge;
    int16_t fb_wait, tick;
} Drive;

static void drive(Drive *d, const DriveCmd *cmd, bool ok, bool feedback, DriveStat *stat)
{
    edge(&d->start_edge, cmd->start);
    switch (d->state) {
    case 0:
        d->contactor = false;
        if (ok && (d->start_edge.rise || cmd->jog)) {
            d->state = 1;
            d->fb_wait = 0;
            stat->starts++;
        }
        break;
    case 1:
        d->contactor = true;
        d->fb_wait++;
        if (feedback)
            d->state = 2;
        else if (d->fb_wait > 6)
            d->state = 9;
        break;
    case 2:
        d->tick++;
        if (d->tick >= 36) {
            d->tick = 0;
            stat->hours++;
        }
        if (cmd->stop || !ok)
            d->state = 3;
        else if (!feedback)
            d->state = 9;
        break;
    case 3:
        d->contactor = false;
        if (!feedback) d->state = 0;
        break;
    case 9:
        d->contactor = false;
        if (d->fb_wait != 0) {
            stat->faults = (stat->faults + 1) % 1000;
            d->fb_wait = 0;
        }
        if (cmd->stop) d->state = 0;
        break;
    }
    stat->word = 0;
    if (d->contactor) stat->word |= 0x0001;
    if (d->state == 2) stat->word |= 0x0002;
    if (d->state == 9) stat->word |= 0x8000;
    if (ok) stat->word |= 0x0100;
    if (cmd->jog) stat->word |= 0x0010;
}

static int32_t cycle;
static uint32_t seed = 4711;
static DriveCmd cmd[40];
static DriveStat stat[40];
static Drive drives[40];
static Edge run_edge[40];
static bool fb[40];

void scan(void)
{
    bool upstream = true;
    int16_t alarms = 0;
    cycle++;
    for (int i = 0; i < 40; i++) {
        int16_t r;
        bool ok;
        seed = seed * 1664525u + 1013904223u;
        r = (int16_t)(seed / 131072u % 256u);
        cmd[i].start = r < 60;
        cmd[i].stop = r > 235;
        cmd[i].jog = r == 100;
        cmd[i].mode = (i + r / 64) % 7;
        cmd[i].permit = 0x0133;
        if (r % 16 != 0) cmd[i].permit |= 0x000C;
        ok = permitted(cmd[i].permit, cmd[i].mode) && (upstream || i % 8 == 0 || r > 20);
        drive(&drives[i], &cmd[i], ok, fb[i], &stat[i]);
        edge(&run_edge[i], drives[i].state == 2);
        if (r % 4 == 0) fb[i] = drives[i].contactor;
        upstream = drives[i].state == 2;
        if (run_edge[i].fall) alarms++;
        check = (int32_t)((uint32_t)check * 5u + (uint32_t)bits_set(stat[i].word) + (uint32_t)stat[i].starts + (uint32_t)stat[i].hours + (uint32_t)stat[i].faults);
    }
    check = (int32_t)((uint32_t)check + (uint32_t)alarms);
}
