/* 64 PID loops: 56 in an array, 8 by name */
#include <stdbool.h>
#include "st.h"

#define LOOPS 55
#define CYCLE 0.01f

typedef struct {
    float rSP, rPV;
    float rKp, rTn, rTv;
    float rMin, rMax;
    bool xManual;
    float rManual;
    float rOut;
    bool xLimited;
    float rErr, rErrOld, rInt, rDiff, rY;
} Pid;

static float LimitR(float rMin, float rIn, float rMax)
{
    if (rIn < rMin)
        return rMin;
    else if (rIn > rMax)
        return rMax;
    else
        return rIn;
}

static void FB_Pid(Pid *p, float rSP, float rPV, float rKp, float rTn, float rTv,
                   float rMin, float rMax, bool xManual, float rManual)
{
    p->rSP = rSP;
    p->rPV = rPV;
    p->rKp = rKp;
    p->rTn = rTn;
    p->rTv = rTv;
    p->rMin = rMin;
    p->rMax = rMax;
    p->xManual = xManual;
    p->rManual = rManual;

    p->rErr = p->rSP - p->rPV;
    if (p->xManual) {
        p->rOut = LimitR(p->rMin, p->rManual, p->rMax);
        p->rInt = p->rOut - p->rKp * p->rErr;
        p->xLimited = false;
    } else {
        p->rDiff = p->rTv * (p->rErr - p->rErrOld) / CYCLE;
        p->rY = p->rKp * (p->rErr + p->rDiff) + p->rInt;
        p->rOut = LimitR(p->rMin, p->rY, p->rMax);
        p->xLimited = p->rOut != p->rY;
        if (!p->xLimited && p->rTn > 0.0f)
            p->rInt = p->rInt + p->rKp * p->rErr * CYCLE / p->rTn;
    }
    p->rErrOld = p->rErr;
}

static int32_t diScan;
static Pid apidLoop[LOOPS + 1];
static float arPV[LOOPS + 1];
static Pid pidBoiler;
static float rBoilerPV;
static Pid pidSteam;
static float rSteamPV;
static Pid pidFeed;
static float rFeedPV;
static Pid pidLevel;
static float rLevelPV;
static Pid pidDraft;
static float rDraftPV;
static Pid pidO2;
static float rO2PV;
static Pid pidGas;
static float rGasPV;
static Pid pidOil;
static float rOilPV;

static int32_t diSum;

void scan(void)
{
    int32_t i;
    float rSP;
    bool xMan;

    diScan = diScan + 1;
    for (i = 0; i <= LOOPS; i++) {
        rSP = (float)((diScan / 200 + i * 7) % 80);
        xMan = (diScan + i * 16) % 500 < 20;
        FB_Pid(&apidLoop[i], rSP, arPV[i], 1.5f, 2.0f, 0.02f, 0.0f, 100.0f, xMan, 35.0f);
        /* first-order process */
        arPV[i] = arPV[i] + (apidLoop[i].rOut * 0.9f - arPV[i]) * 0.02f;
        if (apidLoop[i].xLimited) diSum++;
    }
    rSP = (float)(diScan / 300 % 90);
    FB_Pid(&pidBoiler, rSP, rBoilerPV, 0.8f, 1.0f, 0.01f, 5.0f, 95.0f, false, 0.0f);
    rBoilerPV = rBoilerPV + (pidBoiler.rOut - rBoilerPV) * 0.01f;
    FB_Pid(&pidSteam, rSP, rSteamPV, 1.0f, 1.5f, 0.02f, 5.0f, 95.0f, false, 0.0f);
    rSteamPV = rSteamPV + (pidSteam.rOut - rSteamPV) * 0.02f;
    FB_Pid(&pidFeed, rSP, rFeedPV, 1.2f, 2.0f, 0.03f, 5.0f, 95.0f, false, 0.0f);
    rFeedPV = rFeedPV + (pidFeed.rOut - rFeedPV) * 0.03f;
    FB_Pid(&pidLevel, rSP, rLevelPV, 1.4f, 2.5f, 0.04f, 5.0f, 95.0f, false, 0.0f);
    rLevelPV = rLevelPV + (pidLevel.rOut - rLevelPV) * 0.04f;
    FB_Pid(&pidDraft, rSP, rDraftPV, 1.6f, 3.0f, 0.05f, 5.0f, 95.0f, false, 0.0f);
    rDraftPV = rDraftPV + (pidDraft.rOut - rDraftPV) * 0.05f;
    FB_Pid(&pidO2, rSP, rO2PV, 1.8f, 3.5f, 0.06f, 5.0f, 95.0f, false, 0.0f);
    rO2PV = rO2PV + (pidO2.rOut - rO2PV) * 0.06f;
    FB_Pid(&pidGas, rSP, rGasPV, 2.0f, 4.0f, 0.07f, 5.0f, 95.0f, false, 0.0f);
    rGasPV = rGasPV + (pidGas.rOut - rGasPV) * 0.07f;
    FB_Pid(&pidOil, rSP, rOilPV, 2.2f, 4.5f, 0.08f, 5.0f, 95.0f, false, 0.0f);
    rOilPV = rOilPV + (pidOil.rOut - rOilPV) * 0.08f;
    for (i = 0; i <= LOOPS; i++)
        diSum += (int32_t)arPV[i];
    diSum += (int32_t)(pidBoiler.rOut * 10.0f);
    diSum += (int32_t)(pidSteam.rOut * 10.0f);
    diSum += (int32_t)(pidFeed.rOut * 10.0f);
    diSum += (int32_t)(pidLevel.rOut * 10.0f);
    diSum += (int32_t)(pidDraft.rOut * 10.0f);
    diSum += (int32_t)(pidO2.rOut * 10.0f);
    diSum += (int32_t)(pidGas.rOut * 10.0f);
    diSum += (int32_t)(pidOil.rOut * 10.0f);
    check = check * 3 + diSum;
}
