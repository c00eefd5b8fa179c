/* Relay logic of a transfer line: 180 stations of 16 rungs and 30 rungs for the line itself. */
#include <stdbool.h>
#include "st.h"

struct station {
    bool ready, free, fault, clampOn, toolOn, liftUp;
    bool partIn, partOut, home, work, guard, overload, local, jog;
    bool automatic, release, clamped, cycle, done, guardErr, motorErr, seqErr, ackOld, ackEdge;
};

#define BIT(w, n) (((w) >> (n)) & 1)

static void station(struct station *s, uint16_t inputs, bool lineAuto, bool lineStop, bool ackAll, bool upReady, bool downFree)
{
    s->partIn   = BIT(inputs, 0);
    s->partOut  = BIT(inputs, 1);
    s->home     = BIT(inputs, 2);
    s->work     = BIT(inputs, 3);
    s->guard    = BIT(inputs, 4) || BIT(inputs, 5) || BIT(inputs, 9);
    s->overload = BIT(inputs, 6) && BIT(inputs, 7) && BIT(inputs, 8);
    s->local    = BIT(inputs, 10) && BIT(inputs, 11);
    s->jog      = BIT(inputs, 12);

    s->ackEdge  = ackAll && !s->ackOld;
    s->ackOld   = ackAll;
    s->guardErr = (s->guardErr || (!s->guard && s->cycle)) && !s->ackEdge;
    s->motorErr = (s->motorErr || (s->overload && (s->toolOn || s->liftUp))) && !(s->ackEdge && !s->overload);
    s->seqErr   = (s->seqErr || (s->home && s->work && s->cycle)) && !s->ackEdge;
    s->fault    = s->guardErr || s->motorErr || s->seqErr;
    s->automatic = lineAuto && !s->local && !s->fault;
    s->release  = s->automatic && s->guard && !lineStop;
    s->clampOn  = ((s->release && s->partIn && !s->done) || (s->clampOn && !s->done)) && !s->fault;
    s->clamped  = s->clampOn && (s->clamped || s->home);
    s->cycle    = s->release && s->clamped && !s->done && (upReady || s->cycle || s->partIn);
    s->toolOn   = (s->cycle && !s->work) || (s->local && s->jog && s->guard && !s->overload);
    s->liftUp   = ((s->cycle && s->work) || (s->liftUp && !s->home)) && !s->motorErr;
    s->done     = (s->done || (s->cycle && s->work)) && !(s->partOut && downFree) && s->automatic;
    s->ready    = (s->done && s->home && !s->liftUp) || (s->automatic && s->partOut);
    s->free     = !s->partIn && !s->clampOn && (s->automatic || s->local);
}

static int32_t seed = 4711;
static struct station st[182];
static bool start, stop, estop, air, oil, doorA, doorB, ack, lampTest, light;
static bool power, pump, pumpOk, autoOn, stopReq, quiet, anyFault, anyWork, horn, hornOff, blink, starved, blocked;
static bool lampRed, lampYellow, lampGreen, lampBlue, doorLock, valveAir, heater, cooler, feeder, outfeed;

void scan(void)
{
    seed = (seed * 1103 + 12345) % 65536;
    uint16_t panel = (uint16_t)seed;
    start    = BIT(panel, 0) || BIT(panel, 15);
    stop     = BIT(panel, 1) && BIT(panel, 2) && BIT(panel, 3);
    estop    = BIT(panel, 4) && BIT(panel, 5) && BIT(panel, 6) && BIT(panel, 14);
    air      = BIT(panel, 7) || BIT(panel, 8) || BIT(panel, 12);
    oil      = BIT(panel, 9) || BIT(panel, 10);
    doorA    = BIT(panel, 11) || BIT(panel, 13);
    doorB    = BIT(panel, 12) || !BIT(panel, 14);
    ack      = BIT(panel, 13) && BIT(panel, 3);
    lampTest = BIT(panel, 2) && BIT(panel, 9);
    light    = BIT(panel, 5) || BIT(panel, 8);

    blink    = !blink;
    power    = (power || start) && !estop;
    pump     = power && oil && (start || pump);
    pumpOk   = pump && (pumpOk || air);
    doorLock = power && autoOn && (doorA || doorB);
    quiet    = !stop && !estop && air;
    autoOn   = (autoOn || (start && pumpOk && doorA)) && quiet && power;
    stopReq  = (stopReq || stop) && !start && autoOn;

    int16_t faults = 0, tools = 0;
    for (int i = 1; i <= 180; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        station(&st[i], (uint16_t)seed, autoOn, stopReq, ack, st[i - 1].ready, st[i + 1].free);
        if (st[i].fault) faults++;
        if (st[i].toolOn || st[i].liftUp) tools++;
    }

    anyFault   = st[1].fault || st[30].fault || st[60].fault || st[90].fault || st[120].fault || st[150].fault || st[180].fault;
    anyWork    = st[15].toolOn || st[45].toolOn || st[75].toolOn || st[105].toolOn || st[135].toolOn || st[165].liftUp;
    hornOff    = (hornOff || ack) && anyFault;
    horn       = anyFault && !hornOff && blink;
    starved    = autoOn && !st[1].ready && !st[2].ready && st[3].free;
    blocked    = autoOn && !st[180].free && st[179].ready;
    feeder     = autoOn && !stopReq && (st[1].free || st[2].free) && !blocked;
    outfeed    = autoOn && (st[180].ready || (outfeed && !starved));
    valveAir   = power && air && (anyWork || feeder || outfeed);
    heater     = power && (heater || (oil && anyWork)) && !cooler;
    cooler     = (power && heater && (stopReq || light)) || (cooler && !quiet);
    lampRed    = lampTest || (anyFault && blink) || estop;
    lampYellow = lampTest || starved || (blocked && blink);
    lampGreen  = lampTest || (autoOn && !anyFault);
    lampBlue   = lampTest || (doorLock != horn);

    check = (check * 31 + faults * 100 + tools) % 1000003;
    if ((lampRed && !lampGreen) || (valveAir && cooler)) check += 1;
    if (lampYellow || (lampBlue && heater)) check += 2;
}
