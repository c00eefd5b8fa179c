#include <stdbool.h>
#include "st.h"

typedef struct {
    bool safe, impression, inkForm, inching, fault, warning, lampRed, lampGreen;
    bool fTemp, fGuard, fAir, firstTemp, firstGuard, firstAir;
    bool prepare, washed, sheetOld, inkLatch, stopLatch;
} Unit;

typedef struct {
    bool guardDs, guardOs, stopButton, overTemp, airOk, inkLow, sheetArrive,
         inkReq, inchKey, machineRuns, upstreamOk, ack;
} UnitIn;

static Unit unit[8];
static uint32_t seed = 4711;
static int chain;
static bool ackOld, allSafe, anyFault, compressor, feeder, hornQuit;

static void unit_interlock(Unit *u, UnitIn in)
{
    bool sheetEdge = in.sheetArrive && !u->sheetOld;
    u->sheetOld = in.sheetArrive;
    bool guards = in.guardDs && in.guardOs;

    u->fTemp = (in.overTemp || u->fTemp) && !(in.ack && !in.overTemp);
    u->fGuard = ((in.machineRuns && !guards) || u->fGuard) && !(in.ack && guards);
    u->fAir = ((u->impression && !in.airOk) || u->fAir) && !(in.ack && in.airOk);
    u->fault = u->fTemp || u->fGuard || u->fAir;

    u->firstTemp = u->fTemp && !u->firstGuard && !u->firstAir;
    u->firstGuard = u->fGuard && !u->firstTemp && !u->firstAir;
    u->firstAir = u->fAir && !u->firstTemp && !u->firstGuard;

    u->stopLatch = (in.stopButton || u->stopLatch) && !(in.ack && !in.stopButton);
    u->safe = guards && in.airOk && !u->fault && !u->stopLatch;

    u->inkLatch = in.inkLow || (u->inkLatch && !in.ack);
    u->warning = u->inkLatch && !u->fault;

    if (!u->safe || !in.machineRuns) {
        u->prepare = false;
        u->impression = false;
    } else if (u->impression) {
        u->prepare = false;
        u->impression = in.upstreamOk || in.sheetArrive;
    } else if (u->prepare) {
        u->impression = sheetEdge && in.upstreamOk;
    } else {
        u->prepare = in.upstreamOk;
    }

    u->inkForm = (u->impression || (in.inkReq && u->prepare)) && !in.inkLow && u->safe;
    u->washed = (!in.machineRuns && in.inchKey && !u->inkForm) || (u->washed && !u->inkForm);
    u->inching = in.inchKey && in.guardDs && !in.machineRuns && !u->fTemp
              && (in.guardOs || u->washed);
    u->lampRed = u->firstTemp || u->firstAir || (u->firstGuard != u->inching);
    u->lampGreen = u->safe && (u->impression || u->prepare) && !u->warning;
}

static inline bool bit(uint32_t w, int n) { return (w >> n) & 1u; }

static uint32_t next_rand(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed;
}

void scan(void)
{
    uint32_t w = next_rand();
    bool startKey = bit(w, 31) && bit(w, 30);
    bool stopKey = bit(w, 29) && bit(w, 28) && bit(w, 27) && bit(w, 26);
    bool ackKey = bit(w, 25);
    bool ack = ackKey && !ackOld;
    ackOld = ackKey;

    switch (chain) {
    case 0: if (startKey && allSafe && !stopKey) chain = 1; break;
    case 1: if (!allSafe || stopKey) chain = 0; else if (compressor) chain = 2; break;
    case 2: if (stopKey || anyFault) chain = 4; else if (startKey) chain = 3; break;
    case 3: if (stopKey || anyFault) chain = 4; break;
    case 4: if (!startKey) chain = 0; break;
    }
    bool runs = chain == 2 || chain == 3;
    compressor = chain > 0 && chain < 4;

    bool anyWarn = false, anyInch = false, up = feeder;
    int32_t bits = 0;
    allSafe = true;
    anyFault = false;
    for (int i = 0; i < 8; i++) {
        Unit *u = &unit[i];
        w = next_rand();
        unit_interlock(u, (UnitIn){
            .guardDs = (w & 0xF0000000u) != 0,
            .guardOs = (w & 0x0F800000u) != 0,
            .stopButton = (w & 0xF8000000u) == 0x50000000u,
            .overTemp = (w & 0x03F00000u) == 0x01200000u,
            .airOk = (w & 0x00FC0000u) != 0,
            .inkLow = (w & 0x001F0000u) == 0x00030000u,
            .sheetArrive = bit(w, 15),
            .inkReq = bit(w, 14) || bit(w, 22),
            .inchKey = bit(w, 13) && bit(w, 19),
            .machineRuns = runs,
            .upstreamOk = up,
            .ack = ack });
        up = u->impression;
        allSafe = allSafe && u->safe;
        anyFault = anyFault || u->fault;
        anyWarn = anyWarn || u->warning;
        anyInch = anyInch || u->inching;
        bits *= 2;
        if (u->lampRed) bits += 256;
        if (u->lampGreen) bits += 512;
        if (u->inkForm) bits += 7;
    }

    feeder = chain == 3 && !anyFault && !anyInch;
    hornQuit = (hornQuit || ack) && anyFault;
    bool horn = (anyFault && !hornQuit) || (anyWarn && startKey);
    if (horn) bits += 1;
    if (feeder) bits += 2;
    if (anyInch) bits += 4;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(bits + chain));
}
