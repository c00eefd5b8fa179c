/* 200 FB calls (170 in an array, 30 by name) with helper functions */
#include <stdbool.h>
#include "st.h"

#define MOTORS 169
#define RAW_MAX 27648
#define HYSTERESIS 15

static int32_t Scale(int32_t diRaw, int32_t diLow, int32_t diHigh)
{
    return diLow + diRaw * (diHigh - diLow) / RAW_MAX;
}

static int32_t LimitDi(int32_t diMin, int32_t diIn, int32_t diMax)
{
    if (diIn < diMin)
        return diMin;
    else if (diIn > diMax)
        return diMax;
    else
        return diIn;
}

static bool Hyst(bool xOld, int32_t diVal, int32_t diThr)
{
    if (xOld)
        return diVal > diThr - HYSTERESIS;
    else
        return diVal > diThr + HYSTERESIS;
}

typedef struct {
    bool xStart, xStop;
    int32_t diRaw;
    int32_t diMaxSpeed;
    bool xRun, xHigh;
    int32_t diSpeed;
    int32_t diStarts;
    bool xStartOld;
    int32_t diSet;
    int32_t diRunScans;
} Motor;

static void FB_Motor(Motor *m, bool xStart, bool xStop, int32_t diRaw, int32_t diMaxSpeed)
{
    m->xStart = xStart;
    m->xStop = xStop;
    m->diRaw = diRaw;
    m->diMaxSpeed = diMaxSpeed;

    if (m->xStart && !m->xStartOld && !m->xStop) {
        m->xRun = true;
        m->diStarts++;
    }
    m->xStartOld = m->xStart;
    if (m->xStop)
        m->xRun = false;
    if (m->xRun) {
        m->diSet = LimitDi(0, Scale(m->diRaw, 0, 1500), m->diMaxSpeed);
        m->diRunScans++;
    } else {
        m->diSet = 0;
    }
    m->diSpeed += LimitDi(-20, m->diSet - m->diSpeed, 10);
    m->xHigh = Hyst(m->xHigh, m->diSpeed, 900);
}

static int32_t diScan;
static Motor afbMotor[MOTORS + 1];
static Motor fbPump1;
static Motor fbPump2;
static Motor fbPump3;
static Motor fbPump4;
static Motor fbPump5;
static Motor fbPump6;
static Motor fbPump7;
static Motor fbPump8;
static Motor fbPump9;
static Motor fbPump10;
static Motor fbMixer1;
static Motor fbMixer2;
static Motor fbMixer3;
static Motor fbMixer4;
static Motor fbMixer5;
static Motor fbMixer6;
static Motor fbMixer7;
static Motor fbMixer8;
static Motor fbMixer9;
static Motor fbMixer10;
static Motor fbFan1;
static Motor fbFan2;
static Motor fbFan3;
static Motor fbFan4;
static Motor fbFan5;
static Motor fbFan6;
static Motor fbFan7;
static Motor fbFan8;
static Motor fbFan9;
static Motor fbFan10;

void scan(void)
{
    int32_t diSum, diRaw, i;

    diScan = diScan + 1;
    diSum = 0;
    for (i = 0; i <= MOTORS; i++) {
        diRaw = (diScan * 13 + i * 911) % 27648;
        FB_Motor(&afbMotor[i], (diScan + i) % 50 < 3, (diScan + i * 3) % 70 == 5, diRaw, 1000 + i);
        diSum += afbMotor[i].diSpeed + afbMotor[i].diStarts;
        if (afbMotor[i].xHigh) diSum += i;
    }
    diRaw = (diScan * 29) % 27648;
    FB_Motor(&fbPump1, diScan % 40 < 4, afbMotor[0].xHigh, diRaw, 900);
    diSum += fbPump1.diSpeed;
    FB_Motor(&fbPump2, fbPump1.xRun, afbMotor[5].xHigh, diRaw, 910);
    diSum += fbPump2.diSpeed;
    FB_Motor(&fbPump3, fbPump2.xRun, afbMotor[10].xHigh, diRaw, 920);
    diSum += fbPump3.diSpeed;
    FB_Motor(&fbPump4, fbPump3.xRun, afbMotor[15].xHigh, diRaw, 930);
    diSum += fbPump4.diSpeed;
    FB_Motor(&fbPump5, fbPump4.xRun, afbMotor[20].xHigh, diRaw, 940);
    diSum += fbPump5.diSpeed;
    FB_Motor(&fbPump6, fbPump5.xRun, afbMotor[25].xHigh, diRaw, 950);
    diSum += fbPump6.diSpeed;
    FB_Motor(&fbPump7, fbPump6.xRun, afbMotor[30].xHigh, diRaw, 960);
    diSum += fbPump7.diSpeed;
    FB_Motor(&fbPump8, fbPump7.xRun, afbMotor[35].xHigh, diRaw, 970);
    diSum += fbPump8.diSpeed;
    FB_Motor(&fbPump9, fbPump8.xRun, afbMotor[40].xHigh, diRaw, 980);
    diSum += fbPump9.diSpeed;
    FB_Motor(&fbPump10, fbPump9.xRun, afbMotor[45].xHigh, diRaw, 990);
    diSum += fbPump10.diSpeed;
    FB_Motor(&fbMixer1, fbPump10.xRun, afbMotor[50].xHigh, diRaw, 1000);
    diSum += fbMixer1.diSpeed;
    FB_Motor(&fbMixer2, fbMixer1.xRun, afbMotor[55].xHigh, diRaw, 1010);
    diSum += fbMixer2.diSpeed;
    FB_Motor(&fbMixer3, fbMixer2.xRun, afbMotor[60].xHigh, diRaw, 1020);
    diSum += fbMixer3.diSpeed;
    FB_Motor(&fbMixer4, fbMixer3.xRun, afbMotor[65].xHigh, diRaw, 1030);
    diSum += fbMixer4.diSpeed;
    FB_Motor(&fbMixer5, fbMixer4.xRun, afbMotor[70].xHigh, diRaw, 1040);
    diSum += fbMixer5.diSpeed;
    FB_Motor(&fbMixer6, fbMixer5.xRun, afbMotor[75].xHigh, diRaw, 1050);
    diSum += fbMixer6.diSpeed;
    FB_Motor(&fbMixer7, fbMixer6.xRun, afbMotor[80].xHigh, diRaw, 1060);
    diSum += fbMixer7.diSpeed;
    FB_Motor(&fbMixer8, fbMixer7.xRun, afbMotor[85].xHigh, diRaw, 1070);
    diSum += fbMixer8.diSpeed;
    FB_Motor(&fbMixer9, fbMixer8.xRun, afbMotor[90].xHigh, diRaw, 1080);
    diSum += fbMixer9.diSpeed;
    FB_Motor(&fbMixer10, fbMixer9.xRun, afbMotor[95].xHigh, diRaw, 1090);
    diSum += fbMixer10.diSpeed;
    FB_Motor(&fbFan1, fbMixer10.xRun, afbMotor[100].xHigh, diRaw, 1100);
    diSum += fbFan1.diSpeed;
    FB_Motor(&fbFan2, fbFan1.xRun, afbMotor[105].xHigh, diRaw, 1110);
    diSum += fbFan2.diSpeed;
    FB_Motor(&fbFan3, fbFan2.xRun, afbMotor[110].xHigh, diRaw, 1120);
    diSum += fbFan3.diSpeed;
    FB_Motor(&fbFan4, fbFan3.xRun, afbMotor[115].xHigh, diRaw, 1130);
    diSum += fbFan4.diSpeed;
    FB_Motor(&fbFan5, fbFan4.xRun, afbMotor[120].xHigh, diRaw, 1140);
    diSum += fbFan5.diSpeed;
    FB_Motor(&fbFan6, fbFan5.xRun, afbMotor[125].xHigh, diRaw, 1150);
    diSum += fbFan6.diSpeed;
    FB_Motor(&fbFan7, fbFan6.xRun, afbMotor[130].xHigh, diRaw, 1160);
    diSum += fbFan7.diSpeed;
    FB_Motor(&fbFan8, fbFan7.xRun, afbMotor[135].xHigh, diRaw, 1170);
    diSum += fbFan8.diSpeed;
    FB_Motor(&fbFan9, fbFan8.xRun, afbMotor[140].xHigh, diRaw, 1180);
    diSum += fbFan9.diSpeed;
    FB_Motor(&fbFan10, fbFan9.xRun, afbMotor[145].xHigh, diRaw, 1190);
    diSum += fbFan10.diSpeed;
    check = check * 3 + diSum;
}
