/* packaging line: interlocks of 48 zones in plain rungs, 48 motor starters as blocks */
#include <stdbool.h>
#include "st.h"

typedef struct {
    bool xCmd, xRunning, xFault, xReady, xLamp;
    bool xStartOld, xResetOld, xMis1, xMis2, xManCmd;
} Starter;

static void starter(Starter *s, bool xStart, bool xStop, bool xAutoMode, bool xAutoReq, bool xPermit, bool xFbk, bool xOverload, bool xReset, bool xTick)
{
    bool xStartEdge = xStart && !s->xStartOld;
    s->xStartOld = xStart;
    bool xResetEdge = xReset && !s->xResetOld;
    s->xResetOld = xReset;
    bool xMismatch = s->xCmd != xFbk;
    s->xMis2 = (xTick && s->xMis1) || (!xTick && s->xMis2);
    s->xMis1 = xMismatch && (xTick || s->xMis1);
    bool xTrip = xOverload || (xMismatch && s->xMis1 && s->xMis2);
    s->xFault = (xTrip || s->xFault) && !(xResetEdge && !xTrip);
    s->xReady = xPermit && !s->xFault && !xStop;
    s->xManCmd = (xStartEdge || s->xManCmd) && s->xReady && !xAutoMode;
    bool xAutoCmd = xAutoMode && xAutoReq && s->xReady;
    s->xCmd = s->xManCmd || xAutoCmd;
    s->xRunning = s->xCmd && xFbk;
    s->xLamp = s->xRunning || (s->xFault && xTick);
}

static uint32_t dwRand = 0x2545F491u;
static bool aDI[64];
static bool aDQ[96];
static bool xSafetyOk, xServiceKey, xAuto, xManual, xResetAll, xResetOld, xTick;
static bool z01_EStopOk, z01_GuardOk, z01_Enable, z01_EntryEdge, z01_EntryOld, z01_ExitEdge;
static bool z01_ExitOld, z01_Occ, z01_Jam, z01_ReqFwd, z01_ReqRev, z01_Fwd;
static bool z01_Rev, z01_Ready, z01_Done, z01_Alarm, z02_EStopOk, z02_GuardOk;
static bool z02_Enable, z02_EntryEdge, z02_EntryOld, z02_ExitEdge, z02_ExitOld, z02_Occ;
static bool z02_Jam, z02_ReqFwd, z02_ReqRev, z02_Fwd, z02_Rev, z02_Ready;
static bool z02_Done, z02_Alarm, z03_EStopOk, z03_AtTop, z03_AtBottom, z03_Enable;
static bool z03_CallUp, z03_CallDown, z03_Fwd, z03_Rev, z03_Brake, z03_Jam;
static bool z03_Occ, z03_Done, z03_DoneOld, z03_Alarm, z04_EStopOk, z04_GuardOk;
static bool z04_Enable, z04_EntryEdge, z04_EntryOld, z04_ExitEdge, z04_ExitOld, z04_Occ;
static bool z04_Jam, z04_ReqFwd, z04_ReqRev, z04_Fwd, z04_Rev, z04_Ready;
static bool z04_Done, z04_Alarm, z05_TwoHand, z05_TieDown, z05_LightCurtain, z05_Muting;
static bool z05_Enable, z05_Start, z05_Fwd, z05_Rev, z05_Pressure, z05_Jam;
static bool z05_Occ, z05_Done, z05_DoneOld, z05_Vent, z05_Alarm, z06_EStopOk;
static bool z06_GuardOk, z06_Enable, z06_EntryEdge, z06_EntryOld, z06_ExitEdge, z06_ExitOld;
static bool z06_Occ, z06_Jam, z06_ReqFwd, z06_ReqRev, z06_Fwd, z06_Rev;
static bool z06_Ready, z06_Done, z06_Alarm, z07_EStopOk, z07_GuardOk, z07_Enable;
static bool z07_EntryEdge, z07_EntryOld, z07_ExitEdge, z07_ExitOld, z07_Occ, z07_Jam;
static bool z07_ReqFwd, z07_ReqRev, z07_Fwd, z07_Rev, z07_Ready, z07_Done;
static bool z07_Alarm, z08_EStopOk, z08_GuardOk, z08_Enable, z08_EntryEdge, z08_EntryOld;
static bool z08_ExitEdge, z08_ExitOld, z08_Occ, z08_Jam, z08_ReqFwd, z08_ReqRev;
static bool z08_Fwd, z08_Rev, z08_Ready, z08_Done, z08_Alarm, z09_EStopOk;
static bool z09_AtTop, z09_AtBottom, z09_Enable, z09_CallUp, z09_CallDown, z09_Fwd;
static bool z09_Rev, z09_Brake, z09_Jam, z09_Occ, z09_Done, z09_DoneOld;
static bool z09_Alarm, z10_EStopOk, z10_GuardOk, z10_Enable, z10_EntryEdge, z10_EntryOld;
static bool z10_ExitEdge, z10_ExitOld, z10_Occ, z10_Jam, z10_ReqFwd, z10_ReqRev;
static bool z10_Fwd, z10_Rev, z10_Ready, z10_Done, z10_Alarm, z11_TwoHand;
static bool z11_TieDown, z11_LightCurtain, z11_Muting, z11_Enable, z11_Start, z11_Fwd;
static bool z11_Rev, z11_Pressure, z11_Jam, z11_Occ, z11_Done, z11_DoneOld;
static bool z11_Vent, z11_Alarm, z12_EStopOk, z12_GuardOk, z12_Enable, z12_EntryEdge;
static bool z12_EntryOld, z12_ExitEdge, z12_ExitOld, z12_Occ, z12_Jam, z12_ReqFwd;
static bool z12_ReqRev, z12_Fwd, z12_Rev, z12_Ready, z12_Done, z12_Alarm;
static bool z13_EStopOk, z13_GuardOk, z13_Enable, z13_EntryEdge, z13_EntryOld, z13_ExitEdge;
static bool z13_ExitOld, z13_Occ, z13_Jam, z13_ReqFwd, z13_ReqRev, z13_Fwd;
static bool z13_Rev, z13_Ready, z13_Done, z13_Alarm, z14_EStopOk, z14_GuardOk;
static bool z14_Enable, z14_EntryEdge, z14_EntryOld, z14_ExitEdge, z14_ExitOld, z14_Occ;
static bool z14_Jam, z14_ReqFwd, z14_ReqRev, z14_Fwd, z14_Rev, z14_Ready;
static bool z14_Done, z14_Alarm, z15_EStopOk, z15_AtTop, z15_AtBottom, z15_Enable;
static bool z15_CallUp, z15_CallDown, z15_Fwd, z15_Rev, z15_Brake, z15_Jam;
static bool z15_Occ, z15_Done, z15_DoneOld, z15_Alarm, z16_EStopOk, z16_GuardOk;
static bool z16_Enable, z16_EntryEdge, z16_EntryOld, z16_ExitEdge, z16_ExitOld, z16_Occ;
static bool z16_Jam, z16_ReqFwd, z16_ReqRev, z16_Fwd, z16_Rev, z16_Ready;
static bool z16_Done, z16_Alarm, z17_TwoHand, z17_TieDown, z17_LightCurtain, z17_Muting;
static bool z17_Enable, z17_Start, z17_Fwd, z17_Rev, z17_Pressure, z17_Jam;
static bool z17_Occ, z17_Done, z17_DoneOld, z17_Vent, z17_Alarm, z18_EStopOk;
static bool z18_GuardOk, z18_Enable, z18_EntryEdge, z18_EntryOld, z18_ExitEdge, z18_ExitOld;
static bool z18_Occ, z18_Jam, z18_ReqFwd, z18_ReqRev, z18_Fwd, z18_Rev;
static bool z18_Ready, z18_Done, z18_Alarm, z19_EStopOk, z19_GuardOk, z19_Enable;
static bool z19_EntryEdge, z19_EntryOld, z19_ExitEdge, z19_ExitOld, z19_Occ, z19_Jam;
static bool z19_ReqFwd, z19_ReqRev, z19_Fwd, z19_Rev, z19_Ready, z19_Done;
static bool z19_Alarm, z20_EStopOk, z20_GuardOk, z20_Enable, z20_EntryEdge, z20_EntryOld;
static bool z20_ExitEdge, z20_ExitOld, z20_Occ, z20_Jam, z20_ReqFwd, z20_ReqRev;
static bool z20_Fwd, z20_Rev, z20_Ready, z20_Done, z20_Alarm, z21_EStopOk;
static bool z21_AtTop, z21_AtBottom, z21_Enable, z21_CallUp, z21_CallDown, z21_Fwd;
static bool z21_Rev, z21_Brake, z21_Jam, z21_Occ, z21_Done, z21_DoneOld;
static bool z21_Alarm, z22_EStopOk, z22_GuardOk, z22_Enable, z22_EntryEdge, z22_EntryOld;
static bool z22_ExitEdge, z22_ExitOld, z22_Occ, z22_Jam, z22_ReqFwd, z22_ReqRev;
static bool z22_Fwd, z22_Rev, z22_Ready, z22_Done, z22_Alarm, z23_TwoHand;
static bool z23_TieDown, z23_LightCurtain, z23_Muting, z23_Enable, z23_Start, z23_Fwd;
static bool z23_Rev, z23_Pressure, z23_Jam, z23_Occ, z23_Done, z23_DoneOld;
static bool z23_Vent, z23_Alarm, z24_EStopOk, z24_GuardOk, z24_Enable, z24_EntryEdge;
static bool z24_EntryOld, z24_ExitEdge, z24_ExitOld, z24_Occ, z24_Jam, z24_ReqFwd;
static bool z24_ReqRev, z24_Fwd, z24_Rev, z24_Ready, z24_Done, z24_Alarm;
static bool z25_EStopOk, z25_GuardOk, z25_Enable, z25_EntryEdge, z25_EntryOld, z25_ExitEdge;
static bool z25_ExitOld, z25_Occ, z25_Jam, z25_ReqFwd, z25_ReqRev, z25_Fwd;
static bool z25_Rev, z25_Ready, z25_Done, z25_Alarm, z26_EStopOk, z26_GuardOk;
static bool z26_Enable, z26_EntryEdge, z26_EntryOld, z26_ExitEdge, z26_ExitOld, z26_Occ;
static bool z26_Jam, z26_ReqFwd, z26_ReqRev, z26_Fwd, z26_Rev, z26_Ready;
static bool z26_Done, z26_Alarm, z27_EStopOk, z27_AtTop, z27_AtBottom, z27_Enable;
static bool z27_CallUp, z27_CallDown, z27_Fwd, z27_Rev, z27_Brake, z27_Jam;
static bool z27_Occ, z27_Done, z27_DoneOld, z27_Alarm, z28_EStopOk, z28_GuardOk;
static bool z28_Enable, z28_EntryEdge, z28_EntryOld, z28_ExitEdge, z28_ExitOld, z28_Occ;
static bool z28_Jam, z28_ReqFwd, z28_ReqRev, z28_Fwd, z28_Rev, z28_Ready;
static bool z28_Done, z28_Alarm, z29_TwoHand, z29_TieDown, z29_LightCurtain, z29_Muting;
static bool z29_Enable, z29_Start, z29_Fwd, z29_Rev, z29_Pressure, z29_Jam;
static bool z29_Occ, z29_Done, z29_DoneOld, z29_Vent, z29_Alarm, z30_EStopOk;
static bool z30_GuardOk, z30_Enable, z30_EntryEdge, z30_EntryOld, z30_ExitEdge, z30_ExitOld;
static bool z30_Occ, z30_Jam, z30_ReqFwd, z30_ReqRev, z30_Fwd, z30_Rev;
static bool z30_Ready, z30_Done, z30_Alarm, z31_EStopOk, z31_GuardOk, z31_Enable;
static bool z31_EntryEdge, z31_EntryOld, z31_ExitEdge, z31_ExitOld, z31_Occ, z31_Jam;
static bool z31_ReqFwd, z31_ReqRev, z31_Fwd, z31_Rev, z31_Ready, z31_Done;
static bool z31_Alarm, z32_EStopOk, z32_GuardOk, z32_Enable, z32_EntryEdge, z32_EntryOld;
static bool z32_ExitEdge, z32_ExitOld, z32_Occ, z32_Jam, z32_ReqFwd, z32_ReqRev;
static bool z32_Fwd, z32_Rev, z32_Ready, z32_Done, z32_Alarm, z33_EStopOk;
static bool z33_AtTop, z33_AtBottom, z33_Enable, z33_CallUp, z33_CallDown, z33_Fwd;
static bool z33_Rev, z33_Brake, z33_Jam, z33_Occ, z33_Done, z33_DoneOld;
static bool z33_Alarm, z34_EStopOk, z34_GuardOk, z34_Enable, z34_EntryEdge, z34_EntryOld;
static bool z34_ExitEdge, z34_ExitOld, z34_Occ, z34_Jam, z34_ReqFwd, z34_ReqRev;
static bool z34_Fwd, z34_Rev, z34_Ready, z34_Done, z34_Alarm, z35_TwoHand;
static bool z35_TieDown, z35_LightCurtain, z35_Muting, z35_Enable, z35_Start, z35_Fwd;
static bool z35_Rev, z35_Pressure, z35_Jam, z35_Occ, z35_Done, z35_DoneOld;
static bool z35_Vent, z35_Alarm, z36_EStopOk, z36_GuardOk, z36_Enable, z36_EntryEdge;
static bool z36_EntryOld, z36_ExitEdge, z36_ExitOld, z36_Occ, z36_Jam, z36_ReqFwd;
static bool z36_ReqRev, z36_Fwd, z36_Rev, z36_Ready, z36_Done, z36_Alarm;
static bool z37_EStopOk, z37_GuardOk, z37_Enable, z37_EntryEdge, z37_EntryOld, z37_ExitEdge;
static bool z37_ExitOld, z37_Occ, z37_Jam, z37_ReqFwd, z37_ReqRev, z37_Fwd;
static bool z37_Rev, z37_Ready, z37_Done, z37_Alarm, z38_EStopOk, z38_GuardOk;
static bool z38_Enable, z38_EntryEdge, z38_EntryOld, z38_ExitEdge, z38_ExitOld, z38_Occ;
static bool z38_Jam, z38_ReqFwd, z38_ReqRev, z38_Fwd, z38_Rev, z38_Ready;
static bool z38_Done, z38_Alarm, z39_EStopOk, z39_AtTop, z39_AtBottom, z39_Enable;
static bool z39_CallUp, z39_CallDown, z39_Fwd, z39_Rev, z39_Brake, z39_Jam;
static bool z39_Occ, z39_Done, z39_DoneOld, z39_Alarm, z40_EStopOk, z40_GuardOk;
static bool z40_Enable, z40_EntryEdge, z40_EntryOld, z40_ExitEdge, z40_ExitOld, z40_Occ;
static bool z40_Jam, z40_ReqFwd, z40_ReqRev, z40_Fwd, z40_Rev, z40_Ready;
static bool z40_Done, z40_Alarm, z41_TwoHand, z41_TieDown, z41_LightCurtain, z41_Muting;
static bool z41_Enable, z41_Start, z41_Fwd, z41_Rev, z41_Pressure, z41_Jam;
static bool z41_Occ, z41_Done, z41_DoneOld, z41_Vent, z41_Alarm, z42_EStopOk;
static bool z42_GuardOk, z42_Enable, z42_EntryEdge, z42_EntryOld, z42_ExitEdge, z42_ExitOld;
static bool z42_Occ, z42_Jam, z42_ReqFwd, z42_ReqRev, z42_Fwd, z42_Rev;
static bool z42_Ready, z42_Done, z42_Alarm, z43_EStopOk, z43_GuardOk, z43_Enable;
static bool z43_EntryEdge, z43_EntryOld, z43_ExitEdge, z43_ExitOld, z43_Occ, z43_Jam;
static bool z43_ReqFwd, z43_ReqRev, z43_Fwd, z43_Rev, z43_Ready, z43_Done;
static bool z43_Alarm, z44_EStopOk, z44_GuardOk, z44_Enable, z44_EntryEdge, z44_EntryOld;
static bool z44_ExitEdge, z44_ExitOld, z44_Occ, z44_Jam, z44_ReqFwd, z44_ReqRev;
static bool z44_Fwd, z44_Rev, z44_Ready, z44_Done, z44_Alarm, z45_EStopOk;
static bool z45_AtTop, z45_AtBottom, z45_Enable, z45_CallUp, z45_CallDown, z45_Fwd;
static bool z45_Rev, z45_Brake, z45_Jam, z45_Occ, z45_Done, z45_DoneOld;
static bool z45_Alarm, z46_EStopOk, z46_GuardOk, z46_Enable, z46_EntryEdge, z46_EntryOld;
static bool z46_ExitEdge, z46_ExitOld, z46_Occ, z46_Jam, z46_ReqFwd, z46_ReqRev;
static bool z46_Fwd, z46_Rev, z46_Ready, z46_Done, z46_Alarm, z47_TwoHand;
static bool z47_TieDown, z47_LightCurtain, z47_Muting, z47_Enable, z47_Start, z47_Fwd;
static bool z47_Rev, z47_Pressure, z47_Jam, z47_Occ, z47_Done, z47_DoneOld;
static bool z47_Vent, z47_Alarm, z48_EStopOk, z48_GuardOk, z48_Enable, z48_EntryEdge;
static bool z48_EntryOld, z48_ExitEdge, z48_ExitOld, z48_Occ, z48_Jam, z48_ReqFwd;
static bool z48_ReqRev, z48_Fwd, z48_Rev, z48_Ready, z48_Done, z48_Alarm;
static Starter fbInfeedA, fbAccumA, fbMergeA, fbLiftUpA, fbLiftDownA, fbPressA, fbPressPumpA, fbWrapA, fbWrapTurnA, fbLabelA, fbRejectA, fbOutfeedA, fbDustA, fbCoolA, fbLubeA, fbVacuumA, fbInfeedB, fbAccumB, fbMergeB, fbLiftUpB, fbLiftDownB, fbPressB, fbPressPumpB, fbWrapB, fbWrapTurnB, fbLabelB, fbRejectB, fbOutfeedB, fbDustB, fbCoolB, fbLubeB, fbVacuumB, fbInfeedC, fbAccumC, fbMergeC, fbLiftUpC, fbLiftDownC, fbPressC, fbPressPumpC, fbWrapC, fbWrapTurnC, fbLabelC, fbRejectC, fbOutfeedC, fbDustC, fbCoolC, fbLubeC, fbVacuumC;

void scan(void)
{
    int16_t i, j;
    uint32_t dwOut;

    dwRand ^= dwRand << 13;
    dwRand ^= dwRand >> 17;
    dwRand ^= dwRand << 5;
    for (i = 0; i < 32; i++)
        aDI[i] = ((dwRand >> i) & 1u) == 1u;
    dwRand ^= dwRand << 13;
    dwRand ^= dwRand >> 17;
    dwRand ^= dwRand << 5;
    for (i = 0; i < 32; i++)
        aDI[i + 32] = ((dwRand >> i) & 1u) == 1u;
    xSafetyOk = (aDI[0] || aDI[1] || aDI[2]) && !(aDI[3] && aDI[4] && aDI[5]);
    xServiceKey = aDI[6] && aDI[7] && !xAuto;
    xAuto = (aDI[8] || xAuto) && !aDI[9] && xSafetyOk;
    xManual = !xAuto && (aDI[10] || aDI[11]);
    xResetAll = aDI[12] && !xResetOld;
    xResetOld = aDI[12];
    xTick = !xTick;
    z01_EStopOk = aDI[41] && !aDI[60] && xSafetyOk;
    z01_GuardOk = aDI[9] || (aDI[25] && xServiceKey);
    z01_Enable = z01_EStopOk && z01_GuardOk && !z01_Jam;
    z01_EntryEdge = aDI[63] && !z01_EntryOld;
    z01_EntryOld = aDI[63];
    z01_ExitEdge = aDI[3] && !z01_ExitOld;
    z01_ExitOld = aDI[3];
    z01_Occ = (z01_EntryEdge || z01_Occ) && !z01_ExitEdge;
    z01_Jam = ((z01_EntryEdge && z01_Occ && aDI[4]) || z01_Jam) && !xResetAll;
    z01_ReqFwd = z01_Enable && !z01_Rev && (z48_Occ || z01_Occ || aDI[52]);
    z01_ReqRev = z01_Enable && !z01_Fwd && aDI[34] && xManual;
    z01_Fwd = z01_ReqFwd && !z01_ReqRev;
    z01_Rev = z01_ReqRev && !z01_ReqFwd;
    z01_Ready = z01_Enable && !z01_Occ && (xAuto || aDI[6]);
    z01_Done = z01_ExitEdge && z01_Fwd;
    z01_Alarm = z01_Jam || !z01_EStopOk || (!z01_GuardOk && z01_Fwd);
    z02_EStopOk = aDI[46] && !aDI[37] && xSafetyOk;
    z02_GuardOk = aDI[3] || (aDI[58] && xServiceKey);
    z02_Enable = z02_EStopOk && z02_GuardOk && !z02_Jam;
    z02_EntryEdge = aDI[32] && !z02_EntryOld;
    z02_EntryOld = aDI[32];
    z02_ExitEdge = aDI[13] && !z02_ExitOld;
    z02_ExitOld = aDI[13];
    z02_Occ = (z02_EntryEdge || z02_Occ) && !z02_ExitEdge;
    z02_Jam = ((z02_EntryEdge && z02_Occ && aDI[2]) || z02_Jam) && !xResetAll;
    z02_ReqFwd = z02_Enable && !z02_Rev && (z01_Occ || z02_Occ || aDI[5]);
    z02_ReqRev = z02_Enable && !z02_Fwd && aDI[27] && xManual;
    z02_Fwd = z02_ReqFwd && !z02_ReqRev;
    z02_Rev = z02_ReqRev && !z02_ReqFwd;
    z02_Ready = z02_Enable && !z02_Occ && (xAuto || aDI[26]);
    z02_Done = z02_ExitEdge && z02_Fwd;
    z02_Alarm = z02_Jam || !z02_EStopOk || (!z02_GuardOk && z02_Fwd);
    z03_EStopOk = aDI[8] && aDI[15] && xSafetyOk;
    z03_AtTop = aDI[5] && !aDI[35];
    z03_AtBottom = aDI[35] && !aDI[5];
    z03_Enable = z03_EStopOk && !z03_Jam && (aDI[27] || xServiceKey);
    z03_CallUp = (z02_Done || aDI[3] || z03_CallUp) && !z03_AtTop && z03_Enable;
    z03_CallDown = ((z03_AtTop && aDI[52]) || z03_CallDown) && !z03_AtBottom && z03_Enable && !z03_CallUp;
    z03_Fwd = z03_CallUp && !z03_CallDown && !z03_Brake;
    z03_Rev = z03_CallDown && !z03_CallUp && !z03_Brake;
    z03_Brake = !z03_Enable || (z03_AtTop && !z03_CallDown) || (z03_AtBottom && !z03_CallUp);
    z03_Jam = ((aDI[5] && aDI[35]) || (z03_Fwd && aDI[36] && aDI[7]) || z03_Jam) && !xResetAll;
    z03_Occ = (z02_Done && z03_AtBottom) || (z03_Occ && !(z03_AtTop && aDI[14]));
    z03_Done = z03_AtTop && aDI[14] && !z03_DoneOld;
    z03_DoneOld = z03_AtTop && aDI[14];
    z03_Alarm = z03_Jam || !z03_EStopOk;
    z04_EStopOk = aDI[7] && !aDI[36] && xSafetyOk;
    z04_GuardOk = aDI[37] || (aDI[25] && xServiceKey);
    z04_Enable = z04_EStopOk && z04_GuardOk && !z04_Jam;
    z04_EntryEdge = aDI[3] && !z04_EntryOld;
    z04_EntryOld = aDI[3];
    z04_ExitEdge = aDI[14] && !z04_ExitOld;
    z04_ExitOld = aDI[14];
    z04_Occ = (z04_EntryEdge || z04_Occ) && !z04_ExitEdge;
    z04_Jam = ((z04_EntryEdge && z04_Occ && aDI[2]) || z04_Jam) && !xResetAll;
    z04_ReqFwd = z04_Enable && !z04_Rev && (z03_Occ || z04_Occ || aDI[35]);
    z04_ReqRev = z04_Enable && !z04_Fwd && aDI[54] && xManual;
    z04_Fwd = z04_ReqFwd && !z04_ReqRev;
    z04_Rev = z04_ReqRev && !z04_ReqFwd;
    z04_Ready = z04_Enable && !z04_Occ && (xAuto || aDI[8]);
    z04_Done = z04_ExitEdge && z04_Fwd;
    z04_Alarm = z04_Jam || !z04_EStopOk || (!z04_GuardOk && z04_Fwd);
    z05_TwoHand = aDI[37] && aDI[26] && !z05_TieDown;
    z05_TieDown = (aDI[37] != aDI[26]) || (z05_TieDown && (aDI[37] || aDI[26]));
    z05_LightCurtain = aDI[9] || (z05_Muting && xAuto);
    z05_Muting = z05_Rev && aDI[34] && !aDI[7];
    z05_Enable = z05_LightCurtain && xSafetyOk && !z05_Jam && !aDI[36];
    z05_Start = (z05_TwoHand && xManual) || (z04_Done && xAuto);
    z05_Fwd = (z05_Start || z05_Fwd) && z05_Enable && !aDI[19];
    z05_Rev = ((aDI[19] && z05_Fwd) || z05_Rev) && z05_Enable && !aDI[35];
    z05_Pressure = z05_Fwd && (aDI[52] || z05_Pressure);
    z05_Jam = ((aDI[19] && aDI[35]) || (z05_Fwd && z05_Rev && aDI[43]) || z05_Jam) && !xResetAll;
    z05_Occ = z04_Done || (z05_Occ && !z05_Done);
    z05_Done = aDI[35] && z05_DoneOld;
    z05_DoneOld = z05_Rev && !aDI[35];
    z05_Vent = !z05_Enable || (z05_Rev && !z05_Pressure);
    z05_Alarm = z05_Jam || !z05_LightCurtain || (z05_TieDown && xManual);
    z06_EStopOk = aDI[23] && !aDI[6] && xSafetyOk;
    z06_GuardOk = aDI[37] || (aDI[36] && xServiceKey);
    z06_Enable = z06_EStopOk && z06_GuardOk && !z06_Jam;
    z06_EntryEdge = aDI[40] && !z06_EntryOld;
    z06_EntryOld = aDI[40];
    z06_ExitEdge = aDI[12] && !z06_ExitOld;
    z06_ExitOld = aDI[12];
    z06_Occ = (z06_EntryEdge || z06_Occ) && !z06_ExitEdge;
    z06_Jam = ((z06_EntryEdge && z06_Occ && aDI[63]) || z06_Jam) && !xResetAll;
    z06_ReqFwd = z06_Enable && !z06_Rev && (z05_Occ || z06_Occ || aDI[62]);
    z06_ReqRev = z06_Enable && !z06_Fwd && aDI[35] && xManual;
    z06_Fwd = z06_ReqFwd && !z06_ReqRev;
    z06_Rev = z06_ReqRev && !z06_ReqFwd;
    z06_Ready = z06_Enable && !z06_Occ && (xAuto || aDI[45]);
    z06_Done = z06_ExitEdge && z06_Fwd;
    z06_Alarm = z06_Jam || !z06_EStopOk || (!z06_GuardOk && z06_Fwd);
    z07_EStopOk = aDI[8] && !aDI[36] && xSafetyOk;
    z07_GuardOk = aDI[3] || (aDI[39] && xServiceKey);
    z07_Enable = z07_EStopOk && z07_GuardOk && !z07_Jam;
    z07_EntryEdge = aDI[13] && !z07_EntryOld;
    z07_EntryOld = aDI[13];
    z07_ExitEdge = aDI[31] && !z07_ExitOld;
    z07_ExitOld = aDI[31];
    z07_Occ = (z07_EntryEdge || z07_Occ) && !z07_ExitEdge;
    z07_Jam = ((z07_EntryEdge && z07_Occ && aDI[43]) || z07_Jam) && !xResetAll;
    z07_ReqFwd = z07_Enable && !z07_Rev && (z06_Occ || z07_Occ || aDI[34]);
    z07_ReqRev = z07_Enable && !z07_Fwd && aDI[27] && xManual;
    z07_Fwd = z07_ReqFwd && !z07_ReqRev;
    z07_Rev = z07_ReqRev && !z07_ReqFwd;
    z07_Ready = z07_Enable && !z07_Occ && (xAuto || aDI[49]);
    z07_Done = z07_ExitEdge && z07_Fwd;
    z07_Alarm = z07_Jam || !z07_EStopOk || (!z07_GuardOk && z07_Fwd);
    z08_EStopOk = aDI[40] && !aDI[29] && xSafetyOk;
    z08_GuardOk = aDI[37] || (aDI[59] && xServiceKey);
    z08_Enable = z08_EStopOk && z08_GuardOk && !z08_Jam;
    z08_EntryEdge = aDI[62] && !z08_EntryOld;
    z08_EntryOld = aDI[62];
    z08_ExitEdge = aDI[23] && !z08_ExitOld;
    z08_ExitOld = aDI[23];
    z08_Occ = (z08_EntryEdge || z08_Occ) && !z08_ExitEdge;
    z08_Jam = ((z08_EntryEdge && z08_Occ && aDI[19]) || z08_Jam) && !xResetAll;
    z08_ReqFwd = z08_Enable && !z08_Rev && (z07_Occ || z08_Occ || aDI[15]);
    z08_ReqRev = z08_Enable && !z08_Fwd && aDI[50] && xManual;
    z08_Fwd = z08_ReqFwd && !z08_ReqRev;
    z08_Rev = z08_ReqRev && !z08_ReqFwd;
    z08_Ready = z08_Enable && !z08_Occ && (xAuto || aDI[11]);
    z08_Done = z08_ExitEdge && z08_Fwd;
    z08_Alarm = z08_Jam || !z08_EStopOk || (!z08_GuardOk && z08_Fwd);
    z09_EStopOk = aDI[31] && aDI[5] && xSafetyOk;
    z09_AtTop = aDI[36] && !aDI[19];
    z09_AtBottom = aDI[19] && !aDI[36];
    z09_Enable = z09_EStopOk && !z09_Jam && (aDI[33] || xServiceKey);
    z09_CallUp = (z08_Done || aDI[63] || z09_CallUp) && !z09_AtTop && z09_Enable;
    z09_CallDown = ((z09_AtTop && aDI[56]) || z09_CallDown) && !z09_AtBottom && z09_Enable && !z09_CallUp;
    z09_Fwd = z09_CallUp && !z09_CallDown && !z09_Brake;
    z09_Rev = z09_CallDown && !z09_CallUp && !z09_Brake;
    z09_Brake = !z09_Enable || (z09_AtTop && !z09_CallDown) || (z09_AtBottom && !z09_CallUp);
    z09_Jam = ((aDI[36] && aDI[19]) || (z09_Fwd && aDI[21] && aDI[46]) || z09_Jam) && !xResetAll;
    z09_Occ = (z08_Done && z09_AtBottom) || (z09_Occ && !(z09_AtTop && aDI[28]));
    z09_Done = z09_AtTop && aDI[28] && !z09_DoneOld;
    z09_DoneOld = z09_AtTop && aDI[28];
    z09_Alarm = z09_Jam || !z09_EStopOk;
    z10_EStopOk = aDI[36] && !aDI[38] && xSafetyOk;
    z10_GuardOk = aDI[4] || (aDI[7] && xServiceKey);
    z10_Enable = z10_EStopOk && z10_GuardOk && !z10_Jam;
    z10_EntryEdge = aDI[32] && !z10_EntryOld;
    z10_EntryOld = aDI[32];
    z10_ExitEdge = aDI[26] && !z10_ExitOld;
    z10_ExitOld = aDI[26];
    z10_Occ = (z10_EntryEdge || z10_Occ) && !z10_ExitEdge;
    z10_Jam = ((z10_EntryEdge && z10_Occ && aDI[10]) || z10_Jam) && !xResetAll;
    z10_ReqFwd = z10_Enable && !z10_Rev && (z09_Occ || z10_Occ || aDI[48]);
    z10_ReqRev = z10_Enable && !z10_Fwd && aDI[21] && xManual;
    z10_Fwd = z10_ReqFwd && !z10_ReqRev;
    z10_Rev = z10_ReqRev && !z10_ReqFwd;
    z10_Ready = z10_Enable && !z10_Occ && (xAuto || aDI[9]);
    z10_Done = z10_ExitEdge && z10_Fwd;
    z10_Alarm = z10_Jam || !z10_EStopOk || (!z10_GuardOk && z10_Fwd);
    z11_TwoHand = aDI[62] && aDI[26] && !z11_TieDown;
    z11_TieDown = (aDI[62] != aDI[26]) || (z11_TieDown && (aDI[62] || aDI[26]));
    z11_LightCurtain = aDI[2] || (z11_Muting && xAuto);
    z11_Muting = z11_Rev && aDI[42] && !aDI[4];
    z11_Enable = z11_LightCurtain && xSafetyOk && !z11_Jam && !aDI[48];
    z11_Start = (z11_TwoHand && xManual) || (z10_Done && xAuto);
    z11_Fwd = (z11_Start || z11_Fwd) && z11_Enable && !aDI[35];
    z11_Rev = ((aDI[35] && z11_Fwd) || z11_Rev) && z11_Enable && !aDI[36];
    z11_Pressure = z11_Fwd && (aDI[50] || z11_Pressure);
    z11_Jam = ((aDI[35] && aDI[36]) || (z11_Fwd && z11_Rev && aDI[52]) || z11_Jam) && !xResetAll;
    z11_Occ = z10_Done || (z11_Occ && !z11_Done);
    z11_Done = aDI[36] && z11_DoneOld;
    z11_DoneOld = z11_Rev && !aDI[36];
    z11_Vent = !z11_Enable || (z11_Rev && !z11_Pressure);
    z11_Alarm = z11_Jam || !z11_LightCurtain || (z11_TieDown && xManual);
    z12_EStopOk = aDI[40] && !aDI[21] && xSafetyOk;
    z12_GuardOk = aDI[44] || (aDI[22] && xServiceKey);
    z12_Enable = z12_EStopOk && z12_GuardOk && !z12_Jam;
    z12_EntryEdge = aDI[38] && !z12_EntryOld;
    z12_EntryOld = aDI[38];
    z12_ExitEdge = aDI[31] && !z12_ExitOld;
    z12_ExitOld = aDI[31];
    z12_Occ = (z12_EntryEdge || z12_Occ) && !z12_ExitEdge;
    z12_Jam = ((z12_EntryEdge && z12_Occ && aDI[37]) || z12_Jam) && !xResetAll;
    z12_ReqFwd = z12_Enable && !z12_Rev && (z11_Occ || z12_Occ || aDI[51]);
    z12_ReqRev = z12_Enable && !z12_Fwd && aDI[29] && xManual;
    z12_Fwd = z12_ReqFwd && !z12_ReqRev;
    z12_Rev = z12_ReqRev && !z12_ReqFwd;
    z12_Ready = z12_Enable && !z12_Occ && (xAuto || aDI[4]);
    z12_Done = z12_ExitEdge && z12_Fwd;
    z12_Alarm = z12_Jam || !z12_EStopOk || (!z12_GuardOk && z12_Fwd);
    z13_EStopOk = aDI[11] && !aDI[60] && xSafetyOk;
    z13_GuardOk = aDI[17] || (aDI[30] && xServiceKey);
    z13_Enable = z13_EStopOk && z13_GuardOk && !z13_Jam;
    z13_EntryEdge = aDI[44] && !z13_EntryOld;
    z13_EntryOld = aDI[44];
    z13_ExitEdge = aDI[42] && !z13_ExitOld;
    z13_ExitOld = aDI[42];
    z13_Occ = (z13_EntryEdge || z13_Occ) && !z13_ExitEdge;
    z13_Jam = ((z13_EntryEdge && z13_Occ && aDI[4]) || z13_Jam) && !xResetAll;
    z13_ReqFwd = z13_Enable && !z13_Rev && (z12_Occ || z13_Occ || aDI[3]);
    z13_ReqRev = z13_Enable && !z13_Fwd && aDI[46] && xManual;
    z13_Fwd = z13_ReqFwd && !z13_ReqRev;
    z13_Rev = z13_ReqRev && !z13_ReqFwd;
    z13_Ready = z13_Enable && !z13_Occ && (xAuto || aDI[59]);
    z13_Done = z13_ExitEdge && z13_Fwd;
    z13_Alarm = z13_Jam || !z13_EStopOk || (!z13_GuardOk && z13_Fwd);
    z14_EStopOk = aDI[39] && !aDI[41] && xSafetyOk;
    z14_GuardOk = aDI[36] || (aDI[43] && xServiceKey);
    z14_Enable = z14_EStopOk && z14_GuardOk && !z14_Jam;
    z14_EntryEdge = aDI[52] && !z14_EntryOld;
    z14_EntryOld = aDI[52];
    z14_ExitEdge = aDI[28] && !z14_ExitOld;
    z14_ExitOld = aDI[28];
    z14_Occ = (z14_EntryEdge || z14_Occ) && !z14_ExitEdge;
    z14_Jam = ((z14_EntryEdge && z14_Occ && aDI[18]) || z14_Jam) && !xResetAll;
    z14_ReqFwd = z14_Enable && !z14_Rev && (z13_Occ || z14_Occ || aDI[45]);
    z14_ReqRev = z14_Enable && !z14_Fwd && aDI[24] && xManual;
    z14_Fwd = z14_ReqFwd && !z14_ReqRev;
    z14_Rev = z14_ReqRev && !z14_ReqFwd;
    z14_Ready = z14_Enable && !z14_Occ && (xAuto || aDI[42]);
    z14_Done = z14_ExitEdge && z14_Fwd;
    z14_Alarm = z14_Jam || !z14_EStopOk || (!z14_GuardOk && z14_Fwd);
    z15_EStopOk = aDI[44] && aDI[1] && xSafetyOk;
    z15_AtTop = aDI[60] && !aDI[29];
    z15_AtBottom = aDI[29] && !aDI[60];
    z15_Enable = z15_EStopOk && !z15_Jam && (aDI[22] || xServiceKey);
    z15_CallUp = (z14_Done || aDI[10] || z15_CallUp) && !z15_AtTop && z15_Enable;
    z15_CallDown = ((z15_AtTop && aDI[39]) || z15_CallDown) && !z15_AtBottom && z15_Enable && !z15_CallUp;
    z15_Fwd = z15_CallUp && !z15_CallDown && !z15_Brake;
    z15_Rev = z15_CallDown && !z15_CallUp && !z15_Brake;
    z15_Brake = !z15_Enable || (z15_AtTop && !z15_CallDown) || (z15_AtBottom && !z15_CallUp);
    z15_Jam = ((aDI[60] && aDI[29]) || (z15_Fwd && aDI[7] && aDI[31]) || z15_Jam) && !xResetAll;
    z15_Occ = (z14_Done && z15_AtBottom) || (z15_Occ && !(z15_AtTop && aDI[3]));
    z15_Done = z15_AtTop && aDI[3] && !z15_DoneOld;
    z15_DoneOld = z15_AtTop && aDI[3];
    z15_Alarm = z15_Jam || !z15_EStopOk;
    z16_EStopOk = aDI[27] && !aDI[49] && xSafetyOk;
    z16_GuardOk = aDI[18] || (aDI[8] && xServiceKey);
    z16_Enable = z16_EStopOk && z16_GuardOk && !z16_Jam;
    z16_EntryEdge = aDI[47] && !z16_EntryOld;
    z16_EntryOld = aDI[47];
    z16_ExitEdge = aDI[15] && !z16_ExitOld;
    z16_ExitOld = aDI[15];
    z16_Occ = (z16_EntryEdge || z16_Occ) && !z16_ExitEdge;
    z16_Jam = ((z16_EntryEdge && z16_Occ && aDI[25]) || z16_Jam) && !xResetAll;
    z16_ReqFwd = z16_Enable && !z16_Rev && (z15_Occ || z16_Occ || aDI[57]);
    z16_ReqRev = z16_Enable && !z16_Fwd && aDI[55] && xManual;
    z16_Fwd = z16_ReqFwd && !z16_ReqRev;
    z16_Rev = z16_ReqRev && !z16_ReqFwd;
    z16_Ready = z16_Enable && !z16_Occ && (xAuto || aDI[31]);
    z16_Done = z16_ExitEdge && z16_Fwd;
    z16_Alarm = z16_Jam || !z16_EStopOk || (!z16_GuardOk && z16_Fwd);
    z17_TwoHand = aDI[10] && aDI[63] && !z17_TieDown;
    z17_TieDown = (aDI[10] != aDI[63]) || (z17_TieDown && (aDI[10] || aDI[63]));
    z17_LightCurtain = aDI[28] || (z17_Muting && xAuto);
    z17_Muting = z17_Rev && aDI[25] && !aDI[35];
    z17_Enable = z17_LightCurtain && xSafetyOk && !z17_Jam && !aDI[17];
    z17_Start = (z17_TwoHand && xManual) || (z16_Done && xAuto);
    z17_Fwd = (z17_Start || z17_Fwd) && z17_Enable && !aDI[56];
    z17_Rev = ((aDI[56] && z17_Fwd) || z17_Rev) && z17_Enable && !aDI[8];
    z17_Pressure = z17_Fwd && (aDI[52] || z17_Pressure);
    z17_Jam = ((aDI[56] && aDI[8]) || (z17_Fwd && z17_Rev && aDI[27]) || z17_Jam) && !xResetAll;
    z17_Occ = z16_Done || (z17_Occ && !z17_Done);
    z17_Done = aDI[8] && z17_DoneOld;
    z17_DoneOld = z17_Rev && !aDI[8];
    z17_Vent = !z17_Enable || (z17_Rev && !z17_Pressure);
    z17_Alarm = z17_Jam || !z17_LightCurtain || (z17_TieDown && xManual);
    z18_EStopOk = aDI[35] && !aDI[45] && xSafetyOk;
    z18_GuardOk = aDI[26] || (aDI[22] && xServiceKey);
    z18_Enable = z18_EStopOk && z18_GuardOk && !z18_Jam;
    z18_EntryEdge = aDI[43] && !z18_EntryOld;
    z18_EntryOld = aDI[43];
    z18_ExitEdge = aDI[56] && !z18_ExitOld;
    z18_ExitOld = aDI[56];
    z18_Occ = (z18_EntryEdge || z18_Occ) && !z18_ExitEdge;
    z18_Jam = ((z18_EntryEdge && z18_Occ && aDI[24]) || z18_Jam) && !xResetAll;
    z18_ReqFwd = z18_Enable && !z18_Rev && (z17_Occ || z18_Occ || aDI[14]);
    z18_ReqRev = z18_Enable && !z18_Fwd && aDI[9] && xManual;
    z18_Fwd = z18_ReqFwd && !z18_ReqRev;
    z18_Rev = z18_ReqRev && !z18_ReqFwd;
    z18_Ready = z18_Enable && !z18_Occ && (xAuto || aDI[5]);
    z18_Done = z18_ExitEdge && z18_Fwd;
    z18_Alarm = z18_Jam || !z18_EStopOk || (!z18_GuardOk && z18_Fwd);
    z19_EStopOk = aDI[22] && !aDI[9] && xSafetyOk;
    z19_GuardOk = aDI[14] || (aDI[42] && xServiceKey);
    z19_Enable = z19_EStopOk && z19_GuardOk && !z19_Jam;
    z19_EntryEdge = aDI[61] && !z19_EntryOld;
    z19_EntryOld = aDI[61];
    z19_ExitEdge = aDI[0] && !z19_ExitOld;
    z19_ExitOld = aDI[0];
    z19_Occ = (z19_EntryEdge || z19_Occ) && !z19_ExitEdge;
    z19_Jam = ((z19_EntryEdge && z19_Occ && aDI[31]) || z19_Jam) && !xResetAll;
    z19_ReqFwd = z19_Enable && !z19_Rev && (z18_Occ || z19_Occ || aDI[53]);
    z19_ReqRev = z19_Enable && !z19_Fwd && aDI[37] && xManual;
    z19_Fwd = z19_ReqFwd && !z19_ReqRev;
    z19_Rev = z19_ReqRev && !z19_ReqFwd;
    z19_Ready = z19_Enable && !z19_Occ && (xAuto || aDI[11]);
    z19_Done = z19_ExitEdge && z19_Fwd;
    z19_Alarm = z19_Jam || !z19_EStopOk || (!z19_GuardOk && z19_Fwd);
    z20_EStopOk = aDI[33] && !aDI[18] && xSafetyOk;
    z20_GuardOk = aDI[0] || (aDI[9] && xServiceKey);
    z20_Enable = z20_EStopOk && z20_GuardOk && !z20_Jam;
    z20_EntryEdge = aDI[26] && !z20_EntryOld;
    z20_EntryOld = aDI[26];
    z20_ExitEdge = aDI[34] && !z20_ExitOld;
    z20_ExitOld = aDI[34];
    z20_Occ = (z20_EntryEdge || z20_Occ) && !z20_ExitEdge;
    z20_Jam = ((z20_EntryEdge && z20_Occ && aDI[23]) || z20_Jam) && !xResetAll;
    z20_ReqFwd = z20_Enable && !z20_Rev && (z19_Occ || z20_Occ || aDI[39]);
    z20_ReqRev = z20_Enable && !z20_Fwd && aDI[36] && xManual;
    z20_Fwd = z20_ReqFwd && !z20_ReqRev;
    z20_Rev = z20_ReqRev && !z20_ReqFwd;
    z20_Ready = z20_Enable && !z20_Occ && (xAuto || aDI[20]);
    z20_Done = z20_ExitEdge && z20_Fwd;
    z20_Alarm = z20_Jam || !z20_EStopOk || (!z20_GuardOk && z20_Fwd);
    z21_EStopOk = aDI[16] && aDI[44] && xSafetyOk;
    z21_AtTop = aDI[54] && !aDI[32];
    z21_AtBottom = aDI[32] && !aDI[54];
    z21_Enable = z21_EStopOk && !z21_Jam && (aDI[39] || xServiceKey);
    z21_CallUp = (z20_Done || aDI[41] || z21_CallUp) && !z21_AtTop && z21_Enable;
    z21_CallDown = ((z21_AtTop && aDI[43]) || z21_CallDown) && !z21_AtBottom && z21_Enable && !z21_CallUp;
    z21_Fwd = z21_CallUp && !z21_CallDown && !z21_Brake;
    z21_Rev = z21_CallDown && !z21_CallUp && !z21_Brake;
    z21_Brake = !z21_Enable || (z21_AtTop && !z21_CallDown) || (z21_AtBottom && !z21_CallUp);
    z21_Jam = ((aDI[54] && aDI[32]) || (z21_Fwd && aDI[47] && aDI[3]) || z21_Jam) && !xResetAll;
    z21_Occ = (z20_Done && z21_AtBottom) || (z21_Occ && !(z21_AtTop && aDI[29]));
    z21_Done = z21_AtTop && aDI[29] && !z21_DoneOld;
    z21_DoneOld = z21_AtTop && aDI[29];
    z21_Alarm = z21_Jam || !z21_EStopOk;
    z22_EStopOk = aDI[50] && !aDI[25] && xSafetyOk;
    z22_GuardOk = aDI[62] || (aDI[61] && xServiceKey);
    z22_Enable = z22_EStopOk && z22_GuardOk && !z22_Jam;
    z22_EntryEdge = aDI[6] && !z22_EntryOld;
    z22_EntryOld = aDI[6];
    z22_ExitEdge = aDI[30] && !z22_ExitOld;
    z22_ExitOld = aDI[30];
    z22_Occ = (z22_EntryEdge || z22_Occ) && !z22_ExitEdge;
    z22_Jam = ((z22_EntryEdge && z22_Occ && aDI[40]) || z22_Jam) && !xResetAll;
    z22_ReqFwd = z22_Enable && !z22_Rev && (z21_Occ || z22_Occ || aDI[60]);
    z22_ReqRev = z22_Enable && !z22_Fwd && aDI[3] && xManual;
    z22_Fwd = z22_ReqFwd && !z22_ReqRev;
    z22_Rev = z22_ReqRev && !z22_ReqFwd;
    z22_Ready = z22_Enable && !z22_Occ && (xAuto || aDI[12]);
    z22_Done = z22_ExitEdge && z22_Fwd;
    z22_Alarm = z22_Jam || !z22_EStopOk || (!z22_GuardOk && z22_Fwd);
    z23_TwoHand = aDI[8] && aDI[13] && !z23_TieDown;
    z23_TieDown = (aDI[8] != aDI[13]) || (z23_TieDown && (aDI[8] || aDI[13]));
    z23_LightCurtain = aDI[28] || (z23_Muting && xAuto);
    z23_Muting = z23_Rev && aDI[10] && !aDI[7];
    z23_Enable = z23_LightCurtain && xSafetyOk && !z23_Jam && !aDI[21];
    z23_Start = (z23_TwoHand && xManual) || (z22_Done && xAuto);
    z23_Fwd = (z23_Start || z23_Fwd) && z23_Enable && !aDI[38];
    z23_Rev = ((aDI[38] && z23_Fwd) || z23_Rev) && z23_Enable && !aDI[3];
    z23_Pressure = z23_Fwd && (aDI[6] || z23_Pressure);
    z23_Jam = ((aDI[38] && aDI[3]) || (z23_Fwd && z23_Rev && aDI[0]) || z23_Jam) && !xResetAll;
    z23_Occ = z22_Done || (z23_Occ && !z23_Done);
    z23_Done = aDI[3] && z23_DoneOld;
    z23_DoneOld = z23_Rev && !aDI[3];
    z23_Vent = !z23_Enable || (z23_Rev && !z23_Pressure);
    z23_Alarm = z23_Jam || !z23_LightCurtain || (z23_TieDown && xManual);
    z24_EStopOk = aDI[19] && !aDI[34] && xSafetyOk;
    z24_GuardOk = aDI[6] || (aDI[60] && xServiceKey);
    z24_Enable = z24_EStopOk && z24_GuardOk && !z24_Jam;
    z24_EntryEdge = aDI[23] && !z24_EntryOld;
    z24_EntryOld = aDI[23];
    z24_ExitEdge = aDI[39] && !z24_ExitOld;
    z24_ExitOld = aDI[39];
    z24_Occ = (z24_EntryEdge || z24_Occ) && !z24_ExitEdge;
    z24_Jam = ((z24_EntryEdge && z24_Occ && aDI[1]) || z24_Jam) && !xResetAll;
    z24_ReqFwd = z24_Enable && !z24_Rev && (z23_Occ || z24_Occ || aDI[4]);
    z24_ReqRev = z24_Enable && !z24_Fwd && aDI[55] && xManual;
    z24_Fwd = z24_ReqFwd && !z24_ReqRev;
    z24_Rev = z24_ReqRev && !z24_ReqFwd;
    z24_Ready = z24_Enable && !z24_Occ && (xAuto || aDI[13]);
    z24_Done = z24_ExitEdge && z24_Fwd;
    z24_Alarm = z24_Jam || !z24_EStopOk || (!z24_GuardOk && z24_Fwd);
    z25_EStopOk = aDI[48] && !aDI[9] && xSafetyOk;
    z25_GuardOk = aDI[40] || (aDI[16] && xServiceKey);
    z25_Enable = z25_EStopOk && z25_GuardOk && !z25_Jam;
    z25_EntryEdge = aDI[22] && !z25_EntryOld;
    z25_EntryOld = aDI[22];
    z25_ExitEdge = aDI[38] && !z25_ExitOld;
    z25_ExitOld = aDI[38];
    z25_Occ = (z25_EntryEdge || z25_Occ) && !z25_ExitEdge;
    z25_Jam = ((z25_EntryEdge && z25_Occ && aDI[23]) || z25_Jam) && !xResetAll;
    z25_ReqFwd = z25_Enable && !z25_Rev && (z24_Occ || z25_Occ || aDI[30]);
    z25_ReqRev = z25_Enable && !z25_Fwd && aDI[7] && xManual;
    z25_Fwd = z25_ReqFwd && !z25_ReqRev;
    z25_Rev = z25_ReqRev && !z25_ReqFwd;
    z25_Ready = z25_Enable && !z25_Occ && (xAuto || aDI[55]);
    z25_Done = z25_ExitEdge && z25_Fwd;
    z25_Alarm = z25_Jam || !z25_EStopOk || (!z25_GuardOk && z25_Fwd);
    z26_EStopOk = aDI[62] && !aDI[63] && xSafetyOk;
    z26_GuardOk = aDI[29] || (aDI[30] && xServiceKey);
    z26_Enable = z26_EStopOk && z26_GuardOk && !z26_Jam;
    z26_EntryEdge = aDI[60] && !z26_EntryOld;
    z26_EntryOld = aDI[60];
    z26_ExitEdge = aDI[19] && !z26_ExitOld;
    z26_ExitOld = aDI[19];
    z26_Occ = (z26_EntryEdge || z26_Occ) && !z26_ExitEdge;
    z26_Jam = ((z26_EntryEdge && z26_Occ && aDI[5]) || z26_Jam) && !xResetAll;
    z26_ReqFwd = z26_Enable && !z26_Rev && (z25_Occ || z26_Occ || aDI[9]);
    z26_ReqRev = z26_Enable && !z26_Fwd && aDI[6] && xManual;
    z26_Fwd = z26_ReqFwd && !z26_ReqRev;
    z26_Rev = z26_ReqRev && !z26_ReqFwd;
    z26_Ready = z26_Enable && !z26_Occ && (xAuto || aDI[47]);
    z26_Done = z26_ExitEdge && z26_Fwd;
    z26_Alarm = z26_Jam || !z26_EStopOk || (!z26_GuardOk && z26_Fwd);
    z27_EStopOk = aDI[43] && aDI[47] && xSafetyOk;
    z27_AtTop = aDI[16] && !aDI[30];
    z27_AtBottom = aDI[30] && !aDI[16];
    z27_Enable = z27_EStopOk && !z27_Jam && (aDI[53] || xServiceKey);
    z27_CallUp = (z26_Done || aDI[44] || z27_CallUp) && !z27_AtTop && z27_Enable;
    z27_CallDown = ((z27_AtTop && aDI[10]) || z27_CallDown) && !z27_AtBottom && z27_Enable && !z27_CallUp;
    z27_Fwd = z27_CallUp && !z27_CallDown && !z27_Brake;
    z27_Rev = z27_CallDown && !z27_CallUp && !z27_Brake;
    z27_Brake = !z27_Enable || (z27_AtTop && !z27_CallDown) || (z27_AtBottom && !z27_CallUp);
    z27_Jam = ((aDI[16] && aDI[30]) || (z27_Fwd && aDI[33] && aDI[1]) || z27_Jam) && !xResetAll;
    z27_Occ = (z26_Done && z27_AtBottom) || (z27_Occ && !(z27_AtTop && aDI[13]));
    z27_Done = z27_AtTop && aDI[13] && !z27_DoneOld;
    z27_DoneOld = z27_AtTop && aDI[13];
    z27_Alarm = z27_Jam || !z27_EStopOk;
    z28_EStopOk = aDI[46] && !aDI[9] && xSafetyOk;
    z28_GuardOk = aDI[44] || (aDI[34] && xServiceKey);
    z28_Enable = z28_EStopOk && z28_GuardOk && !z28_Jam;
    z28_EntryEdge = aDI[58] && !z28_EntryOld;
    z28_EntryOld = aDI[58];
    z28_ExitEdge = aDI[1] && !z28_ExitOld;
    z28_ExitOld = aDI[1];
    z28_Occ = (z28_EntryEdge || z28_Occ) && !z28_ExitEdge;
    z28_Jam = ((z28_EntryEdge && z28_Occ && aDI[48]) || z28_Jam) && !xResetAll;
    z28_ReqFwd = z28_Enable && !z28_Rev && (z27_Occ || z28_Occ || aDI[33]);
    z28_ReqRev = z28_Enable && !z28_Fwd && aDI[19] && xManual;
    z28_Fwd = z28_ReqFwd && !z28_ReqRev;
    z28_Rev = z28_ReqRev && !z28_ReqFwd;
    z28_Ready = z28_Enable && !z28_Occ && (xAuto || aDI[41]);
    z28_Done = z28_ExitEdge && z28_Fwd;
    z28_Alarm = z28_Jam || !z28_EStopOk || (!z28_GuardOk && z28_Fwd);
    z29_TwoHand = aDI[11] && aDI[44] && !z29_TieDown;
    z29_TieDown = (aDI[11] != aDI[44]) || (z29_TieDown && (aDI[11] || aDI[44]));
    z29_LightCurtain = aDI[54] || (z29_Muting && xAuto);
    z29_Muting = z29_Rev && aDI[16] && !aDI[33];
    z29_Enable = z29_LightCurtain && xSafetyOk && !z29_Jam && !aDI[23];
    z29_Start = (z29_TwoHand && xManual) || (z28_Done && xAuto);
    z29_Fwd = (z29_Start || z29_Fwd) && z29_Enable && !aDI[10];
    z29_Rev = ((aDI[10] && z29_Fwd) || z29_Rev) && z29_Enable && !aDI[22];
    z29_Pressure = z29_Fwd && (aDI[49] || z29_Pressure);
    z29_Jam = ((aDI[10] && aDI[22]) || (z29_Fwd && z29_Rev && aDI[14]) || z29_Jam) && !xResetAll;
    z29_Occ = z28_Done || (z29_Occ && !z29_Done);
    z29_Done = aDI[22] && z29_DoneOld;
    z29_DoneOld = z29_Rev && !aDI[22];
    z29_Vent = !z29_Enable || (z29_Rev && !z29_Pressure);
    z29_Alarm = z29_Jam || !z29_LightCurtain || (z29_TieDown && xManual);
    z30_EStopOk = aDI[42] && !aDI[40] && xSafetyOk;
    z30_GuardOk = aDI[14] || (aDI[39] && xServiceKey);
    z30_Enable = z30_EStopOk && z30_GuardOk && !z30_Jam;
    z30_EntryEdge = aDI[51] && !z30_EntryOld;
    z30_EntryOld = aDI[51];
    z30_ExitEdge = aDI[50] && !z30_ExitOld;
    z30_ExitOld = aDI[50];
    z30_Occ = (z30_EntryEdge || z30_Occ) && !z30_ExitEdge;
    z30_Jam = ((z30_EntryEdge && z30_Occ && aDI[48]) || z30_Jam) && !xResetAll;
    z30_ReqFwd = z30_Enable && !z30_Rev && (z29_Occ || z30_Occ || aDI[54]);
    z30_ReqRev = z30_Enable && !z30_Fwd && aDI[12] && xManual;
    z30_Fwd = z30_ReqFwd && !z30_ReqRev;
    z30_Rev = z30_ReqRev && !z30_ReqFwd;
    z30_Ready = z30_Enable && !z30_Occ && (xAuto || aDI[59]);
    z30_Done = z30_ExitEdge && z30_Fwd;
    z30_Alarm = z30_Jam || !z30_EStopOk || (!z30_GuardOk && z30_Fwd);
    z31_EStopOk = aDI[30] && !aDI[52] && xSafetyOk;
    z31_GuardOk = aDI[25] || (aDI[47] && xServiceKey);
    z31_Enable = z31_EStopOk && z31_GuardOk && !z31_Jam;
    z31_EntryEdge = aDI[51] && !z31_EntryOld;
    z31_EntryOld = aDI[51];
    z31_ExitEdge = aDI[14] && !z31_ExitOld;
    z31_ExitOld = aDI[14];
    z31_Occ = (z31_EntryEdge || z31_Occ) && !z31_ExitEdge;
    z31_Jam = ((z31_EntryEdge && z31_Occ && aDI[12]) || z31_Jam) && !xResetAll;
    z31_ReqFwd = z31_Enable && !z31_Rev && (z30_Occ || z31_Occ || aDI[33]);
    z31_ReqRev = z31_Enable && !z31_Fwd && aDI[31] && xManual;
    z31_Fwd = z31_ReqFwd && !z31_ReqRev;
    z31_Rev = z31_ReqRev && !z31_ReqFwd;
    z31_Ready = z31_Enable && !z31_Occ && (xAuto || aDI[22]);
    z31_Done = z31_ExitEdge && z31_Fwd;
    z31_Alarm = z31_Jam || !z31_EStopOk || (!z31_GuardOk && z31_Fwd);
    z32_EStopOk = aDI[3] && !aDI[1] && xSafetyOk;
    z32_GuardOk = aDI[50] || (aDI[17] && xServiceKey);
    z32_Enable = z32_EStopOk && z32_GuardOk && !z32_Jam;
    z32_EntryEdge = aDI[30] && !z32_EntryOld;
    z32_EntryOld = aDI[30];
    z32_ExitEdge = aDI[16] && !z32_ExitOld;
    z32_ExitOld = aDI[16];
    z32_Occ = (z32_EntryEdge || z32_Occ) && !z32_ExitEdge;
    z32_Jam = ((z32_EntryEdge && z32_Occ && aDI[12]) || z32_Jam) && !xResetAll;
    z32_ReqFwd = z32_Enable && !z32_Rev && (z31_Occ || z32_Occ || aDI[44]);
    z32_ReqRev = z32_Enable && !z32_Fwd && aDI[38] && xManual;
    z32_Fwd = z32_ReqFwd && !z32_ReqRev;
    z32_Rev = z32_ReqRev && !z32_ReqFwd;
    z32_Ready = z32_Enable && !z32_Occ && (xAuto || aDI[22]);
    z32_Done = z32_ExitEdge && z32_Fwd;
    z32_Alarm = z32_Jam || !z32_EStopOk || (!z32_GuardOk && z32_Fwd);
    z33_EStopOk = aDI[57] && aDI[51] && xSafetyOk;
    z33_AtTop = aDI[59] && !aDI[46];
    z33_AtBottom = aDI[46] && !aDI[59];
    z33_Enable = z33_EStopOk && !z33_Jam && (aDI[22] || xServiceKey);
    z33_CallUp = (z32_Done || aDI[23] || z33_CallUp) && !z33_AtTop && z33_Enable;
    z33_CallDown = ((z33_AtTop && aDI[5]) || z33_CallDown) && !z33_AtBottom && z33_Enable && !z33_CallUp;
    z33_Fwd = z33_CallUp && !z33_CallDown && !z33_Brake;
    z33_Rev = z33_CallDown && !z33_CallUp && !z33_Brake;
    z33_Brake = !z33_Enable || (z33_AtTop && !z33_CallDown) || (z33_AtBottom && !z33_CallUp);
    z33_Jam = ((aDI[59] && aDI[46]) || (z33_Fwd && aDI[14] && aDI[6]) || z33_Jam) && !xResetAll;
    z33_Occ = (z32_Done && z33_AtBottom) || (z33_Occ && !(z33_AtTop && aDI[56]));
    z33_Done = z33_AtTop && aDI[56] && !z33_DoneOld;
    z33_DoneOld = z33_AtTop && aDI[56];
    z33_Alarm = z33_Jam || !z33_EStopOk;
    z34_EStopOk = aDI[60] && !aDI[12] && xSafetyOk;
    z34_GuardOk = aDI[21] || (aDI[13] && xServiceKey);
    z34_Enable = z34_EStopOk && z34_GuardOk && !z34_Jam;
    z34_EntryEdge = aDI[30] && !z34_EntryOld;
    z34_EntryOld = aDI[30];
    z34_ExitEdge = aDI[39] && !z34_ExitOld;
    z34_ExitOld = aDI[39];
    z34_Occ = (z34_EntryEdge || z34_Occ) && !z34_ExitEdge;
    z34_Jam = ((z34_EntryEdge && z34_Occ && aDI[57]) || z34_Jam) && !xResetAll;
    z34_ReqFwd = z34_Enable && !z34_Rev && (z33_Occ || z34_Occ || aDI[58]);
    z34_ReqRev = z34_Enable && !z34_Fwd && aDI[53] && xManual;
    z34_Fwd = z34_ReqFwd && !z34_ReqRev;
    z34_Rev = z34_ReqRev && !z34_ReqFwd;
    z34_Ready = z34_Enable && !z34_Occ && (xAuto || aDI[0]);
    z34_Done = z34_ExitEdge && z34_Fwd;
    z34_Alarm = z34_Jam || !z34_EStopOk || (!z34_GuardOk && z34_Fwd);
    z35_TwoHand = aDI[61] && aDI[58] && !z35_TieDown;
    z35_TieDown = (aDI[61] != aDI[58]) || (z35_TieDown && (aDI[61] || aDI[58]));
    z35_LightCurtain = aDI[41] || (z35_Muting && xAuto);
    z35_Muting = z35_Rev && aDI[22] && !aDI[51];
    z35_Enable = z35_LightCurtain && xSafetyOk && !z35_Jam && !aDI[63];
    z35_Start = (z35_TwoHand && xManual) || (z34_Done && xAuto);
    z35_Fwd = (z35_Start || z35_Fwd) && z35_Enable && !aDI[5];
    z35_Rev = ((aDI[5] && z35_Fwd) || z35_Rev) && z35_Enable && !aDI[53];
    z35_Pressure = z35_Fwd && (aDI[42] || z35_Pressure);
    z35_Jam = ((aDI[5] && aDI[53]) || (z35_Fwd && z35_Rev && aDI[7]) || z35_Jam) && !xResetAll;
    z35_Occ = z34_Done || (z35_Occ && !z35_Done);
    z35_Done = aDI[53] && z35_DoneOld;
    z35_DoneOld = z35_Rev && !aDI[53];
    z35_Vent = !z35_Enable || (z35_Rev && !z35_Pressure);
    z35_Alarm = z35_Jam || !z35_LightCurtain || (z35_TieDown && xManual);
    z36_EStopOk = aDI[49] && !aDI[50] && xSafetyOk;
    z36_GuardOk = aDI[45] || (aDI[48] && xServiceKey);
    z36_Enable = z36_EStopOk && z36_GuardOk && !z36_Jam;
    z36_EntryEdge = aDI[12] && !z36_EntryOld;
    z36_EntryOld = aDI[12];
    z36_ExitEdge = aDI[30] && !z36_ExitOld;
    z36_ExitOld = aDI[30];
    z36_Occ = (z36_EntryEdge || z36_Occ) && !z36_ExitEdge;
    z36_Jam = ((z36_EntryEdge && z36_Occ && aDI[56]) || z36_Jam) && !xResetAll;
    z36_ReqFwd = z36_Enable && !z36_Rev && (z35_Occ || z36_Occ || aDI[11]);
    z36_ReqRev = z36_Enable && !z36_Fwd && aDI[27] && xManual;
    z36_Fwd = z36_ReqFwd && !z36_ReqRev;
    z36_Rev = z36_ReqRev && !z36_ReqFwd;
    z36_Ready = z36_Enable && !z36_Occ && (xAuto || aDI[62]);
    z36_Done = z36_ExitEdge && z36_Fwd;
    z36_Alarm = z36_Jam || !z36_EStopOk || (!z36_GuardOk && z36_Fwd);
    z37_EStopOk = aDI[42] && !aDI[5] && xSafetyOk;
    z37_GuardOk = aDI[51] || (aDI[60] && xServiceKey);
    z37_Enable = z37_EStopOk && z37_GuardOk && !z37_Jam;
    z37_EntryEdge = aDI[46] && !z37_EntryOld;
    z37_EntryOld = aDI[46];
    z37_ExitEdge = aDI[25] && !z37_ExitOld;
    z37_ExitOld = aDI[25];
    z37_Occ = (z37_EntryEdge || z37_Occ) && !z37_ExitEdge;
    z37_Jam = ((z37_EntryEdge && z37_Occ && aDI[29]) || z37_Jam) && !xResetAll;
    z37_ReqFwd = z37_Enable && !z37_Rev && (z36_Occ || z37_Occ || aDI[58]);
    z37_ReqRev = z37_Enable && !z37_Fwd && aDI[47] && xManual;
    z37_Fwd = z37_ReqFwd && !z37_ReqRev;
    z37_Rev = z37_ReqRev && !z37_ReqFwd;
    z37_Ready = z37_Enable && !z37_Occ && (xAuto || aDI[62]);
    z37_Done = z37_ExitEdge && z37_Fwd;
    z37_Alarm = z37_Jam || !z37_EStopOk || (!z37_GuardOk && z37_Fwd);
    z38_EStopOk = aDI[20] && !aDI[10] && xSafetyOk;
    z38_GuardOk = aDI[8] || (aDI[1] && xServiceKey);
    z38_Enable = z38_EStopOk && z38_GuardOk && !z38_Jam;
    z38_EntryEdge = aDI[9] && !z38_EntryOld;
    z38_EntryOld = aDI[9];
    z38_ExitEdge = aDI[37] && !z38_ExitOld;
    z38_ExitOld = aDI[37];
    z38_Occ = (z38_EntryEdge || z38_Occ) && !z38_ExitEdge;
    z38_Jam = ((z38_EntryEdge && z38_Occ && aDI[57]) || z38_Jam) && !xResetAll;
    z38_ReqFwd = z38_Enable && !z38_Rev && (z37_Occ || z38_Occ || aDI[29]);
    z38_ReqRev = z38_Enable && !z38_Fwd && aDI[51] && xManual;
    z38_Fwd = z38_ReqFwd && !z38_ReqRev;
    z38_Rev = z38_ReqRev && !z38_ReqFwd;
    z38_Ready = z38_Enable && !z38_Occ && (xAuto || aDI[41]);
    z38_Done = z38_ExitEdge && z38_Fwd;
    z38_Alarm = z38_Jam || !z38_EStopOk || (!z38_GuardOk && z38_Fwd);
    z39_EStopOk = aDI[18] && aDI[39] && xSafetyOk;
    z39_AtTop = aDI[52] && !aDI[38];
    z39_AtBottom = aDI[38] && !aDI[52];
    z39_Enable = z39_EStopOk && !z39_Jam && (aDI[30] || xServiceKey);
    z39_CallUp = (z38_Done || aDI[42] || z39_CallUp) && !z39_AtTop && z39_Enable;
    z39_CallDown = ((z39_AtTop && aDI[22]) || z39_CallDown) && !z39_AtBottom && z39_Enable && !z39_CallUp;
    z39_Fwd = z39_CallUp && !z39_CallDown && !z39_Brake;
    z39_Rev = z39_CallDown && !z39_CallUp && !z39_Brake;
    z39_Brake = !z39_Enable || (z39_AtTop && !z39_CallDown) || (z39_AtBottom && !z39_CallUp);
    z39_Jam = ((aDI[52] && aDI[38]) || (z39_Fwd && aDI[9] && aDI[35]) || z39_Jam) && !xResetAll;
    z39_Occ = (z38_Done && z39_AtBottom) || (z39_Occ && !(z39_AtTop && aDI[55]));
    z39_Done = z39_AtTop && aDI[55] && !z39_DoneOld;
    z39_DoneOld = z39_AtTop && aDI[55];
    z39_Alarm = z39_Jam || !z39_EStopOk;
    z40_EStopOk = aDI[16] && !aDI[1] && xSafetyOk;
    z40_GuardOk = aDI[0] || (aDI[51] && xServiceKey);
    z40_Enable = z40_EStopOk && z40_GuardOk && !z40_Jam;
    z40_EntryEdge = aDI[46] && !z40_EntryOld;
    z40_EntryOld = aDI[46];
    z40_ExitEdge = aDI[41] && !z40_ExitOld;
    z40_ExitOld = aDI[41];
    z40_Occ = (z40_EntryEdge || z40_Occ) && !z40_ExitEdge;
    z40_Jam = ((z40_EntryEdge && z40_Occ && aDI[6]) || z40_Jam) && !xResetAll;
    z40_ReqFwd = z40_Enable && !z40_Rev && (z39_Occ || z40_Occ || aDI[33]);
    z40_ReqRev = z40_Enable && !z40_Fwd && aDI[47] && xManual;
    z40_Fwd = z40_ReqFwd && !z40_ReqRev;
    z40_Rev = z40_ReqRev && !z40_ReqFwd;
    z40_Ready = z40_Enable && !z40_Occ && (xAuto || aDI[8]);
    z40_Done = z40_ExitEdge && z40_Fwd;
    z40_Alarm = z40_Jam || !z40_EStopOk || (!z40_GuardOk && z40_Fwd);
    z41_TwoHand = aDI[55] && aDI[63] && !z41_TieDown;
    z41_TieDown = (aDI[55] != aDI[63]) || (z41_TieDown && (aDI[55] || aDI[63]));
    z41_LightCurtain = aDI[12] || (z41_Muting && xAuto);
    z41_Muting = z41_Rev && aDI[52] && !aDI[62];
    z41_Enable = z41_LightCurtain && xSafetyOk && !z41_Jam && !aDI[13];
    z41_Start = (z41_TwoHand && xManual) || (z40_Done && xAuto);
    z41_Fwd = (z41_Start || z41_Fwd) && z41_Enable && !aDI[1];
    z41_Rev = ((aDI[1] && z41_Fwd) || z41_Rev) && z41_Enable && !aDI[16];
    z41_Pressure = z41_Fwd && (aDI[58] || z41_Pressure);
    z41_Jam = ((aDI[1] && aDI[16]) || (z41_Fwd && z41_Rev && aDI[18]) || z41_Jam) && !xResetAll;
    z41_Occ = z40_Done || (z41_Occ && !z41_Done);
    z41_Done = aDI[16] && z41_DoneOld;
    z41_DoneOld = z41_Rev && !aDI[16];
    z41_Vent = !z41_Enable || (z41_Rev && !z41_Pressure);
    z41_Alarm = z41_Jam || !z41_LightCurtain || (z41_TieDown && xManual);
    z42_EStopOk = aDI[30] && !aDI[48] && xSafetyOk;
    z42_GuardOk = aDI[37] || (aDI[20] && xServiceKey);
    z42_Enable = z42_EStopOk && z42_GuardOk && !z42_Jam;
    z42_EntryEdge = aDI[16] && !z42_EntryOld;
    z42_EntryOld = aDI[16];
    z42_ExitEdge = aDI[34] && !z42_ExitOld;
    z42_ExitOld = aDI[34];
    z42_Occ = (z42_EntryEdge || z42_Occ) && !z42_ExitEdge;
    z42_Jam = ((z42_EntryEdge && z42_Occ && aDI[26]) || z42_Jam) && !xResetAll;
    z42_ReqFwd = z42_Enable && !z42_Rev && (z41_Occ || z42_Occ || aDI[53]);
    z42_ReqRev = z42_Enable && !z42_Fwd && aDI[8] && xManual;
    z42_Fwd = z42_ReqFwd && !z42_ReqRev;
    z42_Rev = z42_ReqRev && !z42_ReqFwd;
    z42_Ready = z42_Enable && !z42_Occ && (xAuto || aDI[3]);
    z42_Done = z42_ExitEdge && z42_Fwd;
    z42_Alarm = z42_Jam || !z42_EStopOk || (!z42_GuardOk && z42_Fwd);
    z43_EStopOk = aDI[45] && !aDI[57] && xSafetyOk;
    z43_GuardOk = aDI[29] || (aDI[42] && xServiceKey);
    z43_Enable = z43_EStopOk && z43_GuardOk && !z43_Jam;
    z43_EntryEdge = aDI[37] && !z43_EntryOld;
    z43_EntryOld = aDI[37];
    z43_ExitEdge = aDI[52] && !z43_ExitOld;
    z43_ExitOld = aDI[52];
    z43_Occ = (z43_EntryEdge || z43_Occ) && !z43_ExitEdge;
    z43_Jam = ((z43_EntryEdge && z43_Occ && aDI[62]) || z43_Jam) && !xResetAll;
    z43_ReqFwd = z43_Enable && !z43_Rev && (z42_Occ || z43_Occ || aDI[33]);
    z43_ReqRev = z43_Enable && !z43_Fwd && aDI[26] && xManual;
    z43_Fwd = z43_ReqFwd && !z43_ReqRev;
    z43_Rev = z43_ReqRev && !z43_ReqFwd;
    z43_Ready = z43_Enable && !z43_Occ && (xAuto || aDI[58]);
    z43_Done = z43_ExitEdge && z43_Fwd;
    z43_Alarm = z43_Jam || !z43_EStopOk || (!z43_GuardOk && z43_Fwd);
    z44_EStopOk = aDI[16] && !aDI[34] && xSafetyOk;
    z44_GuardOk = aDI[9] || (aDI[33] && xServiceKey);
    z44_Enable = z44_EStopOk && z44_GuardOk && !z44_Jam;
    z44_EntryEdge = aDI[32] && !z44_EntryOld;
    z44_EntryOld = aDI[32];
    z44_ExitEdge = aDI[1] && !z44_ExitOld;
    z44_ExitOld = aDI[1];
    z44_Occ = (z44_EntryEdge || z44_Occ) && !z44_ExitEdge;
    z44_Jam = ((z44_EntryEdge && z44_Occ && aDI[55]) || z44_Jam) && !xResetAll;
    z44_ReqFwd = z44_Enable && !z44_Rev && (z43_Occ || z44_Occ || aDI[28]);
    z44_ReqRev = z44_Enable && !z44_Fwd && aDI[49] && xManual;
    z44_Fwd = z44_ReqFwd && !z44_ReqRev;
    z44_Rev = z44_ReqRev && !z44_ReqFwd;
    z44_Ready = z44_Enable && !z44_Occ && (xAuto || aDI[11]);
    z44_Done = z44_ExitEdge && z44_Fwd;
    z44_Alarm = z44_Jam || !z44_EStopOk || (!z44_GuardOk && z44_Fwd);
    z45_EStopOk = aDI[0] && aDI[49] && xSafetyOk;
    z45_AtTop = aDI[51] && !aDI[9];
    z45_AtBottom = aDI[9] && !aDI[51];
    z45_Enable = z45_EStopOk && !z45_Jam && (aDI[11] || xServiceKey);
    z45_CallUp = (z44_Done || aDI[60] || z45_CallUp) && !z45_AtTop && z45_Enable;
    z45_CallDown = ((z45_AtTop && aDI[30]) || z45_CallDown) && !z45_AtBottom && z45_Enable && !z45_CallUp;
    z45_Fwd = z45_CallUp && !z45_CallDown && !z45_Brake;
    z45_Rev = z45_CallDown && !z45_CallUp && !z45_Brake;
    z45_Brake = !z45_Enable || (z45_AtTop && !z45_CallDown) || (z45_AtBottom && !z45_CallUp);
    z45_Jam = ((aDI[51] && aDI[9]) || (z45_Fwd && aDI[39] && aDI[46]) || z45_Jam) && !xResetAll;
    z45_Occ = (z44_Done && z45_AtBottom) || (z45_Occ && !(z45_AtTop && aDI[7]));
    z45_Done = z45_AtTop && aDI[7] && !z45_DoneOld;
    z45_DoneOld = z45_AtTop && aDI[7];
    z45_Alarm = z45_Jam || !z45_EStopOk;
    z46_EStopOk = aDI[7] && !aDI[20] && xSafetyOk;
    z46_GuardOk = aDI[43] || (aDI[33] && xServiceKey);
    z46_Enable = z46_EStopOk && z46_GuardOk && !z46_Jam;
    z46_EntryEdge = aDI[60] && !z46_EntryOld;
    z46_EntryOld = aDI[60];
    z46_ExitEdge = aDI[35] && !z46_ExitOld;
    z46_ExitOld = aDI[35];
    z46_Occ = (z46_EntryEdge || z46_Occ) && !z46_ExitEdge;
    z46_Jam = ((z46_EntryEdge && z46_Occ && aDI[30]) || z46_Jam) && !xResetAll;
    z46_ReqFwd = z46_Enable && !z46_Rev && (z45_Occ || z46_Occ || aDI[50]);
    z46_ReqRev = z46_Enable && !z46_Fwd && aDI[49] && xManual;
    z46_Fwd = z46_ReqFwd && !z46_ReqRev;
    z46_Rev = z46_ReqRev && !z46_ReqFwd;
    z46_Ready = z46_Enable && !z46_Occ && (xAuto || aDI[6]);
    z46_Done = z46_ExitEdge && z46_Fwd;
    z46_Alarm = z46_Jam || !z46_EStopOk || (!z46_GuardOk && z46_Fwd);
    z47_TwoHand = aDI[7] && aDI[15] && !z47_TieDown;
    z47_TieDown = (aDI[7] != aDI[15]) || (z47_TieDown && (aDI[7] || aDI[15]));
    z47_LightCurtain = aDI[12] || (z47_Muting && xAuto);
    z47_Muting = z47_Rev && aDI[17] && !aDI[2];
    z47_Enable = z47_LightCurtain && xSafetyOk && !z47_Jam && !aDI[49];
    z47_Start = (z47_TwoHand && xManual) || (z46_Done && xAuto);
    z47_Fwd = (z47_Start || z47_Fwd) && z47_Enable && !aDI[6];
    z47_Rev = ((aDI[6] && z47_Fwd) || z47_Rev) && z47_Enable && !aDI[32];
    z47_Pressure = z47_Fwd && (aDI[28] || z47_Pressure);
    z47_Jam = ((aDI[6] && aDI[32]) || (z47_Fwd && z47_Rev && aDI[35]) || z47_Jam) && !xResetAll;
    z47_Occ = z46_Done || (z47_Occ && !z47_Done);
    z47_Done = aDI[32] && z47_DoneOld;
    z47_DoneOld = z47_Rev && !aDI[32];
    z47_Vent = !z47_Enable || (z47_Rev && !z47_Pressure);
    z47_Alarm = z47_Jam || !z47_LightCurtain || (z47_TieDown && xManual);
    z48_EStopOk = aDI[3] && !aDI[48] && xSafetyOk;
    z48_GuardOk = aDI[57] || (aDI[58] && xServiceKey);
    z48_Enable = z48_EStopOk && z48_GuardOk && !z48_Jam;
    z48_EntryEdge = aDI[4] && !z48_EntryOld;
    z48_EntryOld = aDI[4];
    z48_ExitEdge = aDI[28] && !z48_ExitOld;
    z48_ExitOld = aDI[28];
    z48_Occ = (z48_EntryEdge || z48_Occ) && !z48_ExitEdge;
    z48_Jam = ((z48_EntryEdge && z48_Occ && aDI[20]) || z48_Jam) && !xResetAll;
    z48_ReqFwd = z48_Enable && !z48_Rev && (z47_Occ || z48_Occ || aDI[39]);
    z48_ReqRev = z48_Enable && !z48_Fwd && aDI[32] && xManual;
    z48_Fwd = z48_ReqFwd && !z48_ReqRev;
    z48_Rev = z48_ReqRev && !z48_ReqFwd;
    z48_Ready = z48_Enable && !z48_Occ && (xAuto || aDI[38]);
    z48_Done = z48_ExitEdge && z48_Fwd;
    z48_Alarm = z48_Jam || !z48_EStopOk || (!z48_GuardOk && z48_Fwd);
    starter(&fbInfeedA, aDI[25],
        aDI[35] && aDI[57],
        xAuto,
        z01_Fwd || z01_Rev,
        z01_Enable && !z01_Alarm,
        fbInfeedA.xCmd && !aDI[61],
        aDI[31] && aDI[25] && aDI[57],
        xResetAll,
        xTick);
    starter(&fbAccumA, aDI[33],
        aDI[25] && aDI[57],
        xAuto,
        z02_Fwd || z02_Rev,
        z02_Enable && !z02_Alarm,
        fbAccumA.xCmd && !aDI[17],
        aDI[53] && aDI[33] && aDI[57],
        xResetAll,
        xTick);
    starter(&fbMergeA, aDI[15],
        aDI[50] && aDI[56],
        xAuto,
        z03_Fwd || z03_Rev,
        z03_Enable && !z03_Alarm,
        fbMergeA.xCmd && !aDI[40],
        aDI[9] && aDI[15] && aDI[56],
        xResetAll,
        xTick);
    starter(&fbLiftUpA, aDI[30],
        aDI[54] && aDI[9],
        xAuto,
        z04_Fwd || z04_Rev,
        z04_Enable && !z04_Alarm,
        fbLiftUpA.xCmd && !aDI[27],
        aDI[38] && aDI[30] && aDI[9],
        xResetAll,
        xTick);
    starter(&fbLiftDownA, aDI[15],
        aDI[19] && aDI[46],
        xAuto,
        z05_Fwd || z05_Rev,
        z05_Enable && !z05_Alarm,
        fbLiftDownA.xCmd && !aDI[18],
        aDI[32] && aDI[15] && aDI[46],
        xResetAll,
        xTick);
    starter(&fbPressA, aDI[17],
        aDI[59] && aDI[28],
        xAuto,
        z06_Fwd || z06_Rev,
        z06_Enable && !z06_Alarm,
        fbPressA.xCmd && !aDI[12],
        aDI[50] && aDI[17] && aDI[28],
        xResetAll,
        xTick);
    starter(&fbPressPumpA, aDI[62],
        aDI[20] && aDI[28],
        xAuto,
        z07_Fwd || z07_Rev,
        z07_Enable && !z07_Alarm,
        fbPressPumpA.xCmd && !aDI[55],
        aDI[51] && aDI[62] && aDI[28],
        xResetAll,
        xTick);
    starter(&fbWrapA, aDI[43],
        aDI[53] && aDI[25],
        xAuto,
        z08_Fwd || z08_Rev,
        z08_Enable && !z08_Alarm,
        fbWrapA.xCmd && !aDI[45],
        aDI[40] && aDI[43] && aDI[25],
        xResetAll,
        xTick);
    starter(&fbWrapTurnA, aDI[11],
        aDI[46] && aDI[2],
        xAuto,
        z09_Fwd || z09_Rev,
        z09_Enable && !z09_Alarm,
        fbWrapTurnA.xCmd && !aDI[43],
        aDI[58] && aDI[11] && aDI[2],
        xResetAll,
        xTick);
    starter(&fbLabelA, aDI[56],
        aDI[2] && aDI[49],
        xAuto,
        z10_Fwd || z10_Rev,
        z10_Enable && !z10_Alarm,
        fbLabelA.xCmd && !aDI[42],
        aDI[37] && aDI[56] && aDI[49],
        xResetAll,
        xTick);
    starter(&fbRejectA, aDI[8],
        aDI[14] && aDI[29],
        xAuto,
        z11_Fwd || z11_Rev,
        z11_Enable && !z11_Alarm,
        fbRejectA.xCmd && !aDI[13],
        aDI[10] && aDI[8] && aDI[29],
        xResetAll,
        xTick);
    starter(&fbOutfeedA, aDI[33],
        aDI[34] && aDI[5],
        xAuto,
        z12_Fwd || z12_Rev,
        z12_Enable && !z12_Alarm,
        fbOutfeedA.xCmd && !aDI[23],
        aDI[16] && aDI[33] && aDI[5],
        xResetAll,
        xTick);
    starter(&fbDustA, aDI[54],
        aDI[33] && aDI[51],
        xAuto,
        z13_Fwd || z13_Rev,
        z13_Enable && !z13_Alarm,
        fbDustA.xCmd && !aDI[19],
        aDI[63] && aDI[54] && aDI[51],
        xResetAll,
        xTick);
    starter(&fbCoolA, aDI[41],
        aDI[11] && aDI[35],
        xAuto,
        z14_Fwd || z14_Rev,
        z14_Enable && !z14_Alarm,
        fbCoolA.xCmd && !aDI[7],
        aDI[23] && aDI[41] && aDI[35],
        xResetAll,
        xTick);
    starter(&fbLubeA, aDI[54],
        aDI[9] && aDI[34],
        xAuto,
        z15_Fwd || z15_Rev,
        z15_Enable && !z15_Alarm,
        fbLubeA.xCmd && !aDI[2],
        aDI[11] && aDI[54] && aDI[34],
        xResetAll,
        xTick);
    starter(&fbVacuumA, aDI[33],
        aDI[10] && aDI[28],
        xAuto,
        z16_Fwd || z16_Rev,
        z16_Enable && !z16_Alarm,
        fbVacuumA.xCmd && !aDI[8],
        aDI[15] && aDI[33] && aDI[28],
        xResetAll,
        xTick);
    starter(&fbInfeedB, aDI[58],
        aDI[1] && aDI[43],
        xAuto,
        z17_Fwd || z17_Rev,
        z17_Enable && !z17_Alarm,
        fbInfeedB.xCmd && !aDI[53],
        aDI[34] && aDI[58] && aDI[43],
        xResetAll,
        xTick);
    starter(&fbAccumB, aDI[16],
        aDI[5] && aDI[30],
        xAuto,
        z18_Fwd || z18_Rev,
        z18_Enable && !z18_Alarm,
        fbAccumB.xCmd && !aDI[14],
        aDI[20] && aDI[16] && aDI[30],
        xResetAll,
        xTick);
    starter(&fbMergeB, aDI[33],
        aDI[6] && aDI[23],
        xAuto,
        z19_Fwd || z19_Rev,
        z19_Enable && !z19_Alarm,
        fbMergeB.xCmd && !aDI[25],
        aDI[39] && aDI[33] && aDI[23],
        xResetAll,
        xTick);
    starter(&fbLiftUpB, aDI[39],
        aDI[26] && aDI[37],
        xAuto,
        z20_Fwd || z20_Rev,
        z20_Enable && !z20_Alarm,
        fbLiftUpB.xCmd && !aDI[57],
        aDI[22] && aDI[39] && aDI[37],
        xResetAll,
        xTick);
    starter(&fbLiftDownB, aDI[34],
        aDI[44] && aDI[2],
        xAuto,
        z21_Fwd || z21_Rev,
        z21_Enable && !z21_Alarm,
        fbLiftDownB.xCmd && !aDI[32],
        aDI[4] && aDI[34] && aDI[2],
        xResetAll,
        xTick);
    starter(&fbPressB, aDI[1],
        aDI[2] && aDI[24],
        xAuto,
        z22_Fwd || z22_Rev,
        z22_Enable && !z22_Alarm,
        fbPressB.xCmd && !aDI[60],
        aDI[31] && aDI[1] && aDI[24],
        xResetAll,
        xTick);
    starter(&fbPressPumpB, aDI[57],
        aDI[13] && aDI[55],
        xAuto,
        z23_Fwd || z23_Rev,
        z23_Enable && !z23_Alarm,
        fbPressPumpB.xCmd && !aDI[63],
        aDI[50] && aDI[57] && aDI[55],
        xResetAll,
        xTick);
    starter(&fbWrapB, aDI[39],
        aDI[27] && aDI[29],
        xAuto,
        z24_Fwd || z24_Rev,
        z24_Enable && !z24_Alarm,
        fbWrapB.xCmd && !aDI[43],
        aDI[25] && aDI[39] && aDI[29],
        xResetAll,
        xTick);
    starter(&fbWrapTurnB, aDI[17],
        aDI[51] && aDI[44],
        xAuto,
        z25_Fwd || z25_Rev,
        z25_Enable && !z25_Alarm,
        fbWrapTurnB.xCmd && !aDI[6],
        aDI[16] && aDI[17] && aDI[44],
        xResetAll,
        xTick);
    starter(&fbLabelB, aDI[1],
        aDI[9] && aDI[32],
        xAuto,
        z26_Fwd || z26_Rev,
        z26_Enable && !z26_Alarm,
        fbLabelB.xCmd && !aDI[55],
        aDI[20] && aDI[1] && aDI[32],
        xResetAll,
        xTick);
    starter(&fbRejectB, aDI[7],
        aDI[10] && aDI[48],
        xAuto,
        z27_Fwd || z27_Rev,
        z27_Enable && !z27_Alarm,
        fbRejectB.xCmd && !aDI[36],
        aDI[31] && aDI[7] && aDI[48],
        xResetAll,
        xTick);
    starter(&fbOutfeedB, aDI[37],
        aDI[5] && aDI[58],
        xAuto,
        z28_Fwd || z28_Rev,
        z28_Enable && !z28_Alarm,
        fbOutfeedB.xCmd && !aDI[23],
        aDI[20] && aDI[37] && aDI[58],
        xResetAll,
        xTick);
    starter(&fbDustB, aDI[34],
        aDI[57] && aDI[0],
        xAuto,
        z29_Fwd || z29_Rev,
        z29_Enable && !z29_Alarm,
        fbDustB.xCmd && !aDI[33],
        aDI[46] && aDI[34] && aDI[0],
        xResetAll,
        xTick);
    starter(&fbCoolB, aDI[42],
        aDI[41] && aDI[31],
        xAuto,
        z30_Fwd || z30_Rev,
        z30_Enable && !z30_Alarm,
        fbCoolB.xCmd && !aDI[4],
        aDI[39] && aDI[42] && aDI[31],
        xResetAll,
        xTick);
    starter(&fbLubeB, aDI[27],
        aDI[45] && aDI[23],
        xAuto,
        z31_Fwd || z31_Rev,
        z31_Enable && !z31_Alarm,
        fbLubeB.xCmd && !aDI[0],
        aDI[42] && aDI[27] && aDI[23],
        xResetAll,
        xTick);
    starter(&fbVacuumB, aDI[48],
        aDI[10] && aDI[60],
        xAuto,
        z32_Fwd || z32_Rev,
        z32_Enable && !z32_Alarm,
        fbVacuumB.xCmd && !aDI[35],
        aDI[25] && aDI[48] && aDI[60],
        xResetAll,
        xTick);
    starter(&fbInfeedC, aDI[31],
        aDI[0] && aDI[11],
        xAuto,
        z33_Fwd || z33_Rev,
        z33_Enable && !z33_Alarm,
        fbInfeedC.xCmd && !aDI[33],
        aDI[18] && aDI[31] && aDI[11],
        xResetAll,
        xTick);
    starter(&fbAccumC, aDI[51],
        aDI[5] && aDI[50],
        xAuto,
        z34_Fwd || z34_Rev,
        z34_Enable && !z34_Alarm,
        fbAccumC.xCmd && !aDI[2],
        aDI[38] && aDI[51] && aDI[50],
        xResetAll,
        xTick);
    starter(&fbMergeC, aDI[38],
        aDI[29] && aDI[10],
        xAuto,
        z35_Fwd || z35_Rev,
        z35_Enable && !z35_Alarm,
        fbMergeC.xCmd && !aDI[19],
        aDI[49] && aDI[38] && aDI[10],
        xResetAll,
        xTick);
    starter(&fbLiftUpC, aDI[41],
        aDI[63] && aDI[19],
        xAuto,
        z36_Fwd || z36_Rev,
        z36_Enable && !z36_Alarm,
        fbLiftUpC.xCmd && !aDI[36],
        aDI[18] && aDI[41] && aDI[19],
        xResetAll,
        xTick);
    starter(&fbLiftDownC, aDI[5],
        aDI[54] && aDI[17],
        xAuto,
        z37_Fwd || z37_Rev,
        z37_Enable && !z37_Alarm,
        fbLiftDownC.xCmd && !aDI[2],
        aDI[29] && aDI[5] && aDI[17],
        xResetAll,
        xTick);
    starter(&fbPressC, aDI[10],
        aDI[3] && aDI[5],
        xAuto,
        z38_Fwd || z38_Rev,
        z38_Enable && !z38_Alarm,
        fbPressC.xCmd && !aDI[17],
        aDI[46] && aDI[10] && aDI[5],
        xResetAll,
        xTick);
    starter(&fbPressPumpC, aDI[13],
        aDI[48] && aDI[57],
        xAuto,
        z39_Fwd || z39_Rev,
        z39_Enable && !z39_Alarm,
        fbPressPumpC.xCmd && !aDI[6],
        aDI[2] && aDI[13] && aDI[57],
        xResetAll,
        xTick);
    starter(&fbWrapC, aDI[31],
        aDI[62] && aDI[33],
        xAuto,
        z40_Fwd || z40_Rev,
        z40_Enable && !z40_Alarm,
        fbWrapC.xCmd && !aDI[0],
        aDI[58] && aDI[31] && aDI[33],
        xResetAll,
        xTick);
    starter(&fbWrapTurnC, aDI[8],
        aDI[11] && aDI[60],
        xAuto,
        z41_Fwd || z41_Rev,
        z41_Enable && !z41_Alarm,
        fbWrapTurnC.xCmd && !aDI[32],
        aDI[9] && aDI[8] && aDI[60],
        xResetAll,
        xTick);
    starter(&fbLabelC, aDI[33],
        aDI[30] && aDI[26],
        xAuto,
        z42_Fwd || z42_Rev,
        z42_Enable && !z42_Alarm,
        fbLabelC.xCmd && !aDI[29],
        aDI[58] && aDI[33] && aDI[26],
        xResetAll,
        xTick);
    starter(&fbRejectC, aDI[63],
        aDI[48] && aDI[9],
        xAuto,
        z43_Fwd || z43_Rev,
        z43_Enable && !z43_Alarm,
        fbRejectC.xCmd && !aDI[61],
        aDI[36] && aDI[63] && aDI[9],
        xResetAll,
        xTick);
    starter(&fbOutfeedC, aDI[5],
        aDI[25] && aDI[9],
        xAuto,
        z44_Fwd || z44_Rev,
        z44_Enable && !z44_Alarm,
        fbOutfeedC.xCmd && !aDI[18],
        aDI[42] && aDI[5] && aDI[9],
        xResetAll,
        xTick);
    starter(&fbDustC, aDI[32],
        aDI[38] && aDI[17],
        xAuto,
        z45_Fwd || z45_Rev,
        z45_Enable && !z45_Alarm,
        fbDustC.xCmd && !aDI[1],
        aDI[61] && aDI[32] && aDI[17],
        xResetAll,
        xTick);
    starter(&fbCoolC, aDI[7],
        aDI[62] && aDI[34],
        xAuto,
        z46_Fwd || z46_Rev,
        z46_Enable && !z46_Alarm,
        fbCoolC.xCmd && !aDI[12],
        aDI[27] && aDI[7] && aDI[34],
        xResetAll,
        xTick);
    starter(&fbLubeC, aDI[62],
        aDI[37] && aDI[36],
        xAuto,
        z47_Fwd || z47_Rev,
        z47_Enable && !z47_Alarm,
        fbLubeC.xCmd && !aDI[59],
        aDI[15] && aDI[62] && aDI[36],
        xResetAll,
        xTick);
    starter(&fbVacuumC, aDI[25],
        aDI[39] && aDI[10],
        xAuto,
        z48_Fwd || z48_Rev,
        z48_Enable && !z48_Alarm,
        fbVacuumC.xCmd && !aDI[60],
        aDI[2] && aDI[25] && aDI[10],
        xResetAll,
        xTick);
    aDQ[0] = fbInfeedA.xCmd;
    aDQ[1] = fbInfeedA.xLamp;
    aDQ[2] = fbAccumA.xCmd;
    aDQ[3] = fbAccumA.xLamp;
    aDQ[4] = fbMergeA.xCmd;
    aDQ[5] = fbMergeA.xLamp;
    aDQ[6] = fbLiftUpA.xCmd;
    aDQ[7] = fbLiftUpA.xLamp;
    aDQ[8] = fbLiftDownA.xCmd;
    aDQ[9] = fbLiftDownA.xLamp;
    aDQ[10] = fbPressA.xCmd;
    aDQ[11] = fbPressA.xLamp;
    aDQ[12] = fbPressPumpA.xCmd;
    aDQ[13] = fbPressPumpA.xLamp;
    aDQ[14] = fbWrapA.xCmd;
    aDQ[15] = fbWrapA.xLamp;
    aDQ[16] = fbWrapTurnA.xCmd;
    aDQ[17] = fbWrapTurnA.xLamp;
    aDQ[18] = fbLabelA.xCmd;
    aDQ[19] = fbLabelA.xLamp;
    aDQ[20] = fbRejectA.xCmd;
    aDQ[21] = fbRejectA.xLamp;
    aDQ[22] = fbOutfeedA.xCmd;
    aDQ[23] = fbOutfeedA.xLamp;
    aDQ[24] = fbDustA.xCmd;
    aDQ[25] = fbDustA.xLamp;
    aDQ[26] = fbCoolA.xCmd;
    aDQ[27] = fbCoolA.xLamp;
    aDQ[28] = fbLubeA.xCmd;
    aDQ[29] = fbLubeA.xLamp;
    aDQ[30] = fbVacuumA.xCmd;
    aDQ[31] = fbVacuumA.xLamp;
    aDQ[32] = fbInfeedB.xCmd;
    aDQ[33] = fbInfeedB.xLamp;
    aDQ[34] = fbAccumB.xCmd;
    aDQ[35] = fbAccumB.xLamp;
    aDQ[36] = fbMergeB.xCmd;
    aDQ[37] = fbMergeB.xLamp;
    aDQ[38] = fbLiftUpB.xCmd;
    aDQ[39] = fbLiftUpB.xLamp;
    aDQ[40] = fbLiftDownB.xCmd;
    aDQ[41] = fbLiftDownB.xLamp;
    aDQ[42] = fbPressB.xCmd;
    aDQ[43] = fbPressB.xLamp;
    aDQ[44] = fbPressPumpB.xCmd;
    aDQ[45] = fbPressPumpB.xLamp;
    aDQ[46] = fbWrapB.xCmd;
    aDQ[47] = fbWrapB.xLamp;
    aDQ[48] = fbWrapTurnB.xCmd;
    aDQ[49] = fbWrapTurnB.xLamp;
    aDQ[50] = fbLabelB.xCmd;
    aDQ[51] = fbLabelB.xLamp;
    aDQ[52] = fbRejectB.xCmd;
    aDQ[53] = fbRejectB.xLamp;
    aDQ[54] = fbOutfeedB.xCmd;
    aDQ[55] = fbOutfeedB.xLamp;
    aDQ[56] = fbDustB.xCmd;
    aDQ[57] = fbDustB.xLamp;
    aDQ[58] = fbCoolB.xCmd;
    aDQ[59] = fbCoolB.xLamp;
    aDQ[60] = fbLubeB.xCmd;
    aDQ[61] = fbLubeB.xLamp;
    aDQ[62] = fbVacuumB.xCmd;
    aDQ[63] = fbVacuumB.xLamp;
    aDQ[64] = fbInfeedC.xCmd;
    aDQ[65] = fbInfeedC.xLamp;
    aDQ[66] = fbAccumC.xCmd;
    aDQ[67] = fbAccumC.xLamp;
    aDQ[68] = fbMergeC.xCmd;
    aDQ[69] = fbMergeC.xLamp;
    aDQ[70] = fbLiftUpC.xCmd;
    aDQ[71] = fbLiftUpC.xLamp;
    aDQ[72] = fbLiftDownC.xCmd;
    aDQ[73] = fbLiftDownC.xLamp;
    aDQ[74] = fbPressC.xCmd;
    aDQ[75] = fbPressC.xLamp;
    aDQ[76] = fbPressPumpC.xCmd;
    aDQ[77] = fbPressPumpC.xLamp;
    aDQ[78] = fbWrapC.xCmd;
    aDQ[79] = fbWrapC.xLamp;
    aDQ[80] = fbWrapTurnC.xCmd;
    aDQ[81] = fbWrapTurnC.xLamp;
    aDQ[82] = fbLabelC.xCmd;
    aDQ[83] = fbLabelC.xLamp;
    aDQ[84] = fbRejectC.xCmd;
    aDQ[85] = fbRejectC.xLamp;
    aDQ[86] = fbOutfeedC.xCmd;
    aDQ[87] = fbOutfeedC.xLamp;
    aDQ[88] = fbDustC.xCmd;
    aDQ[89] = fbDustC.xLamp;
    aDQ[90] = fbCoolC.xCmd;
    aDQ[91] = fbCoolC.xLamp;
    aDQ[92] = fbLubeC.xCmd;
    aDQ[93] = fbLubeC.xLamp;
    aDQ[94] = fbVacuumC.xCmd;
    aDQ[95] = fbVacuumC.xLamp;
    for (j = 0; j < 3; j++) {
        dwOut = 0;
        for (i = 0; i < 32; i++)
            if (aDQ[32 * j + i])
                dwOut |= 1u << i;
        check = (int32_t)((uint32_t)check * 31u + dwOut);
    }
    if (z01_Alarm || z01_Done)
        check = (int32_t)((uint32_t)check + 1u);
    if (z02_Alarm || z02_Done)
        check = (int32_t)((uint32_t)check + 2u);
    if (z03_Alarm || z03_Done)
        check = (int32_t)((uint32_t)check + 3u);
    if (z04_Alarm || z04_Done)
        check = (int32_t)((uint32_t)check + 4u);
    if (z05_Alarm || z05_Done)
        check = (int32_t)((uint32_t)check + 5u);
    if (z06_Alarm || z06_Done)
        check = (int32_t)((uint32_t)check + 6u);
    if (z07_Alarm || z07_Done)
        check = (int32_t)((uint32_t)check + 7u);
    if (z08_Alarm || z08_Done)
        check = (int32_t)((uint32_t)check + 8u);
    if (z09_Alarm || z09_Done)
        check = (int32_t)((uint32_t)check + 9u);
    if (z10_Alarm || z10_Done)
        check = (int32_t)((uint32_t)check + 10u);
    if (z11_Alarm || z11_Done)
        check = (int32_t)((uint32_t)check + 11u);
    if (z12_Alarm || z12_Done)
        check = (int32_t)((uint32_t)check + 12u);
    if (z13_Alarm || z13_Done)
        check = (int32_t)((uint32_t)check + 13u);
    if (z14_Alarm || z14_Done)
        check = (int32_t)((uint32_t)check + 14u);
    if (z15_Alarm || z15_Done)
        check = (int32_t)((uint32_t)check + 15u);
    if (z16_Alarm || z16_Done)
        check = (int32_t)((uint32_t)check + 16u);
    if (z17_Alarm || z17_Done)
        check = (int32_t)((uint32_t)check + 17u);
    if (z18_Alarm || z18_Done)
        check = (int32_t)((uint32_t)check + 18u);
    if (z19_Alarm || z19_Done)
        check = (int32_t)((uint32_t)check + 19u);
    if (z20_Alarm || z20_Done)
        check = (int32_t)((uint32_t)check + 20u);
    if (z21_Alarm || z21_Done)
        check = (int32_t)((uint32_t)check + 21u);
    if (z22_Alarm || z22_Done)
        check = (int32_t)((uint32_t)check + 22u);
    if (z23_Alarm || z23_Done)
        check = (int32_t)((uint32_t)check + 23u);
    if (z24_Alarm || z24_Done)
        check = (int32_t)((uint32_t)check + 24u);
    if (z25_Alarm || z25_Done)
        check = (int32_t)((uint32_t)check + 25u);
    if (z26_Alarm || z26_Done)
        check = (int32_t)((uint32_t)check + 26u);
    if (z27_Alarm || z27_Done)
        check = (int32_t)((uint32_t)check + 27u);
    if (z28_Alarm || z28_Done)
        check = (int32_t)((uint32_t)check + 28u);
    if (z29_Alarm || z29_Done)
        check = (int32_t)((uint32_t)check + 29u);
    if (z30_Alarm || z30_Done)
        check = (int32_t)((uint32_t)check + 30u);
    if (z31_Alarm || z31_Done)
        check = (int32_t)((uint32_t)check + 31u);
    if (z32_Alarm || z32_Done)
        check = (int32_t)((uint32_t)check + 32u);
    if (z33_Alarm || z33_Done)
        check = (int32_t)((uint32_t)check + 33u);
    if (z34_Alarm || z34_Done)
        check = (int32_t)((uint32_t)check + 34u);
    if (z35_Alarm || z35_Done)
        check = (int32_t)((uint32_t)check + 35u);
    if (z36_Alarm || z36_Done)
        check = (int32_t)((uint32_t)check + 36u);
    if (z37_Alarm || z37_Done)
        check = (int32_t)((uint32_t)check + 37u);
    if (z38_Alarm || z38_Done)
        check = (int32_t)((uint32_t)check + 38u);
    if (z39_Alarm || z39_Done)
        check = (int32_t)((uint32_t)check + 39u);
    if (z40_Alarm || z40_Done)
        check = (int32_t)((uint32_t)check + 40u);
    if (z41_Alarm || z41_Done)
        check = (int32_t)((uint32_t)check + 41u);
    if (z42_Alarm || z42_Done)
        check = (int32_t)((uint32_t)check + 42u);
    if (z43_Alarm || z43_Done)
        check = (int32_t)((uint32_t)check + 43u);
    if (z44_Alarm || z44_Done)
        check = (int32_t)((uint32_t)check + 44u);
    if (z45_Alarm || z45_Done)
        check = (int32_t)((uint32_t)check + 45u);
    if (z46_Alarm || z46_Done)
        check = (int32_t)((uint32_t)check + 46u);
    if (z47_Alarm || z47_Done)
        check = (int32_t)((uint32_t)check + 47u);
    if (z48_Alarm || z48_Done)
        check = (int32_t)((uint32_t)check + 48u);
}
