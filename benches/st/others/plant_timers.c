/* 500 timers and counters: 150 TON, 100 TOF, 50 TP, 140 CTU, 60 CTD */
#include <stdbool.h>
#include "st.h"

typedef struct { bool IN; int32_t PT; bool Q; int32_t ET; bool M; int32_t start; } Timer;
typedef struct { bool C; bool R; int16_t PV; bool Q; int16_t CV; bool M; } Counter;

static void TON(Timer *t, bool IN, int32_t PT)
{
    int32_t now = (int32_t)(now_us / 1000);

    t->IN = IN;
    t->PT = PT;
    if (!IN) {
        t->Q = false;
        t->ET = 0;
    } else {
        if (!t->M)
            t->start = now;
        if (!t->Q) {
            t->ET = now - t->start;
            if (t->ET >= PT) {
                t->ET = PT;
                t->Q = true;
            }
        }
    }
    t->M = IN;
}

static void TOF(Timer *t, bool IN, int32_t PT)
{
    int32_t now = (int32_t)(now_us / 1000);

    t->IN = IN;
    t->PT = PT;
    if (IN) {
        t->Q = true;
        t->ET = 0;
    } else if (t->Q) {
        if (t->M)
            t->start = now;
        t->ET = now - t->start;
        if (t->ET >= PT) {
            t->ET = PT;
            t->Q = false;
        }
    }
    t->M = IN;
}

static void TP(Timer *t, bool IN, int32_t PT)
{
    int32_t now = (int32_t)(now_us / 1000);

    t->IN = IN;
    t->PT = PT;
    if (t->Q) {
        t->ET = now - t->start;
        if (t->ET >= PT) {
            t->ET = PT;
            t->Q = false;
        }
    } else if (IN && !t->M) {
        t->start = now;
        t->ET = 0;
        t->Q = true;
    }
    if (!t->Q && !IN)
        t->ET = 0;
    t->M = IN;
}

static void CTU(Counter *c, bool CU, bool R, int16_t PV)
{
    c->C = CU;
    c->R = R;
    c->PV = PV;
    if (R)
        c->CV = 0;
    else if (CU && !c->M && c->CV < INT16_MAX)
        c->CV = c->CV + 1;
    c->M = CU;
    c->Q = c->CV >= PV;
}

static void CTD(Counter *c, bool CD, bool LD, int16_t PV)
{
    c->C = CD;
    c->R = LD;
    c->PV = PV;
    if (LD)
        c->CV = PV;
    else if (CD && !c->M && c->CV > INT16_MIN)
        c->CV = c->CV - 1;
    c->M = CD;
    c->Q = c->CV <= 0;
}

static int32_t diScan;
static Timer atonDelay[120], atofRun[80], atpPulse[50];
static Counter actuParts[120], actdBatch[50];
static Timer tonValve00;
static Timer tonValve01;
static Timer tonValve02;
static Timer tonValve03;
static Timer tonValve04;
static Timer tonValve05;
static Timer tonValve06;
static Timer tonValve07;
static Timer tonValve08;
static Timer tonValve09;
static Timer tonValve10;
static Timer tonValve11;
static Timer tonValve12;
static Timer tonValve13;
static Timer tonValve14;
static Timer tonValve15;
static Timer tonValve16;
static Timer tonValve17;
static Timer tonValve18;
static Timer tonValve19;
static Timer tonValve20;
static Timer tonValve21;
static Timer tonValve22;
static Timer tonValve23;
static Timer tonValve24;
static Timer tonValve25;
static Timer tonValve26;
static Timer tonValve27;
static Timer tonValve28;
static Timer tonValve29;
static Timer tofFan00;
static Timer tofFan01;
static Timer tofFan02;
static Timer tofFan03;
static Timer tofFan04;
static Timer tofFan05;
static Timer tofFan06;
static Timer tofFan07;
static Timer tofFan08;
static Timer tofFan09;
static Timer tofFan10;
static Timer tofFan11;
static Timer tofFan12;
static Timer tofFan13;
static Timer tofFan14;
static Timer tofFan15;
static Timer tofFan16;
static Timer tofFan17;
static Timer tofFan18;
static Timer tofFan19;
static Counter ctuBox00;
static Counter ctuBox01;
static Counter ctuBox02;
static Counter ctuBox03;
static Counter ctuBox04;
static Counter ctuBox05;
static Counter ctuBox06;
static Counter ctuBox07;
static Counter ctuBox08;
static Counter ctuBox09;
static Counter ctuBox10;
static Counter ctuBox11;
static Counter ctuBox12;
static Counter ctuBox13;
static Counter ctuBox14;
static Counter ctuBox15;
static Counter ctuBox16;
static Counter ctuBox17;
static Counter ctuBox18;
static Counter ctuBox19;
static Counter ctdPal00;
static Counter ctdPal01;
static Counter ctdPal02;
static Counter ctdPal03;
static Counter ctdPal04;
static Counter ctdPal05;
static Counter ctdPal06;
static Counter ctdPal07;
static Counter ctdPal08;
static Counter ctdPal09;

void scan(void)
{
    int32_t diSum, i;
    bool xIn, xCnt;

    diScan = diScan + 1;
    diSum = 0;
    for (i = 0; i < 120; i++) {
        xIn = (diScan + i * 3) % (40 + i) > 12;
        TON(&atonDelay[i], xIn, 50);
        if (atonDelay[i].Q) diSum += i;
        diSum += atonDelay[i].ET;
    }
    for (i = 0; i < 80; i++) {
        xIn = (diScan + i * 5) % (30 + i) < 9;
        TOF(&atofRun[i], xIn, 120);
        if (atofRun[i].Q) diSum += i * 2;
        diSum += atofRun[i].ET;
    }
    for (i = 0; i < 50; i++) {
        TP(&atpPulse[i], atonDelay[i].Q, 70);
        if (atpPulse[i].Q) diSum += i * 3;
        diSum += atpPulse[i].ET;
    }
    for (i = 0; i < 120; i++) {
        xCnt = (diScan + i) % 3 == 0;
        CTU(&actuParts[i], xCnt, actuParts[i].Q && atonDelay[i].Q, 25);
        diSum += actuParts[i].CV;
    }
    for (i = 0; i < 50; i++) {
        CTD(&actdBatch[i], atofRun[i].Q, actdBatch[i].Q, 8);
        diSum += actdBatch[i].CV;
    }

    TON(&tonValve00, !tonValve00.Q && atofRun[0].Q, 20);
    if (tonValve00.Q) diSum += 1;
    TON(&tonValve01, !tonValve01.Q && atofRun[1].Q, 27);
    if (tonValve01.Q) diSum += 2;
    TON(&tonValve02, !tonValve02.Q && atofRun[2].Q, 34);
    if (tonValve02.Q) diSum += 3;
    TON(&tonValve03, !tonValve03.Q && atofRun[3].Q, 41);
    if (tonValve03.Q) diSum += 4;
    TON(&tonValve04, !tonValve04.Q && atofRun[4].Q, 48);
    if (tonValve04.Q) diSum += 5;
    TON(&tonValve05, !tonValve05.Q && atofRun[5].Q, 55);
    if (tonValve05.Q) diSum += 6;
    TON(&tonValve06, !tonValve06.Q && atofRun[6].Q, 62);
    if (tonValve06.Q) diSum += 7;
    TON(&tonValve07, !tonValve07.Q && atofRun[7].Q, 69);
    if (tonValve07.Q) diSum += 8;
    TON(&tonValve08, !tonValve08.Q && atofRun[8].Q, 76);
    if (tonValve08.Q) diSum += 9;
    TON(&tonValve09, !tonValve09.Q && atofRun[9].Q, 83);
    if (tonValve09.Q) diSum += 10;
    TON(&tonValve10, !tonValve10.Q && atofRun[10].Q, 90);
    if (tonValve10.Q) diSum += 11;
    TON(&tonValve11, !tonValve11.Q && atofRun[11].Q, 97);
    if (tonValve11.Q) diSum += 12;
    TON(&tonValve12, !tonValve12.Q && atofRun[12].Q, 104);
    if (tonValve12.Q) diSum += 13;
    TON(&tonValve13, !tonValve13.Q && atofRun[13].Q, 111);
    if (tonValve13.Q) diSum += 14;
    TON(&tonValve14, !tonValve14.Q && atofRun[14].Q, 118);
    if (tonValve14.Q) diSum += 15;
    TON(&tonValve15, !tonValve15.Q && atofRun[15].Q, 125);
    if (tonValve15.Q) diSum += 16;
    TON(&tonValve16, !tonValve16.Q && atofRun[16].Q, 132);
    if (tonValve16.Q) diSum += 17;
    TON(&tonValve17, !tonValve17.Q && atofRun[17].Q, 139);
    if (tonValve17.Q) diSum += 18;
    TON(&tonValve18, !tonValve18.Q && atofRun[18].Q, 146);
    if (tonValve18.Q) diSum += 19;
    TON(&tonValve19, !tonValve19.Q && atofRun[19].Q, 153);
    if (tonValve19.Q) diSum += 20;
    TON(&tonValve20, !tonValve20.Q && atofRun[20].Q, 160);
    if (tonValve20.Q) diSum += 21;
    TON(&tonValve21, !tonValve21.Q && atofRun[21].Q, 167);
    if (tonValve21.Q) diSum += 22;
    TON(&tonValve22, !tonValve22.Q && atofRun[22].Q, 174);
    if (tonValve22.Q) diSum += 23;
    TON(&tonValve23, !tonValve23.Q && atofRun[23].Q, 181);
    if (tonValve23.Q) diSum += 24;
    TON(&tonValve24, !tonValve24.Q && atofRun[24].Q, 188);
    if (tonValve24.Q) diSum += 25;
    TON(&tonValve25, !tonValve25.Q && atofRun[25].Q, 195);
    if (tonValve25.Q) diSum += 26;
    TON(&tonValve26, !tonValve26.Q && atofRun[26].Q, 202);
    if (tonValve26.Q) diSum += 27;
    TON(&tonValve27, !tonValve27.Q && atofRun[27].Q, 209);
    if (tonValve27.Q) diSum += 28;
    TON(&tonValve28, !tonValve28.Q && atofRun[28].Q, 216);
    if (tonValve28.Q) diSum += 29;
    TON(&tonValve29, !tonValve29.Q && atofRun[29].Q, 223);
    if (tonValve29.Q) diSum += 30;
    TOF(&tofFan00, tonValve00.Q, 50);
    if (tofFan00.Q) diSum += 0;
    TOF(&tofFan01, tonValve01.Q, 55);
    if (tofFan01.Q) diSum += 9;
    TOF(&tofFan02, tonValve02.Q, 60);
    if (tofFan02.Q) diSum += 18;
    TOF(&tofFan03, tonValve03.Q, 65);
    if (tofFan03.Q) diSum += 27;
    TOF(&tofFan04, tonValve04.Q, 70);
    if (tofFan04.Q) diSum += 36;
    TOF(&tofFan05, tonValve05.Q, 75);
    if (tofFan05.Q) diSum += 45;
    TOF(&tofFan06, tonValve06.Q, 80);
    if (tofFan06.Q) diSum += 54;
    TOF(&tofFan07, tonValve07.Q, 85);
    if (tofFan07.Q) diSum += 63;
    TOF(&tofFan08, tonValve08.Q, 90);
    if (tofFan08.Q) diSum += 72;
    TOF(&tofFan09, tonValve09.Q, 95);
    if (tofFan09.Q) diSum += 81;
    TOF(&tofFan10, tonValve10.Q, 100);
    if (tofFan10.Q) diSum += 90;
    TOF(&tofFan11, tonValve11.Q, 105);
    if (tofFan11.Q) diSum += 99;
    TOF(&tofFan12, tonValve12.Q, 110);
    if (tofFan12.Q) diSum += 108;
    TOF(&tofFan13, tonValve13.Q, 115);
    if (tofFan13.Q) diSum += 117;
    TOF(&tofFan14, tonValve14.Q, 120);
    if (tofFan14.Q) diSum += 126;
    TOF(&tofFan15, tonValve15.Q, 125);
    if (tofFan15.Q) diSum += 135;
    TOF(&tofFan16, tonValve16.Q, 130);
    if (tofFan16.Q) diSum += 144;
    TOF(&tofFan17, tonValve17.Q, 135);
    if (tofFan17.Q) diSum += 153;
    TOF(&tofFan18, tonValve18.Q, 140);
    if (tofFan18.Q) diSum += 162;
    TOF(&tofFan19, tonValve19.Q, 145);
    if (tofFan19.Q) diSum += 171;
    CTU(&ctuBox00, tofFan00.Q, ctuBox00.Q, 4);
    diSum += ctuBox00.CV;
    CTU(&ctuBox01, tofFan01.Q, ctuBox01.Q, 5);
    diSum += ctuBox01.CV;
    CTU(&ctuBox02, tofFan02.Q, ctuBox02.Q, 6);
    diSum += ctuBox02.CV;
    CTU(&ctuBox03, tofFan03.Q, ctuBox03.Q, 7);
    diSum += ctuBox03.CV;
    CTU(&ctuBox04, tofFan04.Q, ctuBox04.Q, 8);
    diSum += ctuBox04.CV;
    CTU(&ctuBox05, tofFan05.Q, ctuBox05.Q, 9);
    diSum += ctuBox05.CV;
    CTU(&ctuBox06, tofFan06.Q, ctuBox06.Q, 10);
    diSum += ctuBox06.CV;
    CTU(&ctuBox07, tofFan07.Q, ctuBox07.Q, 11);
    diSum += ctuBox07.CV;
    CTU(&ctuBox08, tofFan08.Q, ctuBox08.Q, 12);
    diSum += ctuBox08.CV;
    CTU(&ctuBox09, tofFan09.Q, ctuBox09.Q, 13);
    diSum += ctuBox09.CV;
    CTU(&ctuBox10, tofFan10.Q, ctuBox10.Q, 14);
    diSum += ctuBox10.CV;
    CTU(&ctuBox11, tofFan11.Q, ctuBox11.Q, 15);
    diSum += ctuBox11.CV;
    CTU(&ctuBox12, tofFan12.Q, ctuBox12.Q, 16);
    diSum += ctuBox12.CV;
    CTU(&ctuBox13, tofFan13.Q, ctuBox13.Q, 17);
    diSum += ctuBox13.CV;
    CTU(&ctuBox14, tofFan14.Q, ctuBox14.Q, 18);
    diSum += ctuBox14.CV;
    CTU(&ctuBox15, tofFan15.Q, ctuBox15.Q, 19);
    diSum += ctuBox15.CV;
    CTU(&ctuBox16, tofFan16.Q, ctuBox16.Q, 20);
    diSum += ctuBox16.CV;
    CTU(&ctuBox17, tofFan17.Q, ctuBox17.Q, 21);
    diSum += ctuBox17.CV;
    CTU(&ctuBox18, tofFan18.Q, ctuBox18.Q, 22);
    diSum += ctuBox18.CV;
    CTU(&ctuBox19, tofFan19.Q, ctuBox19.Q, 23);
    diSum += ctuBox19.CV;
    CTD(&ctdPal00, tonValve00.Q, ctdPal00.Q, 3);
    diSum += ctdPal00.CV;
    CTD(&ctdPal01, tonValve01.Q, ctdPal01.Q, 4);
    diSum += ctdPal01.CV;
    CTD(&ctdPal02, tonValve02.Q, ctdPal02.Q, 5);
    diSum += ctdPal02.CV;
    CTD(&ctdPal03, tonValve03.Q, ctdPal03.Q, 6);
    diSum += ctdPal03.CV;
    CTD(&ctdPal04, tonValve04.Q, ctdPal04.Q, 7);
    diSum += ctdPal04.CV;
    CTD(&ctdPal05, tonValve05.Q, ctdPal05.Q, 8);
    diSum += ctdPal05.CV;
    CTD(&ctdPal06, tonValve06.Q, ctdPal06.Q, 9);
    diSum += ctdPal06.CV;
    CTD(&ctdPal07, tonValve07.Q, ctdPal07.Q, 10);
    diSum += ctdPal07.CV;
    CTD(&ctdPal08, tonValve08.Q, ctdPal08.Q, 11);
    diSum += ctdPal08.CV;
    CTD(&ctdPal09, tonValve09.Q, ctdPal09.Q, 12);
    diSum += ctdPal09.CV;

    check = check * 3 + diSum;
}
