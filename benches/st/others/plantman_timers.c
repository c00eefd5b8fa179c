/* 500 timers and counters of the bottling line
   460 in arrays, 40 by name */
#include <stdbool.h>
#include "st.h"

typedef struct { bool Q, Run; int32_t ET, Start; } ton_t;
typedef struct { bool Q, Old; int32_t ET, Start; } tof_t;
typedef struct { bool Q, Old; int32_t ET, Start; } tp_t;
typedef struct { bool Q, Old; int16_t CV; } ctu_t;
typedef struct { bool Q, Old; int16_t CV; } ctd_t;

static int32_t NowMs;

static void TON(ton_t *t, bool in, int32_t pt)
{
    if (!in) {
        t->Q = false;
        t->Run = false;
        t->ET = 0;
    } else {
        if (!t->Run) {
            t->Run = true;
            t->Start = NowMs;
        }
        if (!t->Q) {
            t->ET = NowMs - t->Start;
            if (t->ET >= pt) {
                t->ET = pt;
                t->Q = true;
            }
        }
    }
}

static void TOF(tof_t *t, bool in, int32_t pt)
{
    if (in) {
        t->Q = true;
        t->ET = 0;
    } else {
        if (t->Old)
            t->Start = NowMs;
        if (t->Q) {
            t->ET = NowMs - t->Start;
            if (t->ET >= pt) {
                t->ET = pt;
                t->Q = false;
            }
        }
    }
    t->Old = in;
}

static void TP(tp_t *t, bool in, int32_t pt)
{
    if (t->Q) {
        t->ET = NowMs - t->Start;
        if (t->ET >= pt) {
            t->ET = pt;
            t->Q = false;
        }
    } else if (in && !t->Old) {
        t->Q = true;
        t->Start = NowMs;
        t->ET = 0;
    }
    if (!t->Q && !in)
        t->ET = 0;
    t->Old = in;
}

static void CTU(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->CV = 0;
    else if (cu && !c->Old && c->CV < 32767)
        c->CV++;
    c->Old = cu;
    c->Q = c->CV >= pv;
}

static void CTD(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->CV = pv;
    else if (cd && !c->Old && c->CV > -32768)
        c->CV--;
    c->Old = cd;
    c->Q = c->CV <= 0;
}

static bool Init;
static int32_t Seed = 4711;
static int32_t Cycle;
static bool Bottle[120];        /* light barriers */
static int32_t GuardPT[120], TailPT[100];
static ton_t GuardTmr[120];
static tof_t TailTmr[100];
static tp_t GluePulse[80];
static ctu_t BottleCnt[100];
static ctd_t CrateCnt[60];
static ton_t Depal_StartDelay, Rinser_StartDelay, Filler_StartDelay, Capper_StartDelay;
static ton_t Pasteur_StartDelay, Labeler_StartDelay, Packer_StartDelay, Pallet_StartDelay;
static ton_t Depal_JamTmr, Rinser_JamTmr, Filler_JamTmr, Capper_JamTmr;
static ton_t Pasteur_JamTmr, Labeler_JamTmr, Packer_JamTmr, Pallet_JamTmr;
static tof_t Depal_RunOn, Rinser_RunOn, Filler_RunOn, Capper_RunOn;
static tof_t Pasteur_RunOn, Labeler_RunOn, Packer_RunOn, Pallet_RunOn;
static tp_t Rinser_Jet, Filler_Vent, Capper_Press, Labeler_Glue, Coder_Shot, Inspect_Kick;
static ctu_t Filler_Total, Capper_Total, Inspect_Rejects, Labeler_Total, Packer_Cases, Pallet_Layers;
static ctd_t Cap_Stock, Label_Stock, Glue_Stock, Tray_Stock;
static bool Reset;

void scan(void)
{
    int16_t i, k;
    int32_t Sum, Bits;

    NowMs = (int32_t)(now_us / 1000);
    if (!Init) {
        for (i = 0; i < 120; i++)
            GuardPT[i] = (i + 1) % 40 + 5;
        for (i = 0; i < 100; i++)
            TailPT[i] = (i + 1) % 25 + 3;
        Init = true;
    }

    Cycle = Cycle + 1;
    Reset = Cycle % 400 == 0;

    /* 8 light barriers change each cycle */
    for (k = 0; k < 8; k++) {
        Seed = (Seed * 171 + 11213) % 53125;
        i = Seed % 120;
        Bottle[i] = !Bottle[i];
    }

    for (i = 0; i < 120; i++)
        TON(&GuardTmr[i], Bottle[i], GuardPT[i]);
    for (i = 0; i < 100; i++)
        TOF(&TailTmr[i], Bottle[i], TailPT[i]);
    for (i = 0; i < 80; i++)
        TP(&GluePulse[i], Bottle[i + 20], 12);
    for (i = 0; i < 100; i++)
        CTU(&BottleCnt[i], Bottle[i], Reset, 20);
    for (i = 0; i < 60; i++)
        CTD(&CrateCnt[i], GuardTmr[i].Q, Reset || CrateCnt[i].Q, 6);

    /* by name */
    TON(&Depal_StartDelay, Bottle[0], 20);
    TON(&Rinser_StartDelay, Depal_StartDelay.Q, 8);
    TON(&Filler_StartDelay, Rinser_StartDelay.Q || Bottle[2], 10);
    TON(&Capper_StartDelay, Filler_StartDelay.Q, 6);
    TON(&Pasteur_StartDelay, Bottle[4] || Capper_StartDelay.Q, 30);
    TON(&Labeler_StartDelay, Capper_StartDelay.Q && !Bottle[5], 15);
    TON(&Packer_StartDelay, Labeler_StartDelay.Q || Bottle[6], 25);
    TON(&Pallet_StartDelay, Packer_StartDelay.Q, 5);

    TOF(&Depal_RunOn, Depal_StartDelay.Q, 9);
    TOF(&Rinser_RunOn, Rinser_StartDelay.Q, 11);
    TOF(&Filler_RunOn, Filler_StartDelay.Q, 14);
    TOF(&Capper_RunOn, Capper_StartDelay.Q, 7);
    TOF(&Pasteur_RunOn, Pasteur_StartDelay.Q, 40);
    TOF(&Labeler_RunOn, Labeler_StartDelay.Q, 10);
    TOF(&Packer_RunOn, Packer_StartDelay.Q, 12);
    TOF(&Pallet_RunOn, Pallet_StartDelay.Q, 16);

    TON(&Depal_JamTmr, Depal_RunOn.Q && Bottle[10], 18);
    TON(&Rinser_JamTmr, Rinser_RunOn.Q && Bottle[11], 18);
    TON(&Filler_JamTmr, Filler_RunOn.Q && Bottle[12], 22);
    TON(&Capper_JamTmr, Capper_RunOn.Q && Bottle[13], 22);
    TON(&Pasteur_JamTmr, Pasteur_RunOn.Q && Bottle[14], 50);
    TON(&Labeler_JamTmr, Labeler_RunOn.Q && Bottle[15], 12);
    TON(&Packer_JamTmr, Packer_RunOn.Q && Bottle[16], 12);
    TON(&Pallet_JamTmr, Pallet_RunOn.Q && Bottle[17], 35);

    TP(&Rinser_Jet, Bottle[11] && Rinser_RunOn.Q, 6);
    TP(&Filler_Vent, Bottle[12] && Filler_RunOn.Q, 9);
    TP(&Capper_Press, Bottle[13], 4);
    TP(&Labeler_Glue, Bottle[15], 5);
    TP(&Coder_Shot, Labeler_Glue.Q, 3);
    TP(&Inspect_Kick, Bottle[18] && !Bottle[19], 7);

    CTU(&Filler_Total, Filler_Vent.Q, Reset, 30);
    CTU(&Capper_Total, Capper_Press.Q, Reset, 28);
    CTU(&Inspect_Rejects, Inspect_Kick.Q, Reset || Depal_JamTmr.Q, 5);
    CTU(&Labeler_Total, Labeler_Glue.Q, Reset, 25);
    CTU(&Packer_Cases, Packer_RunOn.Q, Reset, 12);
    CTU(&Pallet_Layers, Packer_Cases.Q, Pallet_JamTmr.Q, 8);
    CTD(&Cap_Stock, Capper_Press.Q, Cap_Stock.Q || Reset, 50);
    CTD(&Label_Stock, Labeler_Glue.Q, Label_Stock.Q, 40);
    CTD(&Glue_Stock, Labeler_Glue.Q, Glue_Stock.Q || Reset, 15);
    CTD(&Tray_Stock, Packer_Cases.Q, Tray_Stock.Q, 10);

    /* all results */
    Sum = 0;
    for (i = 0; i < 120; i++) {
        if (GuardTmr[i].Q)
            Sum = Sum + i + 1;
        Sum = Sum + GuardTmr[i].ET;
    }
    for (i = 0; i < 100; i++) {
        if (TailTmr[i].Q)
            Sum = Sum + 3;
        Sum = Sum + TailTmr[i].ET + BottleCnt[i].CV;
    }
    for (i = 0; i < 80; i++) {
        if (GluePulse[i].Q)
            Sum = Sum + 5;
    }
    for (i = 0; i < 60; i++)
        Sum = Sum + CrateCnt[i].CV;
    Bits = 0;
    if (Depal_JamTmr.Q) Bits = Bits + 1;
    if (Rinser_JamTmr.Q) Bits = Bits + 2;
    if (Filler_JamTmr.Q) Bits = Bits + 4;
    if (Capper_JamTmr.Q) Bits = Bits + 8;
    if (Pasteur_JamTmr.Q) Bits = Bits + 16;
    if (Labeler_JamTmr.Q) Bits = Bits + 32;
    if (Packer_JamTmr.Q) Bits = Bits + 64;
    if (Pallet_JamTmr.Q) Bits = Bits + 128;
    if (Rinser_Jet.Q) Bits = Bits + 256;
    if (Coder_Shot.Q) Bits = Bits + 512;
    Sum = Sum + Filler_Total.CV + Capper_Total.CV + Inspect_Rejects.CV + Labeler_Total.CV
     + Packer_Cases.CV + Pallet_Layers.CV
     + Cap_Stock.CV + Label_Stock.CV + Glue_Stock.CV + Tray_Stock.CV;
    check = (check + Sum + Bits) % 10000000;
}
