/* Interlocks, latches and alarms of a plant: about 2900 boolean networks a scan. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool EStopOk, Auto, Release; } group_t;
typedef struct { bool Perm, StartReq, StopReq, Run, Fbk, FbkErr, Fault, Ready, Lamp; } motor_t;
typedef struct { bool OpenReq, CloseReq, Cmd, Opened, Closed, Moving, PosErr, Locked; } valve_t;
typedef struct { bool Active, Unack, Horn, Old; } alarm_t;

static group_t Grp[30];
static motor_t Mot[130];
static valve_t Vlv[90];
static alarm_t Alm[230];
static bool DI[256];
static bool MotFlt_SR[44], MotFlt_RS[44], VlvLock[46], AlmUnack[230];
static bool Blink, AckAll, HornOff;
static int32_t scan_no;
static uint32_t seed = 12345;

static inline bool sr(bool *q, bool s1, bool r)
{
    return *q = s1 || (!r && *q);
}

static inline bool rs(bool *q, bool s, bool r1)
{
    return *q = !r1 && (s || *q);
}

void scan(void)
{
    scan_no++;
    for (int i = 0; i < 8; i++) {
        seed = seed * 1664525u + 1013904223u;
        for (int j = 0; j < 32; j++)
            DI[i * 32 + j] = (seed >> j) & 1;
    }
    Blink = scan_no % 10 < 5;
    AckAll = scan_no % 37 == 0;
    HornOff = scan_no % 50 > 40;

    /* group interlocks */
    Grp[0].EStopOk = !DI[69] || DI[251];
    Grp[0].Auto = (DI[14] || Grp[0].Auto) && !(DI[183] && DI[175]);
    Grp[0].Release = Grp[0].EStopOk && (DI[24] || DI[153] || !DI[11]);
    Grp[1].EStopOk = !DI[219] || DI[152];
    Grp[1].Auto = (DI[170] || Grp[1].Auto) && !(DI[157] && DI[92]);
    Grp[1].Release = Grp[1].EStopOk && (DI[80] || DI[18] || !DI[191]);
    Grp[2].EStopOk = !DI[94] || DI[223];
    Grp[2].Auto = (DI[52] || Grp[2].Auto) && !(DI[116] && DI[140]);
    Grp[2].Release = Grp[2].EStopOk && (DI[8] || DI[70] || !DI[65]);
    Grp[3].EStopOk = !DI[50] || DI[2];
    Grp[3].Auto = (DI[3] || Grp[3].Auto) && !(DI[124] && DI[62]);
    Grp[3].Release = Grp[3].EStopOk && (DI[77] || DI[242] || !DI[61]);
    Grp[4].EStopOk = !DI[141] || DI[242];
    Grp[4].Auto = (DI[216] || Grp[4].Auto) && !(DI[66] && DI[62]);
    Grp[4].Release = Grp[4].EStopOk && (DI[121] || DI[50] || !DI[66]);
    Grp[5].EStopOk = !DI[113] || DI[118];
    Grp[5].Auto = (DI[162] || Grp[5].Auto) && !(DI[51] && DI[183]);
    Grp[5].Release = Grp[5].EStopOk && (DI[167] || DI[104] || !DI[135]);
    Grp[6].EStopOk = !DI[187] || DI[98];
    Grp[6].Auto = (DI[176] || Grp[6].Auto) && !(DI[107] && DI[160]);
    Grp[6].Release = Grp[6].EStopOk && (DI[155] || DI[168] || !DI[209]);
    Grp[7].EStopOk = !DI[37] || DI[196];
    Grp[7].Auto = (DI[127] || Grp[7].Auto) && !(DI[232] && DI[143]);
    Grp[7].Release = Grp[7].EStopOk && (DI[39] || DI[207] || !DI[6]);
    Grp[8].EStopOk = !DI[134] || DI[25];
    Grp[8].Auto = (DI[129] || Grp[8].Auto) && !(DI[21] && DI[51]);
    Grp[8].Release = Grp[8].EStopOk && (DI[108] || DI[250] || !DI[81]);
    Grp[9].EStopOk = !DI[164] || DI[31];
    Grp[9].Auto = (DI[140] || Grp[9].Auto) && !(DI[22] && DI[138]);
    Grp[9].Release = Grp[9].EStopOk && (DI[32] || DI[172] || !DI[148]);
    Grp[10].EStopOk = !DI[232] || DI[222];
    Grp[10].Auto = (DI[111] || Grp[10].Auto) && !(DI[87] && DI[13]);
    Grp[10].Release = Grp[10].EStopOk && (DI[107] || DI[126] || !DI[223]);
    Grp[11].EStopOk = !DI[218] || DI[117];
    Grp[11].Auto = (DI[52] || Grp[11].Auto) && !(DI[221] && DI[44]);
    Grp[11].Release = Grp[11].EStopOk && (DI[223] || DI[239] || !DI[147]);
    Grp[12].EStopOk = !DI[41] || DI[47];
    Grp[12].Auto = (DI[229] || Grp[12].Auto) && !(DI[204] && DI[243]);
    Grp[12].Release = Grp[12].EStopOk && (DI[72] || DI[113] || !DI[48]);
    Grp[13].EStopOk = !DI[153] || DI[213];
    Grp[13].Auto = (DI[185] || Grp[13].Auto) && !(DI[191] && DI[161]);
    Grp[13].Release = Grp[13].EStopOk && (DI[30] || DI[59] || !DI[173]);
    Grp[14].EStopOk = !DI[143] || DI[233];
    Grp[14].Auto = (DI[168] || Grp[14].Auto) && !(DI[31] && DI[208]);
    Grp[14].Release = Grp[14].EStopOk && (DI[64] || DI[39] || !DI[238]);
    Grp[15].EStopOk = !DI[83] || DI[73];
    Grp[15].Auto = (DI[27] || Grp[15].Auto) && !(DI[207] && DI[57]);
    Grp[15].Release = Grp[15].EStopOk && (DI[172] || DI[159] || !DI[1]);
    Grp[16].EStopOk = !DI[16] || DI[36];
    Grp[16].Auto = (DI[204] || Grp[16].Auto) && !(DI[11] && DI[244]);
    Grp[16].Release = Grp[16].EStopOk && (DI[76] || DI[98] || !DI[38]);
    Grp[17].EStopOk = !DI[200] || DI[181];
    Grp[17].Auto = (DI[83] || Grp[17].Auto) && !(DI[89] && DI[62]);
    Grp[17].Release = Grp[17].EStopOk && (DI[88] || DI[235] || !DI[107]);
    Grp[18].EStopOk = !DI[64] || DI[199];
    Grp[18].Auto = (DI[218] || Grp[18].Auto) && !(DI[45] && DI[150]);
    Grp[18].Release = Grp[18].EStopOk && (DI[156] || DI[61] || !DI[228]);
    Grp[19].EStopOk = !DI[222] || DI[68];
    Grp[19].Auto = (DI[60] || Grp[19].Auto) && !(DI[254] && DI[224]);
    Grp[19].Release = Grp[19].EStopOk && (DI[194] || DI[242] || !DI[93]);
    Grp[20].EStopOk = !DI[94] || DI[155];
    Grp[20].Auto = (DI[187] || Grp[20].Auto) && !(DI[81] && DI[48]);
    Grp[20].Release = Grp[20].EStopOk && (DI[144] || DI[239] || !DI[226]);
    Grp[21].EStopOk = !DI[148] || DI[58];
    Grp[21].Auto = (DI[88] || Grp[21].Auto) && !(DI[250] && DI[147]);
    Grp[21].Release = Grp[21].EStopOk && (DI[179] || DI[40] || !DI[185]);
    Grp[22].EStopOk = !DI[84] || DI[159];
    Grp[22].Auto = (DI[97] || Grp[22].Auto) && !(DI[192] && DI[134]);
    Grp[22].Release = Grp[22].EStopOk && (DI[187] || DI[42] || !DI[44]);
    Grp[23].EStopOk = !DI[24] || DI[74];
    Grp[23].Auto = (DI[6] || Grp[23].Auto) && !(DI[220] && DI[75]);
    Grp[23].Release = Grp[23].EStopOk && (DI[96] || DI[222] || !DI[151]);
    Grp[24].EStopOk = !DI[225] || DI[10];
    Grp[24].Auto = (DI[62] || Grp[24].Auto) && !(DI[85] && DI[220]);
    Grp[24].Release = Grp[24].EStopOk && (DI[116] || DI[170] || !DI[131]);
    Grp[25].EStopOk = !DI[155] || DI[116];
    Grp[25].Auto = (DI[183] || Grp[25].Auto) && !(DI[167] && DI[201]);
    Grp[25].Release = Grp[25].EStopOk && (DI[80] || DI[196] || !DI[216]);
    Grp[26].EStopOk = !DI[60] || DI[192];
    Grp[26].Auto = (DI[238] || Grp[26].Auto) && !(DI[130] && DI[75]);
    Grp[26].Release = Grp[26].EStopOk && (DI[89] || DI[14] || !DI[115]);
    Grp[27].EStopOk = !DI[6] || DI[163];
    Grp[27].Auto = (DI[68] || Grp[27].Auto) && !(DI[35] && DI[26]);
    Grp[27].Release = Grp[27].EStopOk && (DI[150] || DI[98] || !DI[253]);
    Grp[28].EStopOk = !DI[87] || DI[107];
    Grp[28].Auto = (DI[229] || Grp[28].Auto) && !(DI[102] && DI[209]);
    Grp[28].Release = Grp[28].EStopOk && (DI[129] || DI[43] || !DI[204]);
    Grp[29].EStopOk = !DI[236] || DI[210];
    Grp[29].Auto = (DI[53] || Grp[29].Auto) && !(DI[153] && DI[103]);
    Grp[29].Release = Grp[29].EStopOk && (DI[57] || DI[167] || !DI[218]);

    /* motor M101 */
    Mot[0].Perm = Grp[21].Release && (DI[208] || DI[54]) && (DI[175] || DI[78]);
    Mot[0].StartReq = (Grp[21].Auto && DI[227]) || (!Grp[21].Auto && DI[46] && !DI[69]);
    Mot[0].StopReq = (DI[157] && DI[224]) || !Mot[0].Perm || Mot[0].Fault;
    Mot[0].Run = (Mot[0].StartReq || Mot[0].Run) && !Mot[0].StopReq;
    Mot[0].Fbk = Mot[0].Run && (!DI[175] || Mot[0].Fbk);
    Mot[0].FbkErr = (Mot[0].Run != Mot[0].Fbk) && DI[84];
    Mot[0].Fault = sr(&MotFlt_SR[0], Mot[0].FbkErr && DI[65], DI[180]);
    Mot[0].Ready = Mot[0].Perm && !Mot[0].Fault && !Mot[0].Run;
    Mot[0].Lamp = Mot[0].Run || (Mot[0].Fault && Blink) || (Mot[0].Ready && DI[154] && Blink);

    /* motor M102 */
    Mot[1].Perm = Grp[16].Release && (!DI[128] || DI[100]) && (Mot[0].Run || !DI[224]);
    Mot[1].StartReq = (Grp[16].Auto && DI[193]) || (!Grp[16].Auto && DI[71] && DI[64]);
    Mot[1].StopReq = (DI[65] && DI[171]) || !Mot[1].Perm || Mot[1].Fault;
    Mot[1].Run = (Mot[1].StartReq || Mot[1].Run) && !Mot[1].StopReq;
    Mot[1].Fbk = Mot[1].Run && (!DI[186] || Mot[1].Fbk);
    Mot[1].FbkErr = (Mot[1].Run != Mot[1].Fbk) && DI[230];
    Mot[1].Fault = rs(&MotFlt_RS[0], Mot[1].FbkErr, DI[48]);
    Mot[1].Ready = Mot[1].Perm && !Mot[1].Fault && !Mot[1].Run;
    Mot[1].Lamp = Mot[1].Run || (Mot[1].Fault && Blink) || (Mot[1].Ready && DI[12] && Blink);

    /* motor M103 */
    Mot[2].Perm = Grp[15].Release && (DI[29] || DI[11]) && (Mot[1].Run || DI[125]);
    Mot[2].StartReq = (Grp[15].Auto && DI[102]) || (!Grp[15].Auto && DI[121] && DI[140]);
    Mot[2].StopReq = (DI[96] && DI[245]) || !Mot[2].Perm || Mot[2].Fault;
    Mot[2].Run = (Mot[2].StartReq || Mot[2].Run) && !Mot[2].StopReq;
    Mot[2].Fbk = Mot[2].Run && (DI[205] || Mot[2].Fbk);
    Mot[2].FbkErr = (Mot[2].Run != Mot[2].Fbk) && DI[37];
    if (Mot[2].FbkErr && DI[50])
        Mot[2].Fault = true;
    else if (DI[112])
        Mot[2].Fault = false;
    Mot[2].Ready = Mot[2].Perm && !Mot[2].Fault && !Mot[2].Run;
    Mot[2].Lamp = Mot[2].Run || (Mot[2].Fault && Blink) || (Mot[2].Ready && DI[51] && Blink);

    /* motor M104 */
    Mot[3].Perm = Grp[26].Release && (!DI[243] || DI[93]) && (Mot[2].Run || !DI[143]);
    Mot[3].StartReq = (Grp[26].Auto && DI[52]) || (!Grp[26].Auto && DI[49] && DI[213]);
    Mot[3].StopReq = (DI[217] && DI[84]) || !Mot[3].Perm || Mot[3].Fault;
    Mot[3].Run = (Mot[3].StartReq || Mot[3].Run) && !Mot[3].StopReq;
    Mot[3].Fbk = Mot[3].Run && (DI[171] || Mot[3].Fbk);
    Mot[3].FbkErr = (Mot[3].Run != Mot[3].Fbk) && DI[207];
    Mot[3].Fault = sr(&MotFlt_SR[1], Mot[3].FbkErr && DI[24], DI[91]);
    Mot[3].Ready = Mot[3].Perm && !Mot[3].Fault && !Mot[3].Run;
    Mot[3].Lamp = Mot[3].Run || (Mot[3].Fault && Blink) || (Mot[3].Ready && DI[130] && Blink);

    /* motor M105 */
    Mot[4].Perm = Grp[22].Release && (DI[112] || !DI[185]) && (Mot[2].Run || DI[170]);
    Mot[4].StartReq = (Grp[22].Auto && DI[10]) || (!Grp[22].Auto && DI[220] && !DI[177]);
    Mot[4].StopReq = (DI[181] && DI[98]) || !Mot[4].Perm || Mot[4].Fault;
    Mot[4].Run = (Mot[4].StartReq || Mot[4].Run) && !Mot[4].StopReq;
    Mot[4].Fbk = Mot[4].Run && (DI[38] || Mot[4].Fbk);
    Mot[4].FbkErr = (Mot[4].Run != Mot[4].Fbk) && DI[234];
    Mot[4].Fault = rs(&MotFlt_RS[1], Mot[4].FbkErr, DI[17]);
    Mot[4].Ready = Mot[4].Perm && !Mot[4].Fault && !Mot[4].Run;
    Mot[4].Lamp = Mot[4].Run || (Mot[4].Fault && Blink) || (Mot[4].Ready && DI[38] && Blink);

    /* motor M106 */
    Mot[5].Perm = Grp[17].Release && (DI[196] || !DI[99]) && (Mot[1].Run || !DI[144]);
    Mot[5].StartReq = (Grp[17].Auto && DI[150]) || (!Grp[17].Auto && DI[121] && DI[176]);
    Mot[5].StopReq = (DI[22] && !DI[237]) || !Mot[5].Perm || Mot[5].Fault;
    Mot[5].Run = (Mot[5].StartReq || Mot[5].Run) && !Mot[5].StopReq;
    Mot[5].Fbk = Mot[5].Run && (DI[0] || Mot[5].Fbk);
    Mot[5].FbkErr = (Mot[5].Run != Mot[5].Fbk) && DI[81];
    if (Mot[5].FbkErr && DI[72])
        Mot[5].Fault = true;
    else if (DI[109])
        Mot[5].Fault = false;
    Mot[5].Ready = Mot[5].Perm && !Mot[5].Fault && !Mot[5].Run;
    Mot[5].Lamp = Mot[5].Run || (Mot[5].Fault && Blink) || (Mot[5].Ready && DI[77] && Blink);

    /* motor M107 */
    Mot[6].Perm = Grp[24].Release && (!DI[197] || DI[217]) && (Mot[3].Run || DI[167]);
    Mot[6].StartReq = (Grp[24].Auto && DI[104]) || (!Grp[24].Auto && DI[185] && DI[79]);
    Mot[6].StopReq = (DI[189] && !DI[32]) || !Mot[6].Perm || Mot[6].Fault;
    Mot[6].Run = (Mot[6].StartReq || Mot[6].Run) && !Mot[6].StopReq;
    Mot[6].Fbk = Mot[6].Run && (!DI[77] || Mot[6].Fbk);
    Mot[6].FbkErr = (Mot[6].Run != Mot[6].Fbk) && DI[197];
    Mot[6].Fault = sr(&MotFlt_SR[2], Mot[6].FbkErr && DI[56], DI[102]);
    Mot[6].Ready = Mot[6].Perm && !Mot[6].Fault && !Mot[6].Run;
    Mot[6].Lamp = Mot[6].Run || (Mot[6].Fault && Blink) || (Mot[6].Ready && DI[38] && Blink);

    /* motor M108 */
    Mot[7].Perm = Grp[29].Release && (DI[110] || DI[196]) && (Mot[1].Run || DI[180]);
    Mot[7].StartReq = (Grp[29].Auto && DI[221]) || (!Grp[29].Auto && DI[93] && DI[135]);
    Mot[7].StopReq = (DI[111] && DI[93]) || !Mot[7].Perm || Mot[7].Fault;
    Mot[7].Run = (Mot[7].StartReq || Mot[7].Run) && !Mot[7].StopReq;
    Mot[7].Fbk = Mot[7].Run && (DI[148] || Mot[7].Fbk);
    Mot[7].FbkErr = (Mot[7].Run != Mot[7].Fbk) && DI[154];
    Mot[7].Fault = rs(&MotFlt_RS[2], Mot[7].FbkErr, DI[107]);
    Mot[7].Ready = Mot[7].Perm && !Mot[7].Fault && !Mot[7].Run;
    Mot[7].Lamp = Mot[7].Run || (Mot[7].Fault && Blink) || (Mot[7].Ready && DI[121] && Blink);

    /* motor M109 */
    Mot[8].Perm = Grp[3].Release && (DI[232] || DI[25]) && (Mot[0].Run || DI[171]);
    Mot[8].StartReq = (Grp[3].Auto && DI[238]) || (!Grp[3].Auto && DI[231] && DI[0]);
    Mot[8].StopReq = (DI[71] && DI[168]) || !Mot[8].Perm || Mot[8].Fault;
    Mot[8].Run = (Mot[8].StartReq || Mot[8].Run) && !Mot[8].StopReq;
    Mot[8].Fbk = Mot[8].Run && (DI[67] || Mot[8].Fbk);
    Mot[8].FbkErr = (Mot[8].Run != Mot[8].Fbk) && DI[78];
    if (Mot[8].FbkErr && DI[63])
        Mot[8].Fault = true;
    else if (DI[231])
        Mot[8].Fault = false;
    Mot[8].Ready = Mot[8].Perm && !Mot[8].Fault && !Mot[8].Run;
    Mot[8].Lamp = Mot[8].Run || (Mot[8].Fault && Blink) || (Mot[8].Ready && DI[129] && Blink);

    /* motor M110 */
    Mot[9].Perm = Grp[27].Release && (DI[37] || DI[19]) && (Mot[4].Run || DI[170]);
    Mot[9].StartReq = (Grp[27].Auto && DI[72]) || (!Grp[27].Auto && DI[2] && !DI[58]);
    Mot[9].StopReq = (DI[1] && DI[34]) || !Mot[9].Perm || Mot[9].Fault;
    Mot[9].Run = (Mot[9].StartReq || Mot[9].Run) && !Mot[9].StopReq;
    Mot[9].Fbk = Mot[9].Run && (!DI[199] || Mot[9].Fbk);
    Mot[9].FbkErr = (Mot[9].Run != Mot[9].Fbk) && DI[167];
    Mot[9].Fault = sr(&MotFlt_SR[3], Mot[9].FbkErr && DI[148], DI[249]);
    Mot[9].Ready = Mot[9].Perm && !Mot[9].Fault && !Mot[9].Run;
    Mot[9].Lamp = Mot[9].Run || (Mot[9].Fault && Blink) || (Mot[9].Ready && DI[97] && Blink);

    /* motor M111 */
    Mot[10].Perm = Grp[25].Release && (DI[115] || !DI[232]) && (Mot[5].Run || DI[50]);
    Mot[10].StartReq = (Grp[25].Auto && DI[127]) || (!Grp[25].Auto && DI[198] && DI[65]);
    Mot[10].StopReq = (DI[96] && DI[193]) || !Mot[10].Perm || Mot[10].Fault;
    Mot[10].Run = (Mot[10].StartReq || Mot[10].Run) && !Mot[10].StopReq;
    Mot[10].Fbk = Mot[10].Run && (!DI[84] || Mot[10].Fbk);
    Mot[10].FbkErr = (Mot[10].Run != Mot[10].Fbk) && DI[135];
    Mot[10].Fault = rs(&MotFlt_RS[3], Mot[10].FbkErr, DI[78]);
    Mot[10].Ready = Mot[10].Perm && !Mot[10].Fault && !Mot[10].Run;
    Mot[10].Lamp = Mot[10].Run || (Mot[10].Fault && Blink) || (Mot[10].Ready && DI[21] && Blink);

    /* motor M112 */
    Mot[11].Perm = Grp[22].Release && (DI[136] || DI[177]) && (Mot[4].Run || DI[91]);
    Mot[11].StartReq = (Grp[22].Auto && DI[176]) || (!Grp[22].Auto && DI[247] && DI[24]);
    Mot[11].StopReq = (DI[228] && DI[29]) || !Mot[11].Perm || Mot[11].Fault;
    Mot[11].Run = (Mot[11].StartReq || Mot[11].Run) && !Mot[11].StopReq;
    Mot[11].Fbk = Mot[11].Run && (DI[38] || Mot[11].Fbk);
    Mot[11].FbkErr = (Mot[11].Run != Mot[11].Fbk) && DI[25];
    if (Mot[11].FbkErr && DI[249])
        Mot[11].Fault = true;
    else if (DI[214])
        Mot[11].Fault = false;
    Mot[11].Ready = Mot[11].Perm && !Mot[11].Fault && !Mot[11].Run;
    Mot[11].Lamp = Mot[11].Run || (Mot[11].Fault && Blink) || (Mot[11].Ready && DI[83] && Blink);

    /* motor M113 */
    Mot[12].Perm = Grp[9].Release && (DI[129] || DI[89]) && (Mot[7].Run || DI[53]);
    Mot[12].StartReq = (Grp[9].Auto && DI[183]) || (!Grp[9].Auto && DI[194] && DI[19]);
    Mot[12].StopReq = (DI[146] && DI[61]) || !Mot[12].Perm || Mot[12].Fault;
    Mot[12].Run = (Mot[12].StartReq || Mot[12].Run) && !Mot[12].StopReq;
    Mot[12].Fbk = Mot[12].Run && (DI[63] || Mot[12].Fbk);
    Mot[12].FbkErr = (Mot[12].Run != Mot[12].Fbk) && DI[9];
    Mot[12].Fault = sr(&MotFlt_SR[4], Mot[12].FbkErr && DI[124], DI[44]);
    Mot[12].Ready = Mot[12].Perm && !Mot[12].Fault && !Mot[12].Run;
    Mot[12].Lamp = Mot[12].Run || (Mot[12].Fault && Blink) || (Mot[12].Ready && DI[127] && Blink);

    /* motor M114 */
    Mot[13].Perm = Grp[11].Release && (DI[216] || DI[2]) && (Mot[12].Run || DI[35]);
    Mot[13].StartReq = (Grp[11].Auto && DI[207]) || (!Grp[11].Auto && DI[176] && DI[199]);
    Mot[13].StopReq = (DI[102] && DI[23]) || !Mot[13].Perm || Mot[13].Fault;
    Mot[13].Run = (Mot[13].StartReq || Mot[13].Run) && !Mot[13].StopReq;
    Mot[13].Fbk = Mot[13].Run && (!DI[192] || Mot[13].Fbk);
    Mot[13].FbkErr = (Mot[13].Run != Mot[13].Fbk) && DI[36];
    Mot[13].Fault = rs(&MotFlt_RS[4], Mot[13].FbkErr, DI[186]);
    Mot[13].Ready = Mot[13].Perm && !Mot[13].Fault && !Mot[13].Run;
    Mot[13].Lamp = Mot[13].Run || (Mot[13].Fault && Blink) || (Mot[13].Ready && DI[176] && Blink);

    /* motor M115 */
    Mot[14].Perm = Grp[25].Release && (DI[109] || !DI[106]) && (Mot[2].Run || DI[198]);
    Mot[14].StartReq = (Grp[25].Auto && DI[253]) || (!Grp[25].Auto && DI[175] && !DI[62]);
    Mot[14].StopReq = (DI[227] && DI[209]) || !Mot[14].Perm || Mot[14].Fault;
    Mot[14].Run = (Mot[14].StartReq || Mot[14].Run) && !Mot[14].StopReq;
    Mot[14].Fbk = Mot[14].Run && (DI[108] || Mot[14].Fbk);
    Mot[14].FbkErr = (Mot[14].Run != Mot[14].Fbk) && DI[64];
    if (Mot[14].FbkErr && DI[147])
        Mot[14].Fault = true;
    else if (DI[169])
        Mot[14].Fault = false;
    Mot[14].Ready = Mot[14].Perm && !Mot[14].Fault && !Mot[14].Run;
    Mot[14].Lamp = Mot[14].Run || (Mot[14].Fault && Blink) || (Mot[14].Ready && DI[221] && Blink);

    /* motor M116 */
    Mot[15].Perm = Grp[12].Release && (!DI[73] || DI[137]) && (Mot[4].Run || !DI[252]);
    Mot[15].StartReq = (Grp[12].Auto && DI[101]) || (!Grp[12].Auto && DI[102] && DI[168]);
    Mot[15].StopReq = (DI[168] && DI[4]) || !Mot[15].Perm || Mot[15].Fault;
    Mot[15].Run = (Mot[15].StartReq || Mot[15].Run) && !Mot[15].StopReq;
    Mot[15].Fbk = Mot[15].Run && (!DI[28] || Mot[15].Fbk);
    Mot[15].FbkErr = (Mot[15].Run != Mot[15].Fbk) && DI[138];
    Mot[15].Fault = sr(&MotFlt_SR[5], Mot[15].FbkErr && DI[117], DI[129]);
    Mot[15].Ready = Mot[15].Perm && !Mot[15].Fault && !Mot[15].Run;
    Mot[15].Lamp = Mot[15].Run || (Mot[15].Fault && Blink) || (Mot[15].Ready && DI[41] && Blink);

    /* motor M117 */
    Mot[16].Perm = Grp[16].Release && (DI[164] || DI[172]) && (Mot[11].Run || DI[153]);
    Mot[16].StartReq = (Grp[16].Auto && DI[82]) || (!Grp[16].Auto && DI[52] && DI[144]);
    Mot[16].StopReq = (DI[148] && !DI[0]) || !Mot[16].Perm || Mot[16].Fault;
    Mot[16].Run = (Mot[16].StartReq || Mot[16].Run) && !Mot[16].StopReq;
    Mot[16].Fbk = Mot[16].Run && (DI[61] || Mot[16].Fbk);
    Mot[16].FbkErr = (Mot[16].Run != Mot[16].Fbk) && DI[186];
    Mot[16].Fault = rs(&MotFlt_RS[5], Mot[16].FbkErr, DI[162]);
    Mot[16].Ready = Mot[16].Perm && !Mot[16].Fault && !Mot[16].Run;
    Mot[16].Lamp = Mot[16].Run || (Mot[16].Fault && Blink) || (Mot[16].Ready && DI[77] && Blink);

    /* motor M118 */
    Mot[17].Perm = Grp[1].Release && (!DI[165] || DI[251]) && (Mot[4].Run || DI[36]);
    Mot[17].StartReq = (Grp[1].Auto && DI[75]) || (!Grp[1].Auto && DI[64] && !DI[188]);
    Mot[17].StopReq = (DI[185] && !DI[140]) || !Mot[17].Perm || Mot[17].Fault;
    Mot[17].Run = (Mot[17].StartReq || Mot[17].Run) && !Mot[17].StopReq;
    Mot[17].Fbk = Mot[17].Run && (DI[220] || Mot[17].Fbk);
    Mot[17].FbkErr = (Mot[17].Run != Mot[17].Fbk) && DI[56];
    if (Mot[17].FbkErr && DI[79])
        Mot[17].Fault = true;
    else if (DI[64])
        Mot[17].Fault = false;
    Mot[17].Ready = Mot[17].Perm && !Mot[17].Fault && !Mot[17].Run;
    Mot[17].Lamp = Mot[17].Run || (Mot[17].Fault && Blink) || (Mot[17].Ready && DI[12] && Blink);

    /* motor M119 */
    Mot[18].Perm = Grp[7].Release && (DI[17] || DI[242]) && (Mot[13].Run || DI[44]);
    Mot[18].StartReq = (Grp[7].Auto && DI[40]) || (!Grp[7].Auto && DI[100] && DI[242]);
    Mot[18].StopReq = (DI[26] && DI[133]) || !Mot[18].Perm || Mot[18].Fault;
    Mot[18].Run = (Mot[18].StartReq || Mot[18].Run) && !Mot[18].StopReq;
    Mot[18].Fbk = Mot[18].Run && (DI[20] || Mot[18].Fbk);
    Mot[18].FbkErr = (Mot[18].Run != Mot[18].Fbk) && DI[97];
    Mot[18].Fault = sr(&MotFlt_SR[6], Mot[18].FbkErr && DI[189], DI[132]);
    Mot[18].Ready = Mot[18].Perm && !Mot[18].Fault && !Mot[18].Run;
    Mot[18].Lamp = Mot[18].Run || (Mot[18].Fault && Blink) || (Mot[18].Ready && DI[156] && Blink);

    /* motor M120 */
    Mot[19].Perm = Grp[13].Release && (!DI[34] || DI[141]) && (Mot[2].Run || DI[102]);
    Mot[19].StartReq = (Grp[13].Auto && DI[98]) || (!Grp[13].Auto && DI[70] && DI[202]);
    Mot[19].StopReq = (DI[78] && DI[230]) || !Mot[19].Perm || Mot[19].Fault;
    Mot[19].Run = (Mot[19].StartReq || Mot[19].Run) && !Mot[19].StopReq;
    Mot[19].Fbk = Mot[19].Run && (DI[98] || Mot[19].Fbk);
    Mot[19].FbkErr = (Mot[19].Run != Mot[19].Fbk) && DI[17];
    Mot[19].Fault = rs(&MotFlt_RS[6], Mot[19].FbkErr, DI[124]);
    Mot[19].Ready = Mot[19].Perm && !Mot[19].Fault && !Mot[19].Run;
    Mot[19].Lamp = Mot[19].Run || (Mot[19].Fault && Blink) || (Mot[19].Ready && DI[172] && Blink);

    /* motor M121 */
    Mot[20].Perm = Grp[19].Release && (!DI[251] || DI[224]) && (Mot[2].Run || !DI[159]);
    Mot[20].StartReq = (Grp[19].Auto && DI[100]) || (!Grp[19].Auto && DI[75] && DI[193]);
    Mot[20].StopReq = (DI[145] && DI[180]) || !Mot[20].Perm || Mot[20].Fault;
    Mot[20].Run = (Mot[20].StartReq || Mot[20].Run) && !Mot[20].StopReq;
    Mot[20].Fbk = Mot[20].Run && (!DI[58] || Mot[20].Fbk);
    Mot[20].FbkErr = (Mot[20].Run != Mot[20].Fbk) && DI[0];
    if (Mot[20].FbkErr && DI[11])
        Mot[20].Fault = true;
    else if (DI[248])
        Mot[20].Fault = false;
    Mot[20].Ready = Mot[20].Perm && !Mot[20].Fault && !Mot[20].Run;
    Mot[20].Lamp = Mot[20].Run || (Mot[20].Fault && Blink) || (Mot[20].Ready && DI[107] && Blink);

    /* motor M122 */
    Mot[21].Perm = Grp[16].Release && (!DI[23] || DI[196]) && (Mot[15].Run || DI[84]);
    Mot[21].StartReq = (Grp[16].Auto && DI[164]) || (!Grp[16].Auto && DI[148] && !DI[127]);
    Mot[21].StopReq = (DI[103] && !DI[166]) || !Mot[21].Perm || Mot[21].Fault;
    Mot[21].Run = (Mot[21].StartReq || Mot[21].Run) && !Mot[21].StopReq;
    Mot[21].Fbk = Mot[21].Run && (DI[215] || Mot[21].Fbk);
    Mot[21].FbkErr = (Mot[21].Run != Mot[21].Fbk) && DI[155];
    Mot[21].Fault = sr(&MotFlt_SR[7], Mot[21].FbkErr && DI[207], DI[50]);
    Mot[21].Ready = Mot[21].Perm && !Mot[21].Fault && !Mot[21].Run;
    Mot[21].Lamp = Mot[21].Run || (Mot[21].Fault && Blink) || (Mot[21].Ready && DI[220] && Blink);

    /* motor M123 */
    Mot[22].Perm = Grp[24].Release && (DI[109] || !DI[70]) && (Mot[18].Run || DI[144]);
    Mot[22].StartReq = (Grp[24].Auto && DI[143]) || (!Grp[24].Auto && DI[209] && DI[173]);
    Mot[22].StopReq = (DI[249] && DI[40]) || !Mot[22].Perm || Mot[22].Fault;
    Mot[22].Run = (Mot[22].StartReq || Mot[22].Run) && !Mot[22].StopReq;
    Mot[22].Fbk = Mot[22].Run && (DI[74] || Mot[22].Fbk);
    Mot[22].FbkErr = (Mot[22].Run != Mot[22].Fbk) && DI[229];
    Mot[22].Fault = rs(&MotFlt_RS[7], Mot[22].FbkErr, DI[35]);
    Mot[22].Ready = Mot[22].Perm && !Mot[22].Fault && !Mot[22].Run;
    Mot[22].Lamp = Mot[22].Run || (Mot[22].Fault && Blink) || (Mot[22].Ready && DI[60] && Blink);

    /* motor M124 */
    Mot[23].Perm = Grp[5].Release && (!DI[180] || !DI[36]) && (Mot[16].Run || DI[111]);
    Mot[23].StartReq = (Grp[5].Auto && DI[9]) || (!Grp[5].Auto && DI[66] && !DI[120]);
    Mot[23].StopReq = (DI[178] && !DI[184]) || !Mot[23].Perm || Mot[23].Fault;
    Mot[23].Run = (Mot[23].StartReq || Mot[23].Run) && !Mot[23].StopReq;
    Mot[23].Fbk = Mot[23].Run && (!DI[121] || Mot[23].Fbk);
    Mot[23].FbkErr = (Mot[23].Run != Mot[23].Fbk) && DI[57];
    if (Mot[23].FbkErr && DI[166])
        Mot[23].Fault = true;
    else if (DI[62])
        Mot[23].Fault = false;
    Mot[23].Ready = Mot[23].Perm && !Mot[23].Fault && !Mot[23].Run;
    Mot[23].Lamp = Mot[23].Run || (Mot[23].Fault && Blink) || (Mot[23].Ready && DI[211] && Blink);

    /* motor M125 */
    Mot[24].Perm = Grp[10].Release && (DI[127] || DI[26]) && (Mot[15].Run || !DI[101]);
    Mot[24].StartReq = (Grp[10].Auto && DI[63]) || (!Grp[10].Auto && DI[37] && !DI[169]);
    Mot[24].StopReq = (DI[245] && DI[32]) || !Mot[24].Perm || Mot[24].Fault;
    Mot[24].Run = (Mot[24].StartReq || Mot[24].Run) && !Mot[24].StopReq;
    Mot[24].Fbk = Mot[24].Run && (DI[222] || Mot[24].Fbk);
    Mot[24].FbkErr = (Mot[24].Run != Mot[24].Fbk) && DI[157];
    Mot[24].Fault = sr(&MotFlt_SR[8], Mot[24].FbkErr && DI[222], DI[185]);
    Mot[24].Ready = Mot[24].Perm && !Mot[24].Fault && !Mot[24].Run;
    Mot[24].Lamp = Mot[24].Run || (Mot[24].Fault && Blink) || (Mot[24].Ready && DI[44] && Blink);

    /* motor M126 */
    Mot[25].Perm = Grp[15].Release && (!DI[101] || !DI[84]) && (Mot[5].Run || DI[225]);
    Mot[25].StartReq = (Grp[15].Auto && DI[164]) || (!Grp[15].Auto && DI[83] && DI[148]);
    Mot[25].StopReq = (DI[72] && !DI[151]) || !Mot[25].Perm || Mot[25].Fault;
    Mot[25].Run = (Mot[25].StartReq || Mot[25].Run) && !Mot[25].StopReq;
    Mot[25].Fbk = Mot[25].Run && (DI[131] || Mot[25].Fbk);
    Mot[25].FbkErr = (Mot[25].Run != Mot[25].Fbk) && DI[101];
    Mot[25].Fault = rs(&MotFlt_RS[8], Mot[25].FbkErr, DI[62]);
    Mot[25].Ready = Mot[25].Perm && !Mot[25].Fault && !Mot[25].Run;
    Mot[25].Lamp = Mot[25].Run || (Mot[25].Fault && Blink) || (Mot[25].Ready && DI[91] && Blink);

    /* motor M127 */
    Mot[26].Perm = Grp[9].Release && (!DI[69] || !DI[100]) && (Mot[4].Run || !DI[11]);
    Mot[26].StartReq = (Grp[9].Auto && DI[126]) || (!Grp[9].Auto && DI[14] && DI[44]);
    Mot[26].StopReq = (DI[164] && DI[11]) || !Mot[26].Perm || Mot[26].Fault;
    Mot[26].Run = (Mot[26].StartReq || Mot[26].Run) && !Mot[26].StopReq;
    Mot[26].Fbk = Mot[26].Run && (DI[217] || Mot[26].Fbk);
    Mot[26].FbkErr = (Mot[26].Run != Mot[26].Fbk) && DI[140];
    if (Mot[26].FbkErr && DI[216])
        Mot[26].Fault = true;
    else if (DI[110])
        Mot[26].Fault = false;
    Mot[26].Ready = Mot[26].Perm && !Mot[26].Fault && !Mot[26].Run;
    Mot[26].Lamp = Mot[26].Run || (Mot[26].Fault && Blink) || (Mot[26].Ready && DI[101] && Blink);

    /* motor M128 */
    Mot[27].Perm = Grp[16].Release && (DI[226] || !DI[86]) && (Mot[13].Run || !DI[162]);
    Mot[27].StartReq = (Grp[16].Auto && DI[158]) || (!Grp[16].Auto && DI[178] && DI[1]);
    Mot[27].StopReq = (DI[178] && DI[128]) || !Mot[27].Perm || Mot[27].Fault;
    Mot[27].Run = (Mot[27].StartReq || Mot[27].Run) && !Mot[27].StopReq;
    Mot[27].Fbk = Mot[27].Run && (!DI[172] || Mot[27].Fbk);
    Mot[27].FbkErr = (Mot[27].Run != Mot[27].Fbk) && DI[202];
    Mot[27].Fault = sr(&MotFlt_SR[9], Mot[27].FbkErr && DI[151], DI[134]);
    Mot[27].Ready = Mot[27].Perm && !Mot[27].Fault && !Mot[27].Run;
    Mot[27].Lamp = Mot[27].Run || (Mot[27].Fault && Blink) || (Mot[27].Ready && DI[32] && Blink);

    /* motor M129 */
    Mot[28].Perm = Grp[4].Release && (!DI[118] || DI[41]) && (Mot[3].Run || !DI[25]);
    Mot[28].StartReq = (Grp[4].Auto && DI[177]) || (!Grp[4].Auto && DI[212] && DI[210]);
    Mot[28].StopReq = (DI[225] && DI[26]) || !Mot[28].Perm || Mot[28].Fault;
    Mot[28].Run = (Mot[28].StartReq || Mot[28].Run) && !Mot[28].StopReq;
    Mot[28].Fbk = Mot[28].Run && (DI[252] || Mot[28].Fbk);
    Mot[28].FbkErr = (Mot[28].Run != Mot[28].Fbk) && DI[210];
    Mot[28].Fault = rs(&MotFlt_RS[9], Mot[28].FbkErr, DI[198]);
    Mot[28].Ready = Mot[28].Perm && !Mot[28].Fault && !Mot[28].Run;
    Mot[28].Lamp = Mot[28].Run || (Mot[28].Fault && Blink) || (Mot[28].Ready && DI[230] && Blink);

    /* motor M130 */
    Mot[29].Perm = Grp[10].Release && (!DI[59] || !DI[48]) && (Mot[26].Run || !DI[152]);
    Mot[29].StartReq = (Grp[10].Auto && DI[212]) || (!Grp[10].Auto && DI[227] && DI[29]);
    Mot[29].StopReq = (DI[44] && !DI[38]) || !Mot[29].Perm || Mot[29].Fault;
    Mot[29].Run = (Mot[29].StartReq || Mot[29].Run) && !Mot[29].StopReq;
    Mot[29].Fbk = Mot[29].Run && (DI[227] || Mot[29].Fbk);
    Mot[29].FbkErr = (Mot[29].Run != Mot[29].Fbk) && DI[119];
    if (Mot[29].FbkErr && DI[249])
        Mot[29].Fault = true;
    else if (DI[1])
        Mot[29].Fault = false;
    Mot[29].Ready = Mot[29].Perm && !Mot[29].Fault && !Mot[29].Run;
    Mot[29].Lamp = Mot[29].Run || (Mot[29].Fault && Blink) || (Mot[29].Ready && DI[77] && Blink);

    /* motor M131 */
    Mot[30].Perm = Grp[25].Release && (!DI[254] || DI[156]) && (Mot[5].Run || !DI[183]);
    Mot[30].StartReq = (Grp[25].Auto && DI[137]) || (!Grp[25].Auto && DI[253] && !DI[13]);
    Mot[30].StopReq = (DI[134] && DI[143]) || !Mot[30].Perm || Mot[30].Fault;
    Mot[30].Run = (Mot[30].StartReq || Mot[30].Run) && !Mot[30].StopReq;
    Mot[30].Fbk = Mot[30].Run && (DI[9] || Mot[30].Fbk);
    Mot[30].FbkErr = (Mot[30].Run != Mot[30].Fbk) && DI[149];
    Mot[30].Fault = sr(&MotFlt_SR[10], Mot[30].FbkErr && DI[156], DI[182]);
    Mot[30].Ready = Mot[30].Perm && !Mot[30].Fault && !Mot[30].Run;
    Mot[30].Lamp = Mot[30].Run || (Mot[30].Fault && Blink) || (Mot[30].Ready && DI[23] && Blink);

    /* motor M132 */
    Mot[31].Perm = Grp[18].Release && (DI[12] || !DI[56]) && (Mot[11].Run || !DI[181]);
    Mot[31].StartReq = (Grp[18].Auto && DI[72]) || (!Grp[18].Auto && DI[46] && !DI[20]);
    Mot[31].StopReq = (DI[184] && !DI[94]) || !Mot[31].Perm || Mot[31].Fault;
    Mot[31].Run = (Mot[31].StartReq || Mot[31].Run) && !Mot[31].StopReq;
    Mot[31].Fbk = Mot[31].Run && (!DI[221] || Mot[31].Fbk);
    Mot[31].FbkErr = (Mot[31].Run != Mot[31].Fbk) && DI[44];
    Mot[31].Fault = rs(&MotFlt_RS[10], Mot[31].FbkErr, DI[18]);
    Mot[31].Ready = Mot[31].Perm && !Mot[31].Fault && !Mot[31].Run;
    Mot[31].Lamp = Mot[31].Run || (Mot[31].Fault && Blink) || (Mot[31].Ready && DI[122] && Blink);

    /* motor M133 */
    Mot[32].Perm = Grp[25].Release && (DI[200] || DI[189]) && (Mot[11].Run || DI[98]);
    Mot[32].StartReq = (Grp[25].Auto && DI[137]) || (!Grp[25].Auto && DI[117] && DI[42]);
    Mot[32].StopReq = (DI[191] && !DI[169]) || !Mot[32].Perm || Mot[32].Fault;
    Mot[32].Run = (Mot[32].StartReq || Mot[32].Run) && !Mot[32].StopReq;
    Mot[32].Fbk = Mot[32].Run && (DI[174] || Mot[32].Fbk);
    Mot[32].FbkErr = (Mot[32].Run != Mot[32].Fbk) && DI[210];
    if (Mot[32].FbkErr && DI[234])
        Mot[32].Fault = true;
    else if (DI[229])
        Mot[32].Fault = false;
    Mot[32].Ready = Mot[32].Perm && !Mot[32].Fault && !Mot[32].Run;
    Mot[32].Lamp = Mot[32].Run || (Mot[32].Fault && Blink) || (Mot[32].Ready && DI[254] && Blink);

    /* motor M134 */
    Mot[33].Perm = Grp[26].Release && (DI[22] || !DI[245]) && (Mot[31].Run || !DI[16]);
    Mot[33].StartReq = (Grp[26].Auto && DI[166]) || (!Grp[26].Auto && DI[248] && !DI[70]);
    Mot[33].StopReq = (DI[19] && !DI[42]) || !Mot[33].Perm || Mot[33].Fault;
    Mot[33].Run = (Mot[33].StartReq || Mot[33].Run) && !Mot[33].StopReq;
    Mot[33].Fbk = Mot[33].Run && (DI[159] || Mot[33].Fbk);
    Mot[33].FbkErr = (Mot[33].Run != Mot[33].Fbk) && DI[226];
    Mot[33].Fault = sr(&MotFlt_SR[11], Mot[33].FbkErr && DI[76], DI[38]);
    Mot[33].Ready = Mot[33].Perm && !Mot[33].Fault && !Mot[33].Run;
    Mot[33].Lamp = Mot[33].Run || (Mot[33].Fault && Blink) || (Mot[33].Ready && DI[186] && Blink);

    /* motor M135 */
    Mot[34].Perm = Grp[18].Release && (!DI[33] || DI[123]) && (Mot[16].Run || DI[247]);
    Mot[34].StartReq = (Grp[18].Auto && DI[118]) || (!Grp[18].Auto && DI[191] && DI[115]);
    Mot[34].StopReq = (DI[119] && DI[169]) || !Mot[34].Perm || Mot[34].Fault;
    Mot[34].Run = (Mot[34].StartReq || Mot[34].Run) && !Mot[34].StopReq;
    Mot[34].Fbk = Mot[34].Run && (!DI[60] || Mot[34].Fbk);
    Mot[34].FbkErr = (Mot[34].Run != Mot[34].Fbk) && DI[207];
    Mot[34].Fault = rs(&MotFlt_RS[11], Mot[34].FbkErr, DI[26]);
    Mot[34].Ready = Mot[34].Perm && !Mot[34].Fault && !Mot[34].Run;
    Mot[34].Lamp = Mot[34].Run || (Mot[34].Fault && Blink) || (Mot[34].Ready && DI[173] && Blink);

    /* motor M136 */
    Mot[35].Perm = Grp[2].Release && (DI[24] || DI[53]) && (Mot[22].Run || !DI[103]);
    Mot[35].StartReq = (Grp[2].Auto && DI[231]) || (!Grp[2].Auto && DI[23] && DI[26]);
    Mot[35].StopReq = (DI[47] && DI[120]) || !Mot[35].Perm || Mot[35].Fault;
    Mot[35].Run = (Mot[35].StartReq || Mot[35].Run) && !Mot[35].StopReq;
    Mot[35].Fbk = Mot[35].Run && (!DI[116] || Mot[35].Fbk);
    Mot[35].FbkErr = (Mot[35].Run != Mot[35].Fbk) && DI[112];
    if (Mot[35].FbkErr && DI[10])
        Mot[35].Fault = true;
    else if (DI[218])
        Mot[35].Fault = false;
    Mot[35].Ready = Mot[35].Perm && !Mot[35].Fault && !Mot[35].Run;
    Mot[35].Lamp = Mot[35].Run || (Mot[35].Fault && Blink) || (Mot[35].Ready && DI[47] && Blink);

    /* motor M137 */
    Mot[36].Perm = Grp[5].Release && (DI[39] || !DI[210]) && (Mot[34].Run || !DI[121]);
    Mot[36].StartReq = (Grp[5].Auto && DI[171]) || (!Grp[5].Auto && DI[25] && !DI[249]);
    Mot[36].StopReq = (DI[56] && !DI[130]) || !Mot[36].Perm || Mot[36].Fault;
    Mot[36].Run = (Mot[36].StartReq || Mot[36].Run) && !Mot[36].StopReq;
    Mot[36].Fbk = Mot[36].Run && (DI[218] || Mot[36].Fbk);
    Mot[36].FbkErr = (Mot[36].Run != Mot[36].Fbk) && DI[94];
    Mot[36].Fault = sr(&MotFlt_SR[12], Mot[36].FbkErr && DI[35], DI[219]);
    Mot[36].Ready = Mot[36].Perm && !Mot[36].Fault && !Mot[36].Run;
    Mot[36].Lamp = Mot[36].Run || (Mot[36].Fault && Blink) || (Mot[36].Ready && DI[159] && Blink);

    /* motor M138 */
    Mot[37].Perm = Grp[16].Release && (DI[135] || DI[57]) && (Mot[28].Run || !DI[204]);
    Mot[37].StartReq = (Grp[16].Auto && DI[246]) || (!Grp[16].Auto && DI[237] && !DI[250]);
    Mot[37].StopReq = (DI[41] && DI[251]) || !Mot[37].Perm || Mot[37].Fault;
    Mot[37].Run = (Mot[37].StartReq || Mot[37].Run) && !Mot[37].StopReq;
    Mot[37].Fbk = Mot[37].Run && (DI[249] || Mot[37].Fbk);
    Mot[37].FbkErr = (Mot[37].Run != Mot[37].Fbk) && DI[150];
    Mot[37].Fault = rs(&MotFlt_RS[12], Mot[37].FbkErr, DI[109]);
    Mot[37].Ready = Mot[37].Perm && !Mot[37].Fault && !Mot[37].Run;
    Mot[37].Lamp = Mot[37].Run || (Mot[37].Fault && Blink) || (Mot[37].Ready && DI[64] && Blink);

    /* motor M139 */
    Mot[38].Perm = Grp[15].Release && (!DI[48] || !DI[79]) && (Mot[34].Run || DI[180]);
    Mot[38].StartReq = (Grp[15].Auto && DI[164]) || (!Grp[15].Auto && DI[221] && !DI[203]);
    Mot[38].StopReq = (DI[162] && DI[15]) || !Mot[38].Perm || Mot[38].Fault;
    Mot[38].Run = (Mot[38].StartReq || Mot[38].Run) && !Mot[38].StopReq;
    Mot[38].Fbk = Mot[38].Run && (!DI[183] || Mot[38].Fbk);
    Mot[38].FbkErr = (Mot[38].Run != Mot[38].Fbk) && DI[23];
    if (Mot[38].FbkErr && DI[17])
        Mot[38].Fault = true;
    else if (DI[112])
        Mot[38].Fault = false;
    Mot[38].Ready = Mot[38].Perm && !Mot[38].Fault && !Mot[38].Run;
    Mot[38].Lamp = Mot[38].Run || (Mot[38].Fault && Blink) || (Mot[38].Ready && DI[118] && Blink);

    /* motor M140 */
    Mot[39].Perm = Grp[20].Release && (DI[96] || DI[223]) && (Mot[13].Run || DI[85]);
    Mot[39].StartReq = (Grp[20].Auto && DI[240]) || (!Grp[20].Auto && DI[186] && !DI[139]);
    Mot[39].StopReq = (DI[43] && DI[91]) || !Mot[39].Perm || Mot[39].Fault;
    Mot[39].Run = (Mot[39].StartReq || Mot[39].Run) && !Mot[39].StopReq;
    Mot[39].Fbk = Mot[39].Run && (DI[49] || Mot[39].Fbk);
    Mot[39].FbkErr = (Mot[39].Run != Mot[39].Fbk) && DI[217];
    Mot[39].Fault = sr(&MotFlt_SR[13], Mot[39].FbkErr && DI[210], DI[194]);
    Mot[39].Ready = Mot[39].Perm && !Mot[39].Fault && !Mot[39].Run;
    Mot[39].Lamp = Mot[39].Run || (Mot[39].Fault && Blink) || (Mot[39].Ready && DI[212] && Blink);

    /* motor M141 */
    Mot[40].Perm = Grp[23].Release && (!DI[162] || !DI[149]) && (Mot[21].Run || !DI[53]);
    Mot[40].StartReq = (Grp[23].Auto && DI[170]) || (!Grp[23].Auto && DI[68] && !DI[168]);
    Mot[40].StopReq = (DI[37] && !DI[36]) || !Mot[40].Perm || Mot[40].Fault;
    Mot[40].Run = (Mot[40].StartReq || Mot[40].Run) && !Mot[40].StopReq;
    Mot[40].Fbk = Mot[40].Run && (DI[227] || Mot[40].Fbk);
    Mot[40].FbkErr = (Mot[40].Run != Mot[40].Fbk) && DI[225];
    Mot[40].Fault = rs(&MotFlt_RS[13], Mot[40].FbkErr, DI[230]);
    Mot[40].Ready = Mot[40].Perm && !Mot[40].Fault && !Mot[40].Run;
    Mot[40].Lamp = Mot[40].Run || (Mot[40].Fault && Blink) || (Mot[40].Ready && DI[154] && Blink);

    /* motor M142 */
    Mot[41].Perm = Grp[2].Release && (!DI[205] || DI[163]) && (Mot[32].Run || !DI[58]);
    Mot[41].StartReq = (Grp[2].Auto && DI[81]) || (!Grp[2].Auto && DI[215] && !DI[132]);
    Mot[41].StopReq = (DI[104] && DI[192]) || !Mot[41].Perm || Mot[41].Fault;
    Mot[41].Run = (Mot[41].StartReq || Mot[41].Run) && !Mot[41].StopReq;
    Mot[41].Fbk = Mot[41].Run && (DI[199] || Mot[41].Fbk);
    Mot[41].FbkErr = (Mot[41].Run != Mot[41].Fbk) && DI[195];
    if (Mot[41].FbkErr && DI[78])
        Mot[41].Fault = true;
    else if (DI[99])
        Mot[41].Fault = false;
    Mot[41].Ready = Mot[41].Perm && !Mot[41].Fault && !Mot[41].Run;
    Mot[41].Lamp = Mot[41].Run || (Mot[41].Fault && Blink) || (Mot[41].Ready && DI[149] && Blink);

    /* motor M143 */
    Mot[42].Perm = Grp[13].Release && (!DI[35] || DI[171]) && (Mot[16].Run || DI[202]);
    Mot[42].StartReq = (Grp[13].Auto && DI[40]) || (!Grp[13].Auto && DI[6] && !DI[253]);
    Mot[42].StopReq = (DI[229] && DI[12]) || !Mot[42].Perm || Mot[42].Fault;
    Mot[42].Run = (Mot[42].StartReq || Mot[42].Run) && !Mot[42].StopReq;
    Mot[42].Fbk = Mot[42].Run && (!DI[169] || Mot[42].Fbk);
    Mot[42].FbkErr = (Mot[42].Run != Mot[42].Fbk) && DI[241];
    Mot[42].Fault = sr(&MotFlt_SR[14], Mot[42].FbkErr && DI[227], DI[209]);
    Mot[42].Ready = Mot[42].Perm && !Mot[42].Fault && !Mot[42].Run;
    Mot[42].Lamp = Mot[42].Run || (Mot[42].Fault && Blink) || (Mot[42].Ready && DI[43] && Blink);

    /* motor M144 */
    Mot[43].Perm = Grp[29].Release && (!DI[139] || DI[157]) && (Mot[26].Run || DI[15]);
    Mot[43].StartReq = (Grp[29].Auto && DI[111]) || (!Grp[29].Auto && DI[24] && DI[242]);
    Mot[43].StopReq = (DI[134] && !DI[208]) || !Mot[43].Perm || Mot[43].Fault;
    Mot[43].Run = (Mot[43].StartReq || Mot[43].Run) && !Mot[43].StopReq;
    Mot[43].Fbk = Mot[43].Run && (!DI[69] || Mot[43].Fbk);
    Mot[43].FbkErr = (Mot[43].Run != Mot[43].Fbk) && DI[210];
    Mot[43].Fault = rs(&MotFlt_RS[14], Mot[43].FbkErr, DI[170]);
    Mot[43].Ready = Mot[43].Perm && !Mot[43].Fault && !Mot[43].Run;
    Mot[43].Lamp = Mot[43].Run || (Mot[43].Fault && Blink) || (Mot[43].Ready && DI[191] && Blink);

    /* motor M145 */
    Mot[44].Perm = Grp[19].Release && (!DI[26] || DI[104]) && (Mot[41].Run || !DI[118]);
    Mot[44].StartReq = (Grp[19].Auto && DI[66]) || (!Grp[19].Auto && DI[249] && DI[166]);
    Mot[44].StopReq = (DI[231] && DI[240]) || !Mot[44].Perm || Mot[44].Fault;
    Mot[44].Run = (Mot[44].StartReq || Mot[44].Run) && !Mot[44].StopReq;
    Mot[44].Fbk = Mot[44].Run && (!DI[141] || Mot[44].Fbk);
    Mot[44].FbkErr = (Mot[44].Run != Mot[44].Fbk) && DI[182];
    if (Mot[44].FbkErr && DI[44])
        Mot[44].Fault = true;
    else if (DI[8])
        Mot[44].Fault = false;
    Mot[44].Ready = Mot[44].Perm && !Mot[44].Fault && !Mot[44].Run;
    Mot[44].Lamp = Mot[44].Run || (Mot[44].Fault && Blink) || (Mot[44].Ready && DI[173] && Blink);

    /* motor M146 */
    Mot[45].Perm = Grp[22].Release && (DI[105] || DI[79]) && (Mot[36].Run || DI[151]);
    Mot[45].StartReq = (Grp[22].Auto && DI[22]) || (!Grp[22].Auto && DI[208] && !DI[61]);
    Mot[45].StopReq = (DI[34] && DI[254]) || !Mot[45].Perm || Mot[45].Fault;
    Mot[45].Run = (Mot[45].StartReq || Mot[45].Run) && !Mot[45].StopReq;
    Mot[45].Fbk = Mot[45].Run && (!DI[160] || Mot[45].Fbk);
    Mot[45].FbkErr = (Mot[45].Run != Mot[45].Fbk) && DI[252];
    Mot[45].Fault = sr(&MotFlt_SR[15], Mot[45].FbkErr && DI[52], DI[65]);
    Mot[45].Ready = Mot[45].Perm && !Mot[45].Fault && !Mot[45].Run;
    Mot[45].Lamp = Mot[45].Run || (Mot[45].Fault && Blink) || (Mot[45].Ready && DI[42] && Blink);

    /* motor M147 */
    Mot[46].Perm = Grp[14].Release && (DI[15] || DI[222]) && (Mot[1].Run || !DI[192]);
    Mot[46].StartReq = (Grp[14].Auto && DI[30]) || (!Grp[14].Auto && DI[238] && DI[163]);
    Mot[46].StopReq = (DI[24] && DI[134]) || !Mot[46].Perm || Mot[46].Fault;
    Mot[46].Run = (Mot[46].StartReq || Mot[46].Run) && !Mot[46].StopReq;
    Mot[46].Fbk = Mot[46].Run && (DI[241] || Mot[46].Fbk);
    Mot[46].FbkErr = (Mot[46].Run != Mot[46].Fbk) && DI[23];
    Mot[46].Fault = rs(&MotFlt_RS[15], Mot[46].FbkErr, DI[253]);
    Mot[46].Ready = Mot[46].Perm && !Mot[46].Fault && !Mot[46].Run;
    Mot[46].Lamp = Mot[46].Run || (Mot[46].Fault && Blink) || (Mot[46].Ready && DI[193] && Blink);

    /* motor M148 */
    Mot[47].Perm = Grp[28].Release && (DI[98] || !DI[244]) && (Mot[0].Run || !DI[79]);
    Mot[47].StartReq = (Grp[28].Auto && DI[51]) || (!Grp[28].Auto && DI[71] && DI[108]);
    Mot[47].StopReq = (DI[50] && DI[31]) || !Mot[47].Perm || Mot[47].Fault;
    Mot[47].Run = (Mot[47].StartReq || Mot[47].Run) && !Mot[47].StopReq;
    Mot[47].Fbk = Mot[47].Run && (DI[195] || Mot[47].Fbk);
    Mot[47].FbkErr = (Mot[47].Run != Mot[47].Fbk) && DI[49];
    if (Mot[47].FbkErr && DI[4])
        Mot[47].Fault = true;
    else if (DI[217])
        Mot[47].Fault = false;
    Mot[47].Ready = Mot[47].Perm && !Mot[47].Fault && !Mot[47].Run;
    Mot[47].Lamp = Mot[47].Run || (Mot[47].Fault && Blink) || (Mot[47].Ready && DI[55] && Blink);

    /* motor M149 */
    Mot[48].Perm = Grp[0].Release && (DI[87] || !DI[15]) && (Mot[24].Run || !DI[192]);
    Mot[48].StartReq = (Grp[0].Auto && DI[204]) || (!Grp[0].Auto && DI[40] && DI[12]);
    Mot[48].StopReq = (DI[179] && DI[100]) || !Mot[48].Perm || Mot[48].Fault;
    Mot[48].Run = (Mot[48].StartReq || Mot[48].Run) && !Mot[48].StopReq;
    Mot[48].Fbk = Mot[48].Run && (DI[86] || Mot[48].Fbk);
    Mot[48].FbkErr = (Mot[48].Run != Mot[48].Fbk) && DI[1];
    Mot[48].Fault = sr(&MotFlt_SR[16], Mot[48].FbkErr && DI[59], DI[65]);
    Mot[48].Ready = Mot[48].Perm && !Mot[48].Fault && !Mot[48].Run;
    Mot[48].Lamp = Mot[48].Run || (Mot[48].Fault && Blink) || (Mot[48].Ready && DI[93] && Blink);

    /* motor M150 */
    Mot[49].Perm = Grp[27].Release && (!DI[63] || DI[16]) && (Mot[16].Run || DI[71]);
    Mot[49].StartReq = (Grp[27].Auto && DI[255]) || (!Grp[27].Auto && DI[91] && DI[77]);
    Mot[49].StopReq = (DI[102] && !DI[136]) || !Mot[49].Perm || Mot[49].Fault;
    Mot[49].Run = (Mot[49].StartReq || Mot[49].Run) && !Mot[49].StopReq;
    Mot[49].Fbk = Mot[49].Run && (!DI[196] || Mot[49].Fbk);
    Mot[49].FbkErr = (Mot[49].Run != Mot[49].Fbk) && DI[244];
    Mot[49].Fault = rs(&MotFlt_RS[16], Mot[49].FbkErr, DI[82]);
    Mot[49].Ready = Mot[49].Perm && !Mot[49].Fault && !Mot[49].Run;
    Mot[49].Lamp = Mot[49].Run || (Mot[49].Fault && Blink) || (Mot[49].Ready && DI[126] && Blink);

    /* motor M151 */
    Mot[50].Perm = Grp[5].Release && (DI[31] || !DI[127]) && (Mot[20].Run || DI[121]);
    Mot[50].StartReq = (Grp[5].Auto && DI[118]) || (!Grp[5].Auto && DI[192] && DI[23]);
    Mot[50].StopReq = (DI[240] && DI[119]) || !Mot[50].Perm || Mot[50].Fault;
    Mot[50].Run = (Mot[50].StartReq || Mot[50].Run) && !Mot[50].StopReq;
    Mot[50].Fbk = Mot[50].Run && (!DI[240] || Mot[50].Fbk);
    Mot[50].FbkErr = (Mot[50].Run != Mot[50].Fbk) && DI[214];
    if (Mot[50].FbkErr && DI[53])
        Mot[50].Fault = true;
    else if (DI[4])
        Mot[50].Fault = false;
    Mot[50].Ready = Mot[50].Perm && !Mot[50].Fault && !Mot[50].Run;
    Mot[50].Lamp = Mot[50].Run || (Mot[50].Fault && Blink) || (Mot[50].Ready && DI[154] && Blink);

    /* motor M152 */
    Mot[51].Perm = Grp[18].Release && (DI[243] || !DI[62]) && (Mot[11].Run || DI[220]);
    Mot[51].StartReq = (Grp[18].Auto && DI[142]) || (!Grp[18].Auto && DI[229] && DI[180]);
    Mot[51].StopReq = (DI[221] && DI[216]) || !Mot[51].Perm || Mot[51].Fault;
    Mot[51].Run = (Mot[51].StartReq || Mot[51].Run) && !Mot[51].StopReq;
    Mot[51].Fbk = Mot[51].Run && (DI[217] || Mot[51].Fbk);
    Mot[51].FbkErr = (Mot[51].Run != Mot[51].Fbk) && DI[182];
    Mot[51].Fault = sr(&MotFlt_SR[17], Mot[51].FbkErr && DI[212], DI[234]);
    Mot[51].Ready = Mot[51].Perm && !Mot[51].Fault && !Mot[51].Run;
    Mot[51].Lamp = Mot[51].Run || (Mot[51].Fault && Blink) || (Mot[51].Ready && DI[252] && Blink);

    /* motor M153 */
    Mot[52].Perm = Grp[3].Release && (!DI[48] || DI[150]) && (Mot[16].Run || !DI[56]);
    Mot[52].StartReq = (Grp[3].Auto && DI[104]) || (!Grp[3].Auto && DI[100] && DI[12]);
    Mot[52].StopReq = (DI[69] && DI[214]) || !Mot[52].Perm || Mot[52].Fault;
    Mot[52].Run = (Mot[52].StartReq || Mot[52].Run) && !Mot[52].StopReq;
    Mot[52].Fbk = Mot[52].Run && (!DI[102] || Mot[52].Fbk);
    Mot[52].FbkErr = (Mot[52].Run != Mot[52].Fbk) && DI[139];
    Mot[52].Fault = rs(&MotFlt_RS[17], Mot[52].FbkErr, DI[123]);
    Mot[52].Ready = Mot[52].Perm && !Mot[52].Fault && !Mot[52].Run;
    Mot[52].Lamp = Mot[52].Run || (Mot[52].Fault && Blink) || (Mot[52].Ready && DI[145] && Blink);

    /* motor M154 */
    Mot[53].Perm = Grp[10].Release && (!DI[214] || !DI[52]) && (Mot[4].Run || !DI[206]);
    Mot[53].StartReq = (Grp[10].Auto && DI[40]) || (!Grp[10].Auto && DI[247] && !DI[218]);
    Mot[53].StopReq = (DI[115] && DI[71]) || !Mot[53].Perm || Mot[53].Fault;
    Mot[53].Run = (Mot[53].StartReq || Mot[53].Run) && !Mot[53].StopReq;
    Mot[53].Fbk = Mot[53].Run && (!DI[55] || Mot[53].Fbk);
    Mot[53].FbkErr = (Mot[53].Run != Mot[53].Fbk) && DI[171];
    if (Mot[53].FbkErr && DI[52])
        Mot[53].Fault = true;
    else if (DI[202])
        Mot[53].Fault = false;
    Mot[53].Ready = Mot[53].Perm && !Mot[53].Fault && !Mot[53].Run;
    Mot[53].Lamp = Mot[53].Run || (Mot[53].Fault && Blink) || (Mot[53].Ready && DI[3] && Blink);

    /* motor M155 */
    Mot[54].Perm = Grp[11].Release && (DI[59] || DI[98]) && (Mot[37].Run || !DI[225]);
    Mot[54].StartReq = (Grp[11].Auto && DI[105]) || (!Grp[11].Auto && DI[71] && DI[67]);
    Mot[54].StopReq = (DI[66] && DI[101]) || !Mot[54].Perm || Mot[54].Fault;
    Mot[54].Run = (Mot[54].StartReq || Mot[54].Run) && !Mot[54].StopReq;
    Mot[54].Fbk = Mot[54].Run && (DI[175] || Mot[54].Fbk);
    Mot[54].FbkErr = (Mot[54].Run != Mot[54].Fbk) && DI[160];
    Mot[54].Fault = sr(&MotFlt_SR[18], Mot[54].FbkErr && DI[95], DI[30]);
    Mot[54].Ready = Mot[54].Perm && !Mot[54].Fault && !Mot[54].Run;
    Mot[54].Lamp = Mot[54].Run || (Mot[54].Fault && Blink) || (Mot[54].Ready && DI[16] && Blink);

    /* motor M156 */
    Mot[55].Perm = Grp[18].Release && (DI[207] || DI[166]) && (Mot[43].Run || DI[35]);
    Mot[55].StartReq = (Grp[18].Auto && DI[240]) || (!Grp[18].Auto && DI[203] && DI[59]);
    Mot[55].StopReq = (DI[29] && DI[229]) || !Mot[55].Perm || Mot[55].Fault;
    Mot[55].Run = (Mot[55].StartReq || Mot[55].Run) && !Mot[55].StopReq;
    Mot[55].Fbk = Mot[55].Run && (DI[48] || Mot[55].Fbk);
    Mot[55].FbkErr = (Mot[55].Run != Mot[55].Fbk) && DI[180];
    Mot[55].Fault = rs(&MotFlt_RS[18], Mot[55].FbkErr, DI[148]);
    Mot[55].Ready = Mot[55].Perm && !Mot[55].Fault && !Mot[55].Run;
    Mot[55].Lamp = Mot[55].Run || (Mot[55].Fault && Blink) || (Mot[55].Ready && DI[195] && Blink);

    /* motor M157 */
    Mot[56].Perm = Grp[6].Release && (DI[171] || DI[102]) && (Mot[1].Run || DI[227]);
    Mot[56].StartReq = (Grp[6].Auto && DI[16]) || (!Grp[6].Auto && DI[99] && !DI[202]);
    Mot[56].StopReq = (DI[17] && !DI[57]) || !Mot[56].Perm || Mot[56].Fault;
    Mot[56].Run = (Mot[56].StartReq || Mot[56].Run) && !Mot[56].StopReq;
    Mot[56].Fbk = Mot[56].Run && (DI[89] || Mot[56].Fbk);
    Mot[56].FbkErr = (Mot[56].Run != Mot[56].Fbk) && DI[143];
    if (Mot[56].FbkErr && DI[157])
        Mot[56].Fault = true;
    else if (DI[2])
        Mot[56].Fault = false;
    Mot[56].Ready = Mot[56].Perm && !Mot[56].Fault && !Mot[56].Run;
    Mot[56].Lamp = Mot[56].Run || (Mot[56].Fault && Blink) || (Mot[56].Ready && DI[221] && Blink);

    /* motor M158 */
    Mot[57].Perm = Grp[14].Release && (DI[2] || DI[230]) && (Mot[37].Run || DI[246]);
    Mot[57].StartReq = (Grp[14].Auto && DI[213]) || (!Grp[14].Auto && DI[226] && !DI[20]);
    Mot[57].StopReq = (DI[119] && !DI[26]) || !Mot[57].Perm || Mot[57].Fault;
    Mot[57].Run = (Mot[57].StartReq || Mot[57].Run) && !Mot[57].StopReq;
    Mot[57].Fbk = Mot[57].Run && (DI[84] || Mot[57].Fbk);
    Mot[57].FbkErr = (Mot[57].Run != Mot[57].Fbk) && DI[210];
    Mot[57].Fault = sr(&MotFlt_SR[19], Mot[57].FbkErr && DI[29], DI[242]);
    Mot[57].Ready = Mot[57].Perm && !Mot[57].Fault && !Mot[57].Run;
    Mot[57].Lamp = Mot[57].Run || (Mot[57].Fault && Blink) || (Mot[57].Ready && DI[39] && Blink);

    /* motor M159 */
    Mot[58].Perm = Grp[19].Release && (!DI[88] || !DI[31]) && (Mot[9].Run || !DI[213]);
    Mot[58].StartReq = (Grp[19].Auto && DI[177]) || (!Grp[19].Auto && DI[214] && DI[34]);
    Mot[58].StopReq = (DI[201] && DI[143]) || !Mot[58].Perm || Mot[58].Fault;
    Mot[58].Run = (Mot[58].StartReq || Mot[58].Run) && !Mot[58].StopReq;
    Mot[58].Fbk = Mot[58].Run && (DI[12] || Mot[58].Fbk);
    Mot[58].FbkErr = (Mot[58].Run != Mot[58].Fbk) && DI[160];
    Mot[58].Fault = rs(&MotFlt_RS[19], Mot[58].FbkErr, DI[40]);
    Mot[58].Ready = Mot[58].Perm && !Mot[58].Fault && !Mot[58].Run;
    Mot[58].Lamp = Mot[58].Run || (Mot[58].Fault && Blink) || (Mot[58].Ready && DI[6] && Blink);

    /* motor M160 */
    Mot[59].Perm = Grp[3].Release && (DI[191] || DI[159]) && (Mot[55].Run || DI[158]);
    Mot[59].StartReq = (Grp[3].Auto && DI[83]) || (!Grp[3].Auto && DI[100] && DI[4]);
    Mot[59].StopReq = (DI[13] && DI[190]) || !Mot[59].Perm || Mot[59].Fault;
    Mot[59].Run = (Mot[59].StartReq || Mot[59].Run) && !Mot[59].StopReq;
    Mot[59].Fbk = Mot[59].Run && (DI[90] || Mot[59].Fbk);
    Mot[59].FbkErr = (Mot[59].Run != Mot[59].Fbk) && DI[26];
    if (Mot[59].FbkErr && DI[220])
        Mot[59].Fault = true;
    else if (DI[250])
        Mot[59].Fault = false;
    Mot[59].Ready = Mot[59].Perm && !Mot[59].Fault && !Mot[59].Run;
    Mot[59].Lamp = Mot[59].Run || (Mot[59].Fault && Blink) || (Mot[59].Ready && DI[34] && Blink);

    /* motor M161 */
    Mot[60].Perm = Grp[6].Release && (DI[185] || DI[165]) && (Mot[42].Run || DI[12]);
    Mot[60].StartReq = (Grp[6].Auto && DI[171]) || (!Grp[6].Auto && DI[128] && !DI[26]);
    Mot[60].StopReq = (DI[78] && DI[254]) || !Mot[60].Perm || Mot[60].Fault;
    Mot[60].Run = (Mot[60].StartReq || Mot[60].Run) && !Mot[60].StopReq;
    Mot[60].Fbk = Mot[60].Run && (DI[191] || Mot[60].Fbk);
    Mot[60].FbkErr = (Mot[60].Run != Mot[60].Fbk) && DI[5];
    Mot[60].Fault = sr(&MotFlt_SR[20], Mot[60].FbkErr && DI[122], DI[203]);
    Mot[60].Ready = Mot[60].Perm && !Mot[60].Fault && !Mot[60].Run;
    Mot[60].Lamp = Mot[60].Run || (Mot[60].Fault && Blink) || (Mot[60].Ready && DI[139] && Blink);

    /* motor M162 */
    Mot[61].Perm = Grp[3].Release && (DI[16] || DI[235]) && (Mot[27].Run || !DI[79]);
    Mot[61].StartReq = (Grp[3].Auto && DI[137]) || (!Grp[3].Auto && DI[235] && DI[61]);
    Mot[61].StopReq = (DI[217] && DI[2]) || !Mot[61].Perm || Mot[61].Fault;
    Mot[61].Run = (Mot[61].StartReq || Mot[61].Run) && !Mot[61].StopReq;
    Mot[61].Fbk = Mot[61].Run && (DI[147] || Mot[61].Fbk);
    Mot[61].FbkErr = (Mot[61].Run != Mot[61].Fbk) && DI[144];
    Mot[61].Fault = rs(&MotFlt_RS[20], Mot[61].FbkErr, DI[223]);
    Mot[61].Ready = Mot[61].Perm && !Mot[61].Fault && !Mot[61].Run;
    Mot[61].Lamp = Mot[61].Run || (Mot[61].Fault && Blink) || (Mot[61].Ready && DI[247] && Blink);

    /* motor M163 */
    Mot[62].Perm = Grp[17].Release && (DI[80] || !DI[83]) && (Mot[9].Run || DI[159]);
    Mot[62].StartReq = (Grp[17].Auto && DI[42]) || (!Grp[17].Auto && DI[1] && !DI[237]);
    Mot[62].StopReq = (DI[56] && DI[159]) || !Mot[62].Perm || Mot[62].Fault;
    Mot[62].Run = (Mot[62].StartReq || Mot[62].Run) && !Mot[62].StopReq;
    Mot[62].Fbk = Mot[62].Run && (DI[6] || Mot[62].Fbk);
    Mot[62].FbkErr = (Mot[62].Run != Mot[62].Fbk) && DI[87];
    if (Mot[62].FbkErr && DI[243])
        Mot[62].Fault = true;
    else if (DI[231])
        Mot[62].Fault = false;
    Mot[62].Ready = Mot[62].Perm && !Mot[62].Fault && !Mot[62].Run;
    Mot[62].Lamp = Mot[62].Run || (Mot[62].Fault && Blink) || (Mot[62].Ready && DI[213] && Blink);

    /* motor M164 */
    Mot[63].Perm = Grp[2].Release && (!DI[183] || DI[40]) && (Mot[22].Run || DI[254]);
    Mot[63].StartReq = (Grp[2].Auto && DI[141]) || (!Grp[2].Auto && DI[232] && DI[80]);
    Mot[63].StopReq = (DI[90] && DI[164]) || !Mot[63].Perm || Mot[63].Fault;
    Mot[63].Run = (Mot[63].StartReq || Mot[63].Run) && !Mot[63].StopReq;
    Mot[63].Fbk = Mot[63].Run && (DI[178] || Mot[63].Fbk);
    Mot[63].FbkErr = (Mot[63].Run != Mot[63].Fbk) && DI[219];
    Mot[63].Fault = sr(&MotFlt_SR[21], Mot[63].FbkErr && DI[247], DI[92]);
    Mot[63].Ready = Mot[63].Perm && !Mot[63].Fault && !Mot[63].Run;
    Mot[63].Lamp = Mot[63].Run || (Mot[63].Fault && Blink) || (Mot[63].Ready && DI[238] && Blink);

    /* motor M165 */
    Mot[64].Perm = Grp[25].Release && (DI[96] || DI[7]) && (Mot[38].Run || !DI[18]);
    Mot[64].StartReq = (Grp[25].Auto && DI[26]) || (!Grp[25].Auto && DI[202] && DI[148]);
    Mot[64].StopReq = (DI[238] && DI[134]) || !Mot[64].Perm || Mot[64].Fault;
    Mot[64].Run = (Mot[64].StartReq || Mot[64].Run) && !Mot[64].StopReq;
    Mot[64].Fbk = Mot[64].Run && (DI[2] || Mot[64].Fbk);
    Mot[64].FbkErr = (Mot[64].Run != Mot[64].Fbk) && DI[202];
    Mot[64].Fault = rs(&MotFlt_RS[21], Mot[64].FbkErr, DI[78]);
    Mot[64].Ready = Mot[64].Perm && !Mot[64].Fault && !Mot[64].Run;
    Mot[64].Lamp = Mot[64].Run || (Mot[64].Fault && Blink) || (Mot[64].Ready && DI[171] && Blink);

    /* motor M166 */
    Mot[65].Perm = Grp[16].Release && (!DI[166] || DI[23]) && (Mot[64].Run || !DI[18]);
    Mot[65].StartReq = (Grp[16].Auto && DI[250]) || (!Grp[16].Auto && DI[219] && !DI[141]);
    Mot[65].StopReq = (DI[165] && DI[80]) || !Mot[65].Perm || Mot[65].Fault;
    Mot[65].Run = (Mot[65].StartReq || Mot[65].Run) && !Mot[65].StopReq;
    Mot[65].Fbk = Mot[65].Run && (!DI[71] || Mot[65].Fbk);
    Mot[65].FbkErr = (Mot[65].Run != Mot[65].Fbk) && DI[43];
    if (Mot[65].FbkErr && DI[104])
        Mot[65].Fault = true;
    else if (DI[206])
        Mot[65].Fault = false;
    Mot[65].Ready = Mot[65].Perm && !Mot[65].Fault && !Mot[65].Run;
    Mot[65].Lamp = Mot[65].Run || (Mot[65].Fault && Blink) || (Mot[65].Ready && DI[115] && Blink);

    /* motor M167 */
    Mot[66].Perm = Grp[26].Release && (DI[206] || DI[122]) && (Mot[28].Run || DI[58]);
    Mot[66].StartReq = (Grp[26].Auto && DI[141]) || (!Grp[26].Auto && DI[231] && !DI[105]);
    Mot[66].StopReq = (DI[235] && !DI[54]) || !Mot[66].Perm || Mot[66].Fault;
    Mot[66].Run = (Mot[66].StartReq || Mot[66].Run) && !Mot[66].StopReq;
    Mot[66].Fbk = Mot[66].Run && (!DI[55] || Mot[66].Fbk);
    Mot[66].FbkErr = (Mot[66].Run != Mot[66].Fbk) && DI[148];
    Mot[66].Fault = sr(&MotFlt_SR[22], Mot[66].FbkErr && DI[83], DI[121]);
    Mot[66].Ready = Mot[66].Perm && !Mot[66].Fault && !Mot[66].Run;
    Mot[66].Lamp = Mot[66].Run || (Mot[66].Fault && Blink) || (Mot[66].Ready && DI[215] && Blink);

    /* motor M168 */
    Mot[67].Perm = Grp[7].Release && (DI[3] || !DI[27]) && (Mot[36].Run || !DI[165]);
    Mot[67].StartReq = (Grp[7].Auto && DI[173]) || (!Grp[7].Auto && DI[210] && !DI[139]);
    Mot[67].StopReq = (DI[164] && !DI[60]) || !Mot[67].Perm || Mot[67].Fault;
    Mot[67].Run = (Mot[67].StartReq || Mot[67].Run) && !Mot[67].StopReq;
    Mot[67].Fbk = Mot[67].Run && (DI[63] || Mot[67].Fbk);
    Mot[67].FbkErr = (Mot[67].Run != Mot[67].Fbk) && DI[3];
    Mot[67].Fault = rs(&MotFlt_RS[22], Mot[67].FbkErr, DI[199]);
    Mot[67].Ready = Mot[67].Perm && !Mot[67].Fault && !Mot[67].Run;
    Mot[67].Lamp = Mot[67].Run || (Mot[67].Fault && Blink) || (Mot[67].Ready && DI[1] && Blink);

    /* motor M169 */
    Mot[68].Perm = Grp[7].Release && (DI[77] || DI[229]) && (Mot[34].Run || !DI[97]);
    Mot[68].StartReq = (Grp[7].Auto && DI[250]) || (!Grp[7].Auto && DI[178] && DI[231]);
    Mot[68].StopReq = (DI[146] && DI[121]) || !Mot[68].Perm || Mot[68].Fault;
    Mot[68].Run = (Mot[68].StartReq || Mot[68].Run) && !Mot[68].StopReq;
    Mot[68].Fbk = Mot[68].Run && (!DI[84] || Mot[68].Fbk);
    Mot[68].FbkErr = (Mot[68].Run != Mot[68].Fbk) && DI[43];
    if (Mot[68].FbkErr && DI[77])
        Mot[68].Fault = true;
    else if (DI[137])
        Mot[68].Fault = false;
    Mot[68].Ready = Mot[68].Perm && !Mot[68].Fault && !Mot[68].Run;
    Mot[68].Lamp = Mot[68].Run || (Mot[68].Fault && Blink) || (Mot[68].Ready && DI[129] && Blink);

    /* motor M170 */
    Mot[69].Perm = Grp[25].Release && (!DI[242] || !DI[159]) && (Mot[50].Run || DI[252]);
    Mot[69].StartReq = (Grp[25].Auto && DI[13]) || (!Grp[25].Auto && DI[204] && !DI[11]);
    Mot[69].StopReq = (DI[213] && DI[10]) || !Mot[69].Perm || Mot[69].Fault;
    Mot[69].Run = (Mot[69].StartReq || Mot[69].Run) && !Mot[69].StopReq;
    Mot[69].Fbk = Mot[69].Run && (DI[161] || Mot[69].Fbk);
    Mot[69].FbkErr = (Mot[69].Run != Mot[69].Fbk) && DI[133];
    Mot[69].Fault = sr(&MotFlt_SR[23], Mot[69].FbkErr && DI[208], DI[18]);
    Mot[69].Ready = Mot[69].Perm && !Mot[69].Fault && !Mot[69].Run;
    Mot[69].Lamp = Mot[69].Run || (Mot[69].Fault && Blink) || (Mot[69].Ready && DI[165] && Blink);

    /* motor M171 */
    Mot[70].Perm = Grp[20].Release && (DI[192] || !DI[101]) && (Mot[16].Run || DI[59]);
    Mot[70].StartReq = (Grp[20].Auto && DI[166]) || (!Grp[20].Auto && DI[140] && !DI[26]);
    Mot[70].StopReq = (DI[51] && DI[40]) || !Mot[70].Perm || Mot[70].Fault;
    Mot[70].Run = (Mot[70].StartReq || Mot[70].Run) && !Mot[70].StopReq;
    Mot[70].Fbk = Mot[70].Run && (DI[97] || Mot[70].Fbk);
    Mot[70].FbkErr = (Mot[70].Run != Mot[70].Fbk) && DI[148];
    Mot[70].Fault = rs(&MotFlt_RS[23], Mot[70].FbkErr, DI[174]);
    Mot[70].Ready = Mot[70].Perm && !Mot[70].Fault && !Mot[70].Run;
    Mot[70].Lamp = Mot[70].Run || (Mot[70].Fault && Blink) || (Mot[70].Ready && DI[193] && Blink);

    /* motor M172 */
    Mot[71].Perm = Grp[18].Release && (!DI[12] || DI[65]) && (Mot[68].Run || !DI[235]);
    Mot[71].StartReq = (Grp[18].Auto && DI[165]) || (!Grp[18].Auto && DI[2] && !DI[95]);
    Mot[71].StopReq = (DI[238] && !DI[129]) || !Mot[71].Perm || Mot[71].Fault;
    Mot[71].Run = (Mot[71].StartReq || Mot[71].Run) && !Mot[71].StopReq;
    Mot[71].Fbk = Mot[71].Run && (DI[200] || Mot[71].Fbk);
    Mot[71].FbkErr = (Mot[71].Run != Mot[71].Fbk) && DI[62];
    if (Mot[71].FbkErr && DI[121])
        Mot[71].Fault = true;
    else if (DI[1])
        Mot[71].Fault = false;
    Mot[71].Ready = Mot[71].Perm && !Mot[71].Fault && !Mot[71].Run;
    Mot[71].Lamp = Mot[71].Run || (Mot[71].Fault && Blink) || (Mot[71].Ready && DI[50] && Blink);

    /* motor M173 */
    Mot[72].Perm = Grp[2].Release && (!DI[240] || DI[32]) && (Mot[67].Run || DI[52]);
    Mot[72].StartReq = (Grp[2].Auto && DI[165]) || (!Grp[2].Auto && DI[106] && DI[109]);
    Mot[72].StopReq = (DI[127] && DI[77]) || !Mot[72].Perm || Mot[72].Fault;
    Mot[72].Run = (Mot[72].StartReq || Mot[72].Run) && !Mot[72].StopReq;
    Mot[72].Fbk = Mot[72].Run && (!DI[164] || Mot[72].Fbk);
    Mot[72].FbkErr = (Mot[72].Run != Mot[72].Fbk) && DI[150];
    Mot[72].Fault = sr(&MotFlt_SR[24], Mot[72].FbkErr && DI[183], DI[45]);
    Mot[72].Ready = Mot[72].Perm && !Mot[72].Fault && !Mot[72].Run;
    Mot[72].Lamp = Mot[72].Run || (Mot[72].Fault && Blink) || (Mot[72].Ready && DI[17] && Blink);

    /* motor M174 */
    Mot[73].Perm = Grp[10].Release && (!DI[188] || !DI[96]) && (Mot[35].Run || DI[183]);
    Mot[73].StartReq = (Grp[10].Auto && DI[58]) || (!Grp[10].Auto && DI[115] && !DI[41]);
    Mot[73].StopReq = (DI[52] && DI[252]) || !Mot[73].Perm || Mot[73].Fault;
    Mot[73].Run = (Mot[73].StartReq || Mot[73].Run) && !Mot[73].StopReq;
    Mot[73].Fbk = Mot[73].Run && (DI[119] || Mot[73].Fbk);
    Mot[73].FbkErr = (Mot[73].Run != Mot[73].Fbk) && DI[186];
    Mot[73].Fault = rs(&MotFlt_RS[24], Mot[73].FbkErr, DI[252]);
    Mot[73].Ready = Mot[73].Perm && !Mot[73].Fault && !Mot[73].Run;
    Mot[73].Lamp = Mot[73].Run || (Mot[73].Fault && Blink) || (Mot[73].Ready && DI[0] && Blink);

    /* motor M175 */
    Mot[74].Perm = Grp[13].Release && (DI[165] || DI[26]) && (Mot[15].Run || DI[249]);
    Mot[74].StartReq = (Grp[13].Auto && DI[82]) || (!Grp[13].Auto && DI[86] && DI[201]);
    Mot[74].StopReq = (DI[213] && DI[127]) || !Mot[74].Perm || Mot[74].Fault;
    Mot[74].Run = (Mot[74].StartReq || Mot[74].Run) && !Mot[74].StopReq;
    Mot[74].Fbk = Mot[74].Run && (!DI[183] || Mot[74].Fbk);
    Mot[74].FbkErr = (Mot[74].Run != Mot[74].Fbk) && DI[154];
    if (Mot[74].FbkErr && DI[180])
        Mot[74].Fault = true;
    else if (DI[161])
        Mot[74].Fault = false;
    Mot[74].Ready = Mot[74].Perm && !Mot[74].Fault && !Mot[74].Run;
    Mot[74].Lamp = Mot[74].Run || (Mot[74].Fault && Blink) || (Mot[74].Ready && DI[172] && Blink);

    /* motor M176 */
    Mot[75].Perm = Grp[23].Release && (DI[242] || DI[188]) && (Mot[29].Run || DI[209]);
    Mot[75].StartReq = (Grp[23].Auto && DI[148]) || (!Grp[23].Auto && DI[123] && DI[21]);
    Mot[75].StopReq = (DI[171] && DI[93]) || !Mot[75].Perm || Mot[75].Fault;
    Mot[75].Run = (Mot[75].StartReq || Mot[75].Run) && !Mot[75].StopReq;
    Mot[75].Fbk = Mot[75].Run && (DI[242] || Mot[75].Fbk);
    Mot[75].FbkErr = (Mot[75].Run != Mot[75].Fbk) && DI[185];
    Mot[75].Fault = sr(&MotFlt_SR[25], Mot[75].FbkErr && DI[240], DI[191]);
    Mot[75].Ready = Mot[75].Perm && !Mot[75].Fault && !Mot[75].Run;
    Mot[75].Lamp = Mot[75].Run || (Mot[75].Fault && Blink) || (Mot[75].Ready && DI[180] && Blink);

    /* motor M177 */
    Mot[76].Perm = Grp[24].Release && (DI[188] || DI[159]) && (Mot[7].Run || DI[216]);
    Mot[76].StartReq = (Grp[24].Auto && DI[155]) || (!Grp[24].Auto && DI[234] && DI[187]);
    Mot[76].StopReq = (DI[138] && !DI[117]) || !Mot[76].Perm || Mot[76].Fault;
    Mot[76].Run = (Mot[76].StartReq || Mot[76].Run) && !Mot[76].StopReq;
    Mot[76].Fbk = Mot[76].Run && (DI[86] || Mot[76].Fbk);
    Mot[76].FbkErr = (Mot[76].Run != Mot[76].Fbk) && DI[33];
    Mot[76].Fault = rs(&MotFlt_RS[25], Mot[76].FbkErr, DI[114]);
    Mot[76].Ready = Mot[76].Perm && !Mot[76].Fault && !Mot[76].Run;
    Mot[76].Lamp = Mot[76].Run || (Mot[76].Fault && Blink) || (Mot[76].Ready && DI[113] && Blink);

    /* motor M178 */
    Mot[77].Perm = Grp[13].Release && (DI[159] || DI[46]) && (Mot[62].Run || DI[135]);
    Mot[77].StartReq = (Grp[13].Auto && DI[111]) || (!Grp[13].Auto && DI[131] && DI[20]);
    Mot[77].StopReq = (DI[89] && DI[69]) || !Mot[77].Perm || Mot[77].Fault;
    Mot[77].Run = (Mot[77].StartReq || Mot[77].Run) && !Mot[77].StopReq;
    Mot[77].Fbk = Mot[77].Run && (!DI[187] || Mot[77].Fbk);
    Mot[77].FbkErr = (Mot[77].Run != Mot[77].Fbk) && DI[231];
    if (Mot[77].FbkErr && DI[130])
        Mot[77].Fault = true;
    else if (DI[84])
        Mot[77].Fault = false;
    Mot[77].Ready = Mot[77].Perm && !Mot[77].Fault && !Mot[77].Run;
    Mot[77].Lamp = Mot[77].Run || (Mot[77].Fault && Blink) || (Mot[77].Ready && DI[12] && Blink);

    /* motor M179 */
    Mot[78].Perm = Grp[27].Release && (DI[191] || DI[185]) && (Mot[55].Run || !DI[208]);
    Mot[78].StartReq = (Grp[27].Auto && DI[5]) || (!Grp[27].Auto && DI[163] && DI[201]);
    Mot[78].StopReq = (DI[220] && DI[20]) || !Mot[78].Perm || Mot[78].Fault;
    Mot[78].Run = (Mot[78].StartReq || Mot[78].Run) && !Mot[78].StopReq;
    Mot[78].Fbk = Mot[78].Run && (DI[115] || Mot[78].Fbk);
    Mot[78].FbkErr = (Mot[78].Run != Mot[78].Fbk) && DI[247];
    Mot[78].Fault = sr(&MotFlt_SR[26], Mot[78].FbkErr && DI[117], DI[33]);
    Mot[78].Ready = Mot[78].Perm && !Mot[78].Fault && !Mot[78].Run;
    Mot[78].Lamp = Mot[78].Run || (Mot[78].Fault && Blink) || (Mot[78].Ready && DI[94] && Blink);

    /* motor M180 */
    Mot[79].Perm = Grp[29].Release && (!DI[14] || !DI[253]) && (Mot[24].Run || DI[201]);
    Mot[79].StartReq = (Grp[29].Auto && DI[37]) || (!Grp[29].Auto && DI[195] && DI[185]);
    Mot[79].StopReq = (DI[105] && DI[27]) || !Mot[79].Perm || Mot[79].Fault;
    Mot[79].Run = (Mot[79].StartReq || Mot[79].Run) && !Mot[79].StopReq;
    Mot[79].Fbk = Mot[79].Run && (DI[45] || Mot[79].Fbk);
    Mot[79].FbkErr = (Mot[79].Run != Mot[79].Fbk) && DI[201];
    Mot[79].Fault = rs(&MotFlt_RS[26], Mot[79].FbkErr, DI[120]);
    Mot[79].Ready = Mot[79].Perm && !Mot[79].Fault && !Mot[79].Run;
    Mot[79].Lamp = Mot[79].Run || (Mot[79].Fault && Blink) || (Mot[79].Ready && DI[124] && Blink);

    /* motor M181 */
    Mot[80].Perm = Grp[9].Release && (DI[162] || DI[3]) && (Mot[55].Run || DI[23]);
    Mot[80].StartReq = (Grp[9].Auto && DI[127]) || (!Grp[9].Auto && DI[40] && DI[9]);
    Mot[80].StopReq = (DI[74] && !DI[34]) || !Mot[80].Perm || Mot[80].Fault;
    Mot[80].Run = (Mot[80].StartReq || Mot[80].Run) && !Mot[80].StopReq;
    Mot[80].Fbk = Mot[80].Run && (DI[210] || Mot[80].Fbk);
    Mot[80].FbkErr = (Mot[80].Run != Mot[80].Fbk) && DI[70];
    if (Mot[80].FbkErr && DI[23])
        Mot[80].Fault = true;
    else if (DI[145])
        Mot[80].Fault = false;
    Mot[80].Ready = Mot[80].Perm && !Mot[80].Fault && !Mot[80].Run;
    Mot[80].Lamp = Mot[80].Run || (Mot[80].Fault && Blink) || (Mot[80].Ready && DI[53] && Blink);

    /* motor M182 */
    Mot[81].Perm = Grp[0].Release && (DI[66] || DI[44]) && (Mot[72].Run || DI[173]);
    Mot[81].StartReq = (Grp[0].Auto && DI[51]) || (!Grp[0].Auto && DI[16] && DI[126]);
    Mot[81].StopReq = (DI[38] && DI[161]) || !Mot[81].Perm || Mot[81].Fault;
    Mot[81].Run = (Mot[81].StartReq || Mot[81].Run) && !Mot[81].StopReq;
    Mot[81].Fbk = Mot[81].Run && (DI[193] || Mot[81].Fbk);
    Mot[81].FbkErr = (Mot[81].Run != Mot[81].Fbk) && DI[76];
    Mot[81].Fault = sr(&MotFlt_SR[27], Mot[81].FbkErr && DI[218], DI[145]);
    Mot[81].Ready = Mot[81].Perm && !Mot[81].Fault && !Mot[81].Run;
    Mot[81].Lamp = Mot[81].Run || (Mot[81].Fault && Blink) || (Mot[81].Ready && DI[75] && Blink);

    /* motor M183 */
    Mot[82].Perm = Grp[24].Release && (!DI[96] || DI[248]) && (Mot[13].Run || !DI[6]);
    Mot[82].StartReq = (Grp[24].Auto && DI[90]) || (!Grp[24].Auto && DI[177] && DI[196]);
    Mot[82].StopReq = (DI[129] && DI[231]) || !Mot[82].Perm || Mot[82].Fault;
    Mot[82].Run = (Mot[82].StartReq || Mot[82].Run) && !Mot[82].StopReq;
    Mot[82].Fbk = Mot[82].Run && (DI[98] || Mot[82].Fbk);
    Mot[82].FbkErr = (Mot[82].Run != Mot[82].Fbk) && DI[83];
    Mot[82].Fault = rs(&MotFlt_RS[27], Mot[82].FbkErr, DI[148]);
    Mot[82].Ready = Mot[82].Perm && !Mot[82].Fault && !Mot[82].Run;
    Mot[82].Lamp = Mot[82].Run || (Mot[82].Fault && Blink) || (Mot[82].Ready && DI[196] && Blink);

    /* motor M184 */
    Mot[83].Perm = Grp[9].Release && (DI[128] || DI[120]) && (Mot[2].Run || DI[217]);
    Mot[83].StartReq = (Grp[9].Auto && DI[183]) || (!Grp[9].Auto && DI[128] && DI[77]);
    Mot[83].StopReq = (DI[210] && DI[119]) || !Mot[83].Perm || Mot[83].Fault;
    Mot[83].Run = (Mot[83].StartReq || Mot[83].Run) && !Mot[83].StopReq;
    Mot[83].Fbk = Mot[83].Run && (!DI[89] || Mot[83].Fbk);
    Mot[83].FbkErr = (Mot[83].Run != Mot[83].Fbk) && DI[154];
    if (Mot[83].FbkErr && DI[41])
        Mot[83].Fault = true;
    else if (DI[18])
        Mot[83].Fault = false;
    Mot[83].Ready = Mot[83].Perm && !Mot[83].Fault && !Mot[83].Run;
    Mot[83].Lamp = Mot[83].Run || (Mot[83].Fault && Blink) || (Mot[83].Ready && DI[211] && Blink);

    /* motor M185 */
    Mot[84].Perm = Grp[29].Release && (!DI[237] || !DI[175]) && (Mot[52].Run || DI[130]);
    Mot[84].StartReq = (Grp[29].Auto && DI[140]) || (!Grp[29].Auto && DI[189] && !DI[6]);
    Mot[84].StopReq = (DI[202] && !DI[35]) || !Mot[84].Perm || Mot[84].Fault;
    Mot[84].Run = (Mot[84].StartReq || Mot[84].Run) && !Mot[84].StopReq;
    Mot[84].Fbk = Mot[84].Run && (DI[62] || Mot[84].Fbk);
    Mot[84].FbkErr = (Mot[84].Run != Mot[84].Fbk) && DI[233];
    Mot[84].Fault = sr(&MotFlt_SR[28], Mot[84].FbkErr && DI[54], DI[118]);
    Mot[84].Ready = Mot[84].Perm && !Mot[84].Fault && !Mot[84].Run;
    Mot[84].Lamp = Mot[84].Run || (Mot[84].Fault && Blink) || (Mot[84].Ready && DI[199] && Blink);

    /* motor M186 */
    Mot[85].Perm = Grp[5].Release && (DI[181] || DI[31]) && (Mot[18].Run || !DI[95]);
    Mot[85].StartReq = (Grp[5].Auto && DI[38]) || (!Grp[5].Auto && DI[143] && !DI[143]);
    Mot[85].StopReq = (DI[74] && !DI[158]) || !Mot[85].Perm || Mot[85].Fault;
    Mot[85].Run = (Mot[85].StartReq || Mot[85].Run) && !Mot[85].StopReq;
    Mot[85].Fbk = Mot[85].Run && (DI[190] || Mot[85].Fbk);
    Mot[85].FbkErr = (Mot[85].Run != Mot[85].Fbk) && DI[198];
    Mot[85].Fault = rs(&MotFlt_RS[28], Mot[85].FbkErr, DI[148]);
    Mot[85].Ready = Mot[85].Perm && !Mot[85].Fault && !Mot[85].Run;
    Mot[85].Lamp = Mot[85].Run || (Mot[85].Fault && Blink) || (Mot[85].Ready && DI[9] && Blink);

    /* motor M187 */
    Mot[86].Perm = Grp[23].Release && (!DI[171] || DI[6]) && (Mot[48].Run || !DI[58]);
    Mot[86].StartReq = (Grp[23].Auto && DI[137]) || (!Grp[23].Auto && DI[168] && DI[66]);
    Mot[86].StopReq = (DI[139] && DI[243]) || !Mot[86].Perm || Mot[86].Fault;
    Mot[86].Run = (Mot[86].StartReq || Mot[86].Run) && !Mot[86].StopReq;
    Mot[86].Fbk = Mot[86].Run && (DI[209] || Mot[86].Fbk);
    Mot[86].FbkErr = (Mot[86].Run != Mot[86].Fbk) && DI[134];
    if (Mot[86].FbkErr && DI[185])
        Mot[86].Fault = true;
    else if (DI[151])
        Mot[86].Fault = false;
    Mot[86].Ready = Mot[86].Perm && !Mot[86].Fault && !Mot[86].Run;
    Mot[86].Lamp = Mot[86].Run || (Mot[86].Fault && Blink) || (Mot[86].Ready && DI[103] && Blink);

    /* motor M188 */
    Mot[87].Perm = Grp[18].Release && (!DI[4] || DI[58]) && (Mot[17].Run || DI[226]);
    Mot[87].StartReq = (Grp[18].Auto && DI[107]) || (!Grp[18].Auto && DI[101] && !DI[133]);
    Mot[87].StopReq = (DI[219] && DI[171]) || !Mot[87].Perm || Mot[87].Fault;
    Mot[87].Run = (Mot[87].StartReq || Mot[87].Run) && !Mot[87].StopReq;
    Mot[87].Fbk = Mot[87].Run && (!DI[70] || Mot[87].Fbk);
    Mot[87].FbkErr = (Mot[87].Run != Mot[87].Fbk) && DI[81];
    Mot[87].Fault = sr(&MotFlt_SR[29], Mot[87].FbkErr && DI[109], DI[23]);
    Mot[87].Ready = Mot[87].Perm && !Mot[87].Fault && !Mot[87].Run;
    Mot[87].Lamp = Mot[87].Run || (Mot[87].Fault && Blink) || (Mot[87].Ready && DI[45] && Blink);

    /* motor M189 */
    Mot[88].Perm = Grp[19].Release && (DI[74] || DI[14]) && (Mot[2].Run || DI[217]);
    Mot[88].StartReq = (Grp[19].Auto && DI[233]) || (!Grp[19].Auto && DI[87] && DI[44]);
    Mot[88].StopReq = (DI[179] && !DI[46]) || !Mot[88].Perm || Mot[88].Fault;
    Mot[88].Run = (Mot[88].StartReq || Mot[88].Run) && !Mot[88].StopReq;
    Mot[88].Fbk = Mot[88].Run && (DI[28] || Mot[88].Fbk);
    Mot[88].FbkErr = (Mot[88].Run != Mot[88].Fbk) && DI[131];
    Mot[88].Fault = rs(&MotFlt_RS[29], Mot[88].FbkErr, DI[255]);
    Mot[88].Ready = Mot[88].Perm && !Mot[88].Fault && !Mot[88].Run;
    Mot[88].Lamp = Mot[88].Run || (Mot[88].Fault && Blink) || (Mot[88].Ready && DI[66] && Blink);

    /* motor M190 */
    Mot[89].Perm = Grp[21].Release && (DI[234] || !DI[211]) && (Mot[37].Run || DI[160]);
    Mot[89].StartReq = (Grp[21].Auto && DI[175]) || (!Grp[21].Auto && DI[37] && !DI[29]);
    Mot[89].StopReq = (DI[89] && DI[166]) || !Mot[89].Perm || Mot[89].Fault;
    Mot[89].Run = (Mot[89].StartReq || Mot[89].Run) && !Mot[89].StopReq;
    Mot[89].Fbk = Mot[89].Run && (!DI[96] || Mot[89].Fbk);
    Mot[89].FbkErr = (Mot[89].Run != Mot[89].Fbk) && DI[100];
    if (Mot[89].FbkErr && DI[24])
        Mot[89].Fault = true;
    else if (DI[214])
        Mot[89].Fault = false;
    Mot[89].Ready = Mot[89].Perm && !Mot[89].Fault && !Mot[89].Run;
    Mot[89].Lamp = Mot[89].Run || (Mot[89].Fault && Blink) || (Mot[89].Ready && DI[100] && Blink);

    /* motor M191 */
    Mot[90].Perm = Grp[19].Release && (DI[93] || !DI[149]) && (Mot[6].Run || !DI[245]);
    Mot[90].StartReq = (Grp[19].Auto && DI[85]) || (!Grp[19].Auto && DI[102] && DI[200]);
    Mot[90].StopReq = (DI[168] && !DI[29]) || !Mot[90].Perm || Mot[90].Fault;
    Mot[90].Run = (Mot[90].StartReq || Mot[90].Run) && !Mot[90].StopReq;
    Mot[90].Fbk = Mot[90].Run && (!DI[200] || Mot[90].Fbk);
    Mot[90].FbkErr = (Mot[90].Run != Mot[90].Fbk) && DI[232];
    Mot[90].Fault = sr(&MotFlt_SR[30], Mot[90].FbkErr && DI[181], DI[14]);
    Mot[90].Ready = Mot[90].Perm && !Mot[90].Fault && !Mot[90].Run;
    Mot[90].Lamp = Mot[90].Run || (Mot[90].Fault && Blink) || (Mot[90].Ready && DI[68] && Blink);

    /* motor M192 */
    Mot[91].Perm = Grp[16].Release && (DI[85] || !DI[38]) && (Mot[52].Run || !DI[203]);
    Mot[91].StartReq = (Grp[16].Auto && DI[202]) || (!Grp[16].Auto && DI[29] && DI[51]);
    Mot[91].StopReq = (DI[158] && DI[88]) || !Mot[91].Perm || Mot[91].Fault;
    Mot[91].Run = (Mot[91].StartReq || Mot[91].Run) && !Mot[91].StopReq;
    Mot[91].Fbk = Mot[91].Run && (!DI[80] || Mot[91].Fbk);
    Mot[91].FbkErr = (Mot[91].Run != Mot[91].Fbk) && DI[244];
    Mot[91].Fault = rs(&MotFlt_RS[30], Mot[91].FbkErr, DI[12]);
    Mot[91].Ready = Mot[91].Perm && !Mot[91].Fault && !Mot[91].Run;
    Mot[91].Lamp = Mot[91].Run || (Mot[91].Fault && Blink) || (Mot[91].Ready && DI[242] && Blink);

    /* motor M193 */
    Mot[92].Perm = Grp[5].Release && (!DI[210] || !DI[71]) && (Mot[73].Run || !DI[239]);
    Mot[92].StartReq = (Grp[5].Auto && DI[183]) || (!Grp[5].Auto && DI[142] && DI[150]);
    Mot[92].StopReq = (DI[23] && DI[218]) || !Mot[92].Perm || Mot[92].Fault;
    Mot[92].Run = (Mot[92].StartReq || Mot[92].Run) && !Mot[92].StopReq;
    Mot[92].Fbk = Mot[92].Run && (DI[61] || Mot[92].Fbk);
    Mot[92].FbkErr = (Mot[92].Run != Mot[92].Fbk) && DI[6];
    if (Mot[92].FbkErr && DI[108])
        Mot[92].Fault = true;
    else if (DI[221])
        Mot[92].Fault = false;
    Mot[92].Ready = Mot[92].Perm && !Mot[92].Fault && !Mot[92].Run;
    Mot[92].Lamp = Mot[92].Run || (Mot[92].Fault && Blink) || (Mot[92].Ready && DI[16] && Blink);

    /* motor M194 */
    Mot[93].Perm = Grp[8].Release && (DI[43] || DI[144]) && (Mot[13].Run || DI[149]);
    Mot[93].StartReq = (Grp[8].Auto && DI[212]) || (!Grp[8].Auto && DI[185] && DI[18]);
    Mot[93].StopReq = (DI[48] && !DI[130]) || !Mot[93].Perm || Mot[93].Fault;
    Mot[93].Run = (Mot[93].StartReq || Mot[93].Run) && !Mot[93].StopReq;
    Mot[93].Fbk = Mot[93].Run && (!DI[32] || Mot[93].Fbk);
    Mot[93].FbkErr = (Mot[93].Run != Mot[93].Fbk) && DI[202];
    Mot[93].Fault = sr(&MotFlt_SR[31], Mot[93].FbkErr && DI[7], DI[176]);
    Mot[93].Ready = Mot[93].Perm && !Mot[93].Fault && !Mot[93].Run;
    Mot[93].Lamp = Mot[93].Run || (Mot[93].Fault && Blink) || (Mot[93].Ready && DI[52] && Blink);

    /* motor M195 */
    Mot[94].Perm = Grp[15].Release && (DI[117] || DI[163]) && (Mot[39].Run || DI[236]);
    Mot[94].StartReq = (Grp[15].Auto && DI[152]) || (!Grp[15].Auto && DI[195] && DI[176]);
    Mot[94].StopReq = (DI[222] && DI[32]) || !Mot[94].Perm || Mot[94].Fault;
    Mot[94].Run = (Mot[94].StartReq || Mot[94].Run) && !Mot[94].StopReq;
    Mot[94].Fbk = Mot[94].Run && (DI[169] || Mot[94].Fbk);
    Mot[94].FbkErr = (Mot[94].Run != Mot[94].Fbk) && DI[42];
    Mot[94].Fault = rs(&MotFlt_RS[31], Mot[94].FbkErr, DI[214]);
    Mot[94].Ready = Mot[94].Perm && !Mot[94].Fault && !Mot[94].Run;
    Mot[94].Lamp = Mot[94].Run || (Mot[94].Fault && Blink) || (Mot[94].Ready && DI[61] && Blink);

    /* motor M196 */
    Mot[95].Perm = Grp[15].Release && (DI[143] || !DI[105]) && (Mot[32].Run || !DI[3]);
    Mot[95].StartReq = (Grp[15].Auto && DI[25]) || (!Grp[15].Auto && DI[43] && DI[41]);
    Mot[95].StopReq = (DI[18] && DI[166]) || !Mot[95].Perm || Mot[95].Fault;
    Mot[95].Run = (Mot[95].StartReq || Mot[95].Run) && !Mot[95].StopReq;
    Mot[95].Fbk = Mot[95].Run && (DI[8] || Mot[95].Fbk);
    Mot[95].FbkErr = (Mot[95].Run != Mot[95].Fbk) && DI[169];
    if (Mot[95].FbkErr && DI[27])
        Mot[95].Fault = true;
    else if (DI[230])
        Mot[95].Fault = false;
    Mot[95].Ready = Mot[95].Perm && !Mot[95].Fault && !Mot[95].Run;
    Mot[95].Lamp = Mot[95].Run || (Mot[95].Fault && Blink) || (Mot[95].Ready && DI[96] && Blink);

    /* motor M197 */
    Mot[96].Perm = Grp[5].Release && (!DI[10] || DI[118]) && (Mot[69].Run || DI[185]);
    Mot[96].StartReq = (Grp[5].Auto && DI[238]) || (!Grp[5].Auto && DI[107] && !DI[7]);
    Mot[96].StopReq = (DI[197] && !DI[209]) || !Mot[96].Perm || Mot[96].Fault;
    Mot[96].Run = (Mot[96].StartReq || Mot[96].Run) && !Mot[96].StopReq;
    Mot[96].Fbk = Mot[96].Run && (!DI[12] || Mot[96].Fbk);
    Mot[96].FbkErr = (Mot[96].Run != Mot[96].Fbk) && DI[62];
    Mot[96].Fault = sr(&MotFlt_SR[32], Mot[96].FbkErr && DI[237], DI[109]);
    Mot[96].Ready = Mot[96].Perm && !Mot[96].Fault && !Mot[96].Run;
    Mot[96].Lamp = Mot[96].Run || (Mot[96].Fault && Blink) || (Mot[96].Ready && DI[45] && Blink);

    /* motor M198 */
    Mot[97].Perm = Grp[12].Release && (!DI[86] || !DI[24]) && (Mot[69].Run || DI[183]);
    Mot[97].StartReq = (Grp[12].Auto && DI[99]) || (!Grp[12].Auto && DI[130] && DI[186]);
    Mot[97].StopReq = (DI[174] && DI[178]) || !Mot[97].Perm || Mot[97].Fault;
    Mot[97].Run = (Mot[97].StartReq || Mot[97].Run) && !Mot[97].StopReq;
    Mot[97].Fbk = Mot[97].Run && (!DI[185] || Mot[97].Fbk);
    Mot[97].FbkErr = (Mot[97].Run != Mot[97].Fbk) && DI[157];
    Mot[97].Fault = rs(&MotFlt_RS[32], Mot[97].FbkErr, DI[129]);
    Mot[97].Ready = Mot[97].Perm && !Mot[97].Fault && !Mot[97].Run;
    Mot[97].Lamp = Mot[97].Run || (Mot[97].Fault && Blink) || (Mot[97].Ready && DI[46] && Blink);

    /* motor M199 */
    Mot[98].Perm = Grp[21].Release && (DI[190] || !DI[181]) && (Mot[6].Run || !DI[253]);
    Mot[98].StartReq = (Grp[21].Auto && DI[99]) || (!Grp[21].Auto && DI[251] && DI[137]);
    Mot[98].StopReq = (DI[184] && !DI[48]) || !Mot[98].Perm || Mot[98].Fault;
    Mot[98].Run = (Mot[98].StartReq || Mot[98].Run) && !Mot[98].StopReq;
    Mot[98].Fbk = Mot[98].Run && (!DI[111] || Mot[98].Fbk);
    Mot[98].FbkErr = (Mot[98].Run != Mot[98].Fbk) && DI[103];
    if (Mot[98].FbkErr && DI[132])
        Mot[98].Fault = true;
    else if (DI[33])
        Mot[98].Fault = false;
    Mot[98].Ready = Mot[98].Perm && !Mot[98].Fault && !Mot[98].Run;
    Mot[98].Lamp = Mot[98].Run || (Mot[98].Fault && Blink) || (Mot[98].Ready && DI[237] && Blink);

    /* motor M200 */
    Mot[99].Perm = Grp[27].Release && (DI[169] || !DI[61]) && (Mot[88].Run || DI[225]);
    Mot[99].StartReq = (Grp[27].Auto && DI[110]) || (!Grp[27].Auto && DI[151] && DI[65]);
    Mot[99].StopReq = (DI[62] && DI[48]) || !Mot[99].Perm || Mot[99].Fault;
    Mot[99].Run = (Mot[99].StartReq || Mot[99].Run) && !Mot[99].StopReq;
    Mot[99].Fbk = Mot[99].Run && (!DI[187] || Mot[99].Fbk);
    Mot[99].FbkErr = (Mot[99].Run != Mot[99].Fbk) && DI[221];
    Mot[99].Fault = sr(&MotFlt_SR[33], Mot[99].FbkErr && DI[247], DI[102]);
    Mot[99].Ready = Mot[99].Perm && !Mot[99].Fault && !Mot[99].Run;
    Mot[99].Lamp = Mot[99].Run || (Mot[99].Fault && Blink) || (Mot[99].Ready && DI[225] && Blink);

    /* motor M201 */
    Mot[100].Perm = Grp[29].Release && (!DI[139] || DI[191]) && (Mot[91].Run || DI[53]);
    Mot[100].StartReq = (Grp[29].Auto && DI[236]) || (!Grp[29].Auto && DI[84] && DI[42]);
    Mot[100].StopReq = (DI[7] && DI[195]) || !Mot[100].Perm || Mot[100].Fault;
    Mot[100].Run = (Mot[100].StartReq || Mot[100].Run) && !Mot[100].StopReq;
    Mot[100].Fbk = Mot[100].Run && (DI[159] || Mot[100].Fbk);
    Mot[100].FbkErr = (Mot[100].Run != Mot[100].Fbk) && DI[246];
    Mot[100].Fault = rs(&MotFlt_RS[33], Mot[100].FbkErr, DI[210]);
    Mot[100].Ready = Mot[100].Perm && !Mot[100].Fault && !Mot[100].Run;
    Mot[100].Lamp = Mot[100].Run || (Mot[100].Fault && Blink) || (Mot[100].Ready && DI[243] && Blink);

    /* motor M202 */
    Mot[101].Perm = Grp[4].Release && (DI[155] || !DI[124]) && (Mot[8].Run || !DI[93]);
    Mot[101].StartReq = (Grp[4].Auto && DI[10]) || (!Grp[4].Auto && DI[73] && DI[79]);
    Mot[101].StopReq = (DI[135] && !DI[160]) || !Mot[101].Perm || Mot[101].Fault;
    Mot[101].Run = (Mot[101].StartReq || Mot[101].Run) && !Mot[101].StopReq;
    Mot[101].Fbk = Mot[101].Run && (!DI[193] || Mot[101].Fbk);
    Mot[101].FbkErr = (Mot[101].Run != Mot[101].Fbk) && DI[235];
    if (Mot[101].FbkErr && DI[218])
        Mot[101].Fault = true;
    else if (DI[10])
        Mot[101].Fault = false;
    Mot[101].Ready = Mot[101].Perm && !Mot[101].Fault && !Mot[101].Run;
    Mot[101].Lamp = Mot[101].Run || (Mot[101].Fault && Blink) || (Mot[101].Ready && DI[149] && Blink);

    /* motor M203 */
    Mot[102].Perm = Grp[15].Release && (!DI[92] || !DI[240]) && (Mot[89].Run || DI[29]);
    Mot[102].StartReq = (Grp[15].Auto && DI[124]) || (!Grp[15].Auto && DI[65] && DI[159]);
    Mot[102].StopReq = (DI[74] && !DI[213]) || !Mot[102].Perm || Mot[102].Fault;
    Mot[102].Run = (Mot[102].StartReq || Mot[102].Run) && !Mot[102].StopReq;
    Mot[102].Fbk = Mot[102].Run && (DI[249] || Mot[102].Fbk);
    Mot[102].FbkErr = (Mot[102].Run != Mot[102].Fbk) && DI[172];
    Mot[102].Fault = sr(&MotFlt_SR[34], Mot[102].FbkErr && DI[42], DI[13]);
    Mot[102].Ready = Mot[102].Perm && !Mot[102].Fault && !Mot[102].Run;
    Mot[102].Lamp = Mot[102].Run || (Mot[102].Fault && Blink) || (Mot[102].Ready && DI[53] && Blink);

    /* motor M204 */
    Mot[103].Perm = Grp[22].Release && (!DI[89] || DI[174]) && (Mot[20].Run || DI[179]);
    Mot[103].StartReq = (Grp[22].Auto && DI[19]) || (!Grp[22].Auto && DI[234] && DI[43]);
    Mot[103].StopReq = (DI[104] && DI[211]) || !Mot[103].Perm || Mot[103].Fault;
    Mot[103].Run = (Mot[103].StartReq || Mot[103].Run) && !Mot[103].StopReq;
    Mot[103].Fbk = Mot[103].Run && (DI[184] || Mot[103].Fbk);
    Mot[103].FbkErr = (Mot[103].Run != Mot[103].Fbk) && DI[243];
    Mot[103].Fault = rs(&MotFlt_RS[34], Mot[103].FbkErr, DI[228]);
    Mot[103].Ready = Mot[103].Perm && !Mot[103].Fault && !Mot[103].Run;
    Mot[103].Lamp = Mot[103].Run || (Mot[103].Fault && Blink) || (Mot[103].Ready && DI[22] && Blink);

    /* motor M205 */
    Mot[104].Perm = Grp[17].Release && (DI[153] || !DI[184]) && (Mot[3].Run || !DI[199]);
    Mot[104].StartReq = (Grp[17].Auto && DI[27]) || (!Grp[17].Auto && DI[29] && DI[218]);
    Mot[104].StopReq = (DI[37] && !DI[244]) || !Mot[104].Perm || Mot[104].Fault;
    Mot[104].Run = (Mot[104].StartReq || Mot[104].Run) && !Mot[104].StopReq;
    Mot[104].Fbk = Mot[104].Run && (DI[200] || Mot[104].Fbk);
    Mot[104].FbkErr = (Mot[104].Run != Mot[104].Fbk) && DI[92];
    if (Mot[104].FbkErr && DI[162])
        Mot[104].Fault = true;
    else if (DI[12])
        Mot[104].Fault = false;
    Mot[104].Ready = Mot[104].Perm && !Mot[104].Fault && !Mot[104].Run;
    Mot[104].Lamp = Mot[104].Run || (Mot[104].Fault && Blink) || (Mot[104].Ready && DI[188] && Blink);

    /* motor M206 */
    Mot[105].Perm = Grp[27].Release && (DI[107] || DI[111]) && (Mot[83].Run || !DI[153]);
    Mot[105].StartReq = (Grp[27].Auto && DI[162]) || (!Grp[27].Auto && DI[17] && DI[39]);
    Mot[105].StopReq = (DI[242] && !DI[242]) || !Mot[105].Perm || Mot[105].Fault;
    Mot[105].Run = (Mot[105].StartReq || Mot[105].Run) && !Mot[105].StopReq;
    Mot[105].Fbk = Mot[105].Run && (DI[110] || Mot[105].Fbk);
    Mot[105].FbkErr = (Mot[105].Run != Mot[105].Fbk) && DI[18];
    Mot[105].Fault = sr(&MotFlt_SR[35], Mot[105].FbkErr && DI[120], DI[139]);
    Mot[105].Ready = Mot[105].Perm && !Mot[105].Fault && !Mot[105].Run;
    Mot[105].Lamp = Mot[105].Run || (Mot[105].Fault && Blink) || (Mot[105].Ready && DI[172] && Blink);

    /* motor M207 */
    Mot[106].Perm = Grp[24].Release && (!DI[218] || DI[152]) && (Mot[32].Run || !DI[81]);
    Mot[106].StartReq = (Grp[24].Auto && DI[109]) || (!Grp[24].Auto && DI[236] && DI[12]);
    Mot[106].StopReq = (DI[225] && DI[179]) || !Mot[106].Perm || Mot[106].Fault;
    Mot[106].Run = (Mot[106].StartReq || Mot[106].Run) && !Mot[106].StopReq;
    Mot[106].Fbk = Mot[106].Run && (DI[253] || Mot[106].Fbk);
    Mot[106].FbkErr = (Mot[106].Run != Mot[106].Fbk) && DI[27];
    Mot[106].Fault = rs(&MotFlt_RS[35], Mot[106].FbkErr, DI[181]);
    Mot[106].Ready = Mot[106].Perm && !Mot[106].Fault && !Mot[106].Run;
    Mot[106].Lamp = Mot[106].Run || (Mot[106].Fault && Blink) || (Mot[106].Ready && DI[205] && Blink);

    /* motor M208 */
    Mot[107].Perm = Grp[0].Release && (DI[206] || !DI[41]) && (Mot[79].Run || DI[59]);
    Mot[107].StartReq = (Grp[0].Auto && DI[10]) || (!Grp[0].Auto && DI[85] && DI[236]);
    Mot[107].StopReq = (DI[193] && DI[64]) || !Mot[107].Perm || Mot[107].Fault;
    Mot[107].Run = (Mot[107].StartReq || Mot[107].Run) && !Mot[107].StopReq;
    Mot[107].Fbk = Mot[107].Run && (!DI[205] || Mot[107].Fbk);
    Mot[107].FbkErr = (Mot[107].Run != Mot[107].Fbk) && DI[36];
    if (Mot[107].FbkErr && DI[113])
        Mot[107].Fault = true;
    else if (DI[176])
        Mot[107].Fault = false;
    Mot[107].Ready = Mot[107].Perm && !Mot[107].Fault && !Mot[107].Run;
    Mot[107].Lamp = Mot[107].Run || (Mot[107].Fault && Blink) || (Mot[107].Ready && DI[117] && Blink);

    /* motor M209 */
    Mot[108].Perm = Grp[18].Release && (!DI[248] || DI[132]) && (Mot[15].Run || DI[58]);
    Mot[108].StartReq = (Grp[18].Auto && DI[235]) || (!Grp[18].Auto && DI[215] && !DI[188]);
    Mot[108].StopReq = (DI[143] && !DI[209]) || !Mot[108].Perm || Mot[108].Fault;
    Mot[108].Run = (Mot[108].StartReq || Mot[108].Run) && !Mot[108].StopReq;
    Mot[108].Fbk = Mot[108].Run && (!DI[251] || Mot[108].Fbk);
    Mot[108].FbkErr = (Mot[108].Run != Mot[108].Fbk) && DI[99];
    Mot[108].Fault = sr(&MotFlt_SR[36], Mot[108].FbkErr && DI[184], DI[196]);
    Mot[108].Ready = Mot[108].Perm && !Mot[108].Fault && !Mot[108].Run;
    Mot[108].Lamp = Mot[108].Run || (Mot[108].Fault && Blink) || (Mot[108].Ready && DI[239] && Blink);

    /* motor M210 */
    Mot[109].Perm = Grp[25].Release && (DI[131] || DI[79]) && (Mot[104].Run || !DI[233]);
    Mot[109].StartReq = (Grp[25].Auto && DI[80]) || (!Grp[25].Auto && DI[66] && DI[62]);
    Mot[109].StopReq = (DI[136] && !DI[9]) || !Mot[109].Perm || Mot[109].Fault;
    Mot[109].Run = (Mot[109].StartReq || Mot[109].Run) && !Mot[109].StopReq;
    Mot[109].Fbk = Mot[109].Run && (DI[145] || Mot[109].Fbk);
    Mot[109].FbkErr = (Mot[109].Run != Mot[109].Fbk) && DI[9];
    Mot[109].Fault = rs(&MotFlt_RS[36], Mot[109].FbkErr, DI[202]);
    Mot[109].Ready = Mot[109].Perm && !Mot[109].Fault && !Mot[109].Run;
    Mot[109].Lamp = Mot[109].Run || (Mot[109].Fault && Blink) || (Mot[109].Ready && DI[101] && Blink);

    /* motor M211 */
    Mot[110].Perm = Grp[4].Release && (DI[162] || DI[206]) && (Mot[101].Run || !DI[126]);
    Mot[110].StartReq = (Grp[4].Auto && DI[190]) || (!Grp[4].Auto && DI[235] && DI[20]);
    Mot[110].StopReq = (DI[87] && !DI[155]) || !Mot[110].Perm || Mot[110].Fault;
    Mot[110].Run = (Mot[110].StartReq || Mot[110].Run) && !Mot[110].StopReq;
    Mot[110].Fbk = Mot[110].Run && (DI[138] || Mot[110].Fbk);
    Mot[110].FbkErr = (Mot[110].Run != Mot[110].Fbk) && DI[91];
    if (Mot[110].FbkErr && DI[45])
        Mot[110].Fault = true;
    else if (DI[30])
        Mot[110].Fault = false;
    Mot[110].Ready = Mot[110].Perm && !Mot[110].Fault && !Mot[110].Run;
    Mot[110].Lamp = Mot[110].Run || (Mot[110].Fault && Blink) || (Mot[110].Ready && DI[38] && Blink);

    /* motor M212 */
    Mot[111].Perm = Grp[27].Release && (!DI[195] || DI[231]) && (Mot[52].Run || DI[158]);
    Mot[111].StartReq = (Grp[27].Auto && DI[76]) || (!Grp[27].Auto && DI[12] && DI[89]);
    Mot[111].StopReq = (DI[125] && DI[162]) || !Mot[111].Perm || Mot[111].Fault;
    Mot[111].Run = (Mot[111].StartReq || Mot[111].Run) && !Mot[111].StopReq;
    Mot[111].Fbk = Mot[111].Run && (DI[73] || Mot[111].Fbk);
    Mot[111].FbkErr = (Mot[111].Run != Mot[111].Fbk) && DI[147];
    Mot[111].Fault = sr(&MotFlt_SR[37], Mot[111].FbkErr && DI[222], DI[194]);
    Mot[111].Ready = Mot[111].Perm && !Mot[111].Fault && !Mot[111].Run;
    Mot[111].Lamp = Mot[111].Run || (Mot[111].Fault && Blink) || (Mot[111].Ready && DI[212] && Blink);

    /* motor M213 */
    Mot[112].Perm = Grp[24].Release && (DI[48] || DI[233]) && (Mot[25].Run || !DI[11]);
    Mot[112].StartReq = (Grp[24].Auto && DI[53]) || (!Grp[24].Auto && DI[248] && DI[16]);
    Mot[112].StopReq = (DI[53] && !DI[127]) || !Mot[112].Perm || Mot[112].Fault;
    Mot[112].Run = (Mot[112].StartReq || Mot[112].Run) && !Mot[112].StopReq;
    Mot[112].Fbk = Mot[112].Run && (DI[227] || Mot[112].Fbk);
    Mot[112].FbkErr = (Mot[112].Run != Mot[112].Fbk) && DI[218];
    Mot[112].Fault = rs(&MotFlt_RS[37], Mot[112].FbkErr, DI[246]);
    Mot[112].Ready = Mot[112].Perm && !Mot[112].Fault && !Mot[112].Run;
    Mot[112].Lamp = Mot[112].Run || (Mot[112].Fault && Blink) || (Mot[112].Ready && DI[120] && Blink);

    /* motor M214 */
    Mot[113].Perm = Grp[10].Release && (DI[215] || !DI[128]) && (Mot[108].Run || DI[231]);
    Mot[113].StartReq = (Grp[10].Auto && DI[0]) || (!Grp[10].Auto && DI[193] && !DI[10]);
    Mot[113].StopReq = (DI[146] && DI[72]) || !Mot[113].Perm || Mot[113].Fault;
    Mot[113].Run = (Mot[113].StartReq || Mot[113].Run) && !Mot[113].StopReq;
    Mot[113].Fbk = Mot[113].Run && (DI[144] || Mot[113].Fbk);
    Mot[113].FbkErr = (Mot[113].Run != Mot[113].Fbk) && DI[72];
    if (Mot[113].FbkErr && DI[219])
        Mot[113].Fault = true;
    else if (DI[247])
        Mot[113].Fault = false;
    Mot[113].Ready = Mot[113].Perm && !Mot[113].Fault && !Mot[113].Run;
    Mot[113].Lamp = Mot[113].Run || (Mot[113].Fault && Blink) || (Mot[113].Ready && DI[64] && Blink);

    /* motor M215 */
    Mot[114].Perm = Grp[13].Release && (DI[79] || DI[41]) && (Mot[75].Run || DI[88]);
    Mot[114].StartReq = (Grp[13].Auto && DI[85]) || (!Grp[13].Auto && DI[149] && DI[5]);
    Mot[114].StopReq = (DI[144] && DI[227]) || !Mot[114].Perm || Mot[114].Fault;
    Mot[114].Run = (Mot[114].StartReq || Mot[114].Run) && !Mot[114].StopReq;
    Mot[114].Fbk = Mot[114].Run && (!DI[150] || Mot[114].Fbk);
    Mot[114].FbkErr = (Mot[114].Run != Mot[114].Fbk) && DI[5];
    Mot[114].Fault = sr(&MotFlt_SR[38], Mot[114].FbkErr && DI[227], DI[211]);
    Mot[114].Ready = Mot[114].Perm && !Mot[114].Fault && !Mot[114].Run;
    Mot[114].Lamp = Mot[114].Run || (Mot[114].Fault && Blink) || (Mot[114].Ready && DI[89] && Blink);

    /* motor M216 */
    Mot[115].Perm = Grp[7].Release && (DI[87] || !DI[92]) && (Mot[92].Run || !DI[207]);
    Mot[115].StartReq = (Grp[7].Auto && DI[176]) || (!Grp[7].Auto && DI[246] && !DI[142]);
    Mot[115].StopReq = (DI[235] && !DI[175]) || !Mot[115].Perm || Mot[115].Fault;
    Mot[115].Run = (Mot[115].StartReq || Mot[115].Run) && !Mot[115].StopReq;
    Mot[115].Fbk = Mot[115].Run && (!DI[15] || Mot[115].Fbk);
    Mot[115].FbkErr = (Mot[115].Run != Mot[115].Fbk) && DI[215];
    Mot[115].Fault = rs(&MotFlt_RS[38], Mot[115].FbkErr, DI[164]);
    Mot[115].Ready = Mot[115].Perm && !Mot[115].Fault && !Mot[115].Run;
    Mot[115].Lamp = Mot[115].Run || (Mot[115].Fault && Blink) || (Mot[115].Ready && DI[84] && Blink);

    /* motor M217 */
    Mot[116].Perm = Grp[0].Release && (DI[173] || !DI[217]) && (Mot[93].Run || !DI[34]);
    Mot[116].StartReq = (Grp[0].Auto && DI[54]) || (!Grp[0].Auto && DI[202] && DI[81]);
    Mot[116].StopReq = (DI[28] && DI[88]) || !Mot[116].Perm || Mot[116].Fault;
    Mot[116].Run = (Mot[116].StartReq || Mot[116].Run) && !Mot[116].StopReq;
    Mot[116].Fbk = Mot[116].Run && (DI[124] || Mot[116].Fbk);
    Mot[116].FbkErr = (Mot[116].Run != Mot[116].Fbk) && DI[61];
    if (Mot[116].FbkErr && DI[18])
        Mot[116].Fault = true;
    else if (DI[113])
        Mot[116].Fault = false;
    Mot[116].Ready = Mot[116].Perm && !Mot[116].Fault && !Mot[116].Run;
    Mot[116].Lamp = Mot[116].Run || (Mot[116].Fault && Blink) || (Mot[116].Ready && DI[94] && Blink);

    /* motor M218 */
    Mot[117].Perm = Grp[15].Release && (DI[105] || DI[135]) && (Mot[61].Run || DI[100]);
    Mot[117].StartReq = (Grp[15].Auto && DI[37]) || (!Grp[15].Auto && DI[4] && DI[81]);
    Mot[117].StopReq = (DI[47] && DI[70]) || !Mot[117].Perm || Mot[117].Fault;
    Mot[117].Run = (Mot[117].StartReq || Mot[117].Run) && !Mot[117].StopReq;
    Mot[117].Fbk = Mot[117].Run && (!DI[50] || Mot[117].Fbk);
    Mot[117].FbkErr = (Mot[117].Run != Mot[117].Fbk) && DI[15];
    Mot[117].Fault = sr(&MotFlt_SR[39], Mot[117].FbkErr && DI[96], DI[145]);
    Mot[117].Ready = Mot[117].Perm && !Mot[117].Fault && !Mot[117].Run;
    Mot[117].Lamp = Mot[117].Run || (Mot[117].Fault && Blink) || (Mot[117].Ready && DI[170] && Blink);

    /* motor M219 */
    Mot[118].Perm = Grp[28].Release && (DI[19] || DI[95]) && (Mot[45].Run || !DI[1]);
    Mot[118].StartReq = (Grp[28].Auto && DI[33]) || (!Grp[28].Auto && DI[75] && DI[174]);
    Mot[118].StopReq = (DI[18] && DI[180]) || !Mot[118].Perm || Mot[118].Fault;
    Mot[118].Run = (Mot[118].StartReq || Mot[118].Run) && !Mot[118].StopReq;
    Mot[118].Fbk = Mot[118].Run && (DI[4] || Mot[118].Fbk);
    Mot[118].FbkErr = (Mot[118].Run != Mot[118].Fbk) && DI[224];
    Mot[118].Fault = rs(&MotFlt_RS[39], Mot[118].FbkErr, DI[18]);
    Mot[118].Ready = Mot[118].Perm && !Mot[118].Fault && !Mot[118].Run;
    Mot[118].Lamp = Mot[118].Run || (Mot[118].Fault && Blink) || (Mot[118].Ready && DI[169] && Blink);

    /* motor M220 */
    Mot[119].Perm = Grp[14].Release && (!DI[228] || !DI[156]) && (Mot[91].Run || DI[199]);
    Mot[119].StartReq = (Grp[14].Auto && DI[162]) || (!Grp[14].Auto && DI[68] && DI[126]);
    Mot[119].StopReq = (DI[88] && !DI[213]) || !Mot[119].Perm || Mot[119].Fault;
    Mot[119].Run = (Mot[119].StartReq || Mot[119].Run) && !Mot[119].StopReq;
    Mot[119].Fbk = Mot[119].Run && (!DI[133] || Mot[119].Fbk);
    Mot[119].FbkErr = (Mot[119].Run != Mot[119].Fbk) && DI[106];
    if (Mot[119].FbkErr && DI[120])
        Mot[119].Fault = true;
    else if (DI[19])
        Mot[119].Fault = false;
    Mot[119].Ready = Mot[119].Perm && !Mot[119].Fault && !Mot[119].Run;
    Mot[119].Lamp = Mot[119].Run || (Mot[119].Fault && Blink) || (Mot[119].Ready && DI[44] && Blink);

    /* motor M221 */
    Mot[120].Perm = Grp[29].Release && (DI[137] || DI[88]) && (Mot[115].Run || DI[114]);
    Mot[120].StartReq = (Grp[29].Auto && DI[105]) || (!Grp[29].Auto && DI[62] && !DI[149]);
    Mot[120].StopReq = (DI[2] && DI[102]) || !Mot[120].Perm || Mot[120].Fault;
    Mot[120].Run = (Mot[120].StartReq || Mot[120].Run) && !Mot[120].StopReq;
    Mot[120].Fbk = Mot[120].Run && (DI[231] || Mot[120].Fbk);
    Mot[120].FbkErr = (Mot[120].Run != Mot[120].Fbk) && DI[31];
    Mot[120].Fault = sr(&MotFlt_SR[40], Mot[120].FbkErr && DI[55], DI[177]);
    Mot[120].Ready = Mot[120].Perm && !Mot[120].Fault && !Mot[120].Run;
    Mot[120].Lamp = Mot[120].Run || (Mot[120].Fault && Blink) || (Mot[120].Ready && DI[75] && Blink);

    /* motor M222 */
    Mot[121].Perm = Grp[26].Release && (DI[26] || !DI[4]) && (Mot[77].Run || DI[214]);
    Mot[121].StartReq = (Grp[26].Auto && DI[114]) || (!Grp[26].Auto && DI[138] && DI[55]);
    Mot[121].StopReq = (DI[1] && DI[85]) || !Mot[121].Perm || Mot[121].Fault;
    Mot[121].Run = (Mot[121].StartReq || Mot[121].Run) && !Mot[121].StopReq;
    Mot[121].Fbk = Mot[121].Run && (DI[76] || Mot[121].Fbk);
    Mot[121].FbkErr = (Mot[121].Run != Mot[121].Fbk) && DI[193];
    Mot[121].Fault = rs(&MotFlt_RS[40], Mot[121].FbkErr, DI[33]);
    Mot[121].Ready = Mot[121].Perm && !Mot[121].Fault && !Mot[121].Run;
    Mot[121].Lamp = Mot[121].Run || (Mot[121].Fault && Blink) || (Mot[121].Ready && DI[8] && Blink);

    /* motor M223 */
    Mot[122].Perm = Grp[0].Release && (DI[33] || !DI[75]) && (Mot[76].Run || !DI[62]);
    Mot[122].StartReq = (Grp[0].Auto && DI[131]) || (!Grp[0].Auto && DI[58] && !DI[58]);
    Mot[122].StopReq = (DI[130] && DI[170]) || !Mot[122].Perm || Mot[122].Fault;
    Mot[122].Run = (Mot[122].StartReq || Mot[122].Run) && !Mot[122].StopReq;
    Mot[122].Fbk = Mot[122].Run && (DI[55] || Mot[122].Fbk);
    Mot[122].FbkErr = (Mot[122].Run != Mot[122].Fbk) && DI[235];
    if (Mot[122].FbkErr && DI[210])
        Mot[122].Fault = true;
    else if (DI[165])
        Mot[122].Fault = false;
    Mot[122].Ready = Mot[122].Perm && !Mot[122].Fault && !Mot[122].Run;
    Mot[122].Lamp = Mot[122].Run || (Mot[122].Fault && Blink) || (Mot[122].Ready && DI[138] && Blink);

    /* motor M224 */
    Mot[123].Perm = Grp[8].Release && (DI[21] || DI[245]) && (Mot[58].Run || DI[215]);
    Mot[123].StartReq = (Grp[8].Auto && DI[68]) || (!Grp[8].Auto && DI[11] && DI[214]);
    Mot[123].StopReq = (DI[96] && !DI[153]) || !Mot[123].Perm || Mot[123].Fault;
    Mot[123].Run = (Mot[123].StartReq || Mot[123].Run) && !Mot[123].StopReq;
    Mot[123].Fbk = Mot[123].Run && (!DI[247] || Mot[123].Fbk);
    Mot[123].FbkErr = (Mot[123].Run != Mot[123].Fbk) && DI[77];
    Mot[123].Fault = sr(&MotFlt_SR[41], Mot[123].FbkErr && DI[180], DI[163]);
    Mot[123].Ready = Mot[123].Perm && !Mot[123].Fault && !Mot[123].Run;
    Mot[123].Lamp = Mot[123].Run || (Mot[123].Fault && Blink) || (Mot[123].Ready && DI[238] && Blink);

    /* motor M225 */
    Mot[124].Perm = Grp[18].Release && (DI[40] || DI[1]) && (Mot[84].Run || !DI[130]);
    Mot[124].StartReq = (Grp[18].Auto && DI[45]) || (!Grp[18].Auto && DI[171] && !DI[250]);
    Mot[124].StopReq = (DI[159] && !DI[223]) || !Mot[124].Perm || Mot[124].Fault;
    Mot[124].Run = (Mot[124].StartReq || Mot[124].Run) && !Mot[124].StopReq;
    Mot[124].Fbk = Mot[124].Run && (DI[101] || Mot[124].Fbk);
    Mot[124].FbkErr = (Mot[124].Run != Mot[124].Fbk) && DI[109];
    Mot[124].Fault = rs(&MotFlt_RS[41], Mot[124].FbkErr, DI[49]);
    Mot[124].Ready = Mot[124].Perm && !Mot[124].Fault && !Mot[124].Run;
    Mot[124].Lamp = Mot[124].Run || (Mot[124].Fault && Blink) || (Mot[124].Ready && DI[168] && Blink);

    /* motor M226 */
    Mot[125].Perm = Grp[7].Release && (DI[127] || !DI[243]) && (Mot[56].Run || DI[97]);
    Mot[125].StartReq = (Grp[7].Auto && DI[177]) || (!Grp[7].Auto && DI[200] && DI[31]);
    Mot[125].StopReq = (DI[55] && DI[65]) || !Mot[125].Perm || Mot[125].Fault;
    Mot[125].Run = (Mot[125].StartReq || Mot[125].Run) && !Mot[125].StopReq;
    Mot[125].Fbk = Mot[125].Run && (DI[162] || Mot[125].Fbk);
    Mot[125].FbkErr = (Mot[125].Run != Mot[125].Fbk) && DI[222];
    if (Mot[125].FbkErr && DI[61])
        Mot[125].Fault = true;
    else if (DI[127])
        Mot[125].Fault = false;
    Mot[125].Ready = Mot[125].Perm && !Mot[125].Fault && !Mot[125].Run;
    Mot[125].Lamp = Mot[125].Run || (Mot[125].Fault && Blink) || (Mot[125].Ready && DI[247] && Blink);

    /* motor M227 */
    Mot[126].Perm = Grp[26].Release && (DI[36] || DI[202]) && (Mot[21].Run || DI[87]);
    Mot[126].StartReq = (Grp[26].Auto && DI[2]) || (!Grp[26].Auto && DI[76] && !DI[150]);
    Mot[126].StopReq = (DI[237] && DI[255]) || !Mot[126].Perm || Mot[126].Fault;
    Mot[126].Run = (Mot[126].StartReq || Mot[126].Run) && !Mot[126].StopReq;
    Mot[126].Fbk = Mot[126].Run && (DI[158] || Mot[126].Fbk);
    Mot[126].FbkErr = (Mot[126].Run != Mot[126].Fbk) && DI[229];
    Mot[126].Fault = sr(&MotFlt_SR[42], Mot[126].FbkErr && DI[132], DI[50]);
    Mot[126].Ready = Mot[126].Perm && !Mot[126].Fault && !Mot[126].Run;
    Mot[126].Lamp = Mot[126].Run || (Mot[126].Fault && Blink) || (Mot[126].Ready && DI[106] && Blink);

    /* motor M228 */
    Mot[127].Perm = Grp[26].Release && (DI[137] || DI[215]) && (Mot[113].Run || DI[70]);
    Mot[127].StartReq = (Grp[26].Auto && DI[182]) || (!Grp[26].Auto && DI[197] && !DI[126]);
    Mot[127].StopReq = (DI[211] && DI[140]) || !Mot[127].Perm || Mot[127].Fault;
    Mot[127].Run = (Mot[127].StartReq || Mot[127].Run) && !Mot[127].StopReq;
    Mot[127].Fbk = Mot[127].Run && (DI[151] || Mot[127].Fbk);
    Mot[127].FbkErr = (Mot[127].Run != Mot[127].Fbk) && DI[112];
    Mot[127].Fault = rs(&MotFlt_RS[42], Mot[127].FbkErr, DI[62]);
    Mot[127].Ready = Mot[127].Perm && !Mot[127].Fault && !Mot[127].Run;
    Mot[127].Lamp = Mot[127].Run || (Mot[127].Fault && Blink) || (Mot[127].Ready && DI[78] && Blink);

    /* motor M229 */
    Mot[128].Perm = Grp[10].Release && (DI[49] || DI[206]) && (Mot[70].Run || !DI[166]);
    Mot[128].StartReq = (Grp[10].Auto && DI[244]) || (!Grp[10].Auto && DI[33] && !DI[237]);
    Mot[128].StopReq = (DI[95] && DI[98]) || !Mot[128].Perm || Mot[128].Fault;
    Mot[128].Run = (Mot[128].StartReq || Mot[128].Run) && !Mot[128].StopReq;
    Mot[128].Fbk = Mot[128].Run && (DI[185] || Mot[128].Fbk);
    Mot[128].FbkErr = (Mot[128].Run != Mot[128].Fbk) && DI[101];
    if (Mot[128].FbkErr && DI[191])
        Mot[128].Fault = true;
    else if (DI[30])
        Mot[128].Fault = false;
    Mot[128].Ready = Mot[128].Perm && !Mot[128].Fault && !Mot[128].Run;
    Mot[128].Lamp = Mot[128].Run || (Mot[128].Fault && Blink) || (Mot[128].Ready && DI[178] && Blink);

    /* motor M230 */
    Mot[129].Perm = Grp[18].Release && (!DI[30] || DI[186]) && (Mot[37].Run || !DI[187]);
    Mot[129].StartReq = (Grp[18].Auto && DI[121]) || (!Grp[18].Auto && DI[133] && DI[153]);
    Mot[129].StopReq = (DI[32] && DI[47]) || !Mot[129].Perm || Mot[129].Fault;
    Mot[129].Run = (Mot[129].StartReq || Mot[129].Run) && !Mot[129].StopReq;
    Mot[129].Fbk = Mot[129].Run && (!DI[166] || Mot[129].Fbk);
    Mot[129].FbkErr = (Mot[129].Run != Mot[129].Fbk) && DI[126];
    Mot[129].Fault = sr(&MotFlt_SR[43], Mot[129].FbkErr && DI[34], DI[73]);
    Mot[129].Ready = Mot[129].Perm && !Mot[129].Fault && !Mot[129].Run;
    Mot[129].Lamp = Mot[129].Run || (Mot[129].Fault && Blink) || (Mot[129].Ready && DI[63] && Blink);

    /* valve V201 */
    Vlv[0].OpenReq = Grp[9].Release && (Mot[61].Run || DI[74]) && !DI[114];
    Vlv[0].CloseReq = !Grp[9].Release || (DI[220] && !Mot[61].Run);
    Vlv[0].Cmd = (Vlv[0].OpenReq || Vlv[0].Cmd) && !Vlv[0].CloseReq;
    Vlv[0].Opened = Vlv[0].Cmd && (DI[203] || Vlv[0].Opened);
    Vlv[0].Closed = !Vlv[0].Cmd && !Vlv[0].Opened;
    Vlv[0].Moving = !Vlv[0].Opened && !Vlv[0].Closed;
    Vlv[0].PosErr = (Vlv[0].Moving && DI[67] && DI[255]) || (Vlv[0].PosErr && !DI[43]);
    Vlv[0].Locked = Vlv[0].PosErr && DI[27];

    /* valve V202 */
    Vlv[1].OpenReq = Grp[8].Release && (Mot[111].Run || DI[48]) && DI[236];
    Vlv[1].CloseReq = !Grp[8].Release || (DI[251] && !Mot[111].Run);
    Vlv[1].Cmd = (Vlv[1].OpenReq || Vlv[1].Cmd) && !Vlv[1].CloseReq;
    Vlv[1].Opened = Vlv[1].Cmd && (!DI[180] || Vlv[1].Opened);
    Vlv[1].Closed = !Vlv[1].Cmd && !Vlv[1].Opened;
    Vlv[1].Moving = !Vlv[1].Opened && !Vlv[1].Closed;
    Vlv[1].PosErr = (Vlv[1].Moving && DI[65] && !DI[238]) || (Vlv[1].PosErr && !DI[110]);
    Vlv[1].Locked = sr(&VlvLock[0], Vlv[1].PosErr, DI[190] && DI[51]);

    /* valve V203 */
    Vlv[2].OpenReq = Grp[23].Release && (Mot[27].Run || DI[11]) && !DI[246];
    Vlv[2].CloseReq = !Grp[23].Release || (DI[153] && !Mot[27].Run);
    Vlv[2].Cmd = (Vlv[2].OpenReq || Vlv[2].Cmd) && !Vlv[2].CloseReq;
    Vlv[2].Opened = Vlv[2].Cmd && (DI[65] || Vlv[2].Opened);
    Vlv[2].Closed = !Vlv[2].Cmd && !Vlv[2].Opened;
    Vlv[2].Moving = !Vlv[2].Opened && !Vlv[2].Closed;
    Vlv[2].PosErr = (Vlv[2].Moving && DI[107] && DI[37]) || (Vlv[2].PosErr && !DI[102]);
    Vlv[2].Locked = Vlv[2].PosErr && DI[109];

    /* valve V204 */
    Vlv[3].OpenReq = Grp[16].Release && (Mot[48].Run || DI[166]) && DI[24];
    Vlv[3].CloseReq = !Grp[16].Release || (DI[202] && !Mot[48].Run);
    Vlv[3].Cmd = (Vlv[3].OpenReq || Vlv[3].Cmd) && !Vlv[3].CloseReq;
    Vlv[3].Opened = Vlv[3].Cmd && (DI[107] || Vlv[3].Opened);
    Vlv[3].Closed = !Vlv[3].Cmd && !Vlv[3].Opened;
    Vlv[3].Moving = !Vlv[3].Opened && !Vlv[3].Closed;
    Vlv[3].PosErr = (Vlv[3].Moving && DI[158] && !DI[222]) || (Vlv[3].PosErr && !DI[164]);
    Vlv[3].Locked = sr(&VlvLock[1], Vlv[3].PosErr, DI[146] && DI[68]);

    /* valve V205 */
    Vlv[4].OpenReq = Grp[9].Release && (Mot[96].Run || DI[85]) && DI[105];
    Vlv[4].CloseReq = !Grp[9].Release || (DI[30] && !Mot[96].Run);
    Vlv[4].Cmd = (Vlv[4].OpenReq || Vlv[4].Cmd) && !Vlv[4].CloseReq;
    Vlv[4].Opened = Vlv[4].Cmd && (!DI[128] || Vlv[4].Opened);
    Vlv[4].Closed = !Vlv[4].Cmd && !Vlv[4].Opened;
    Vlv[4].Moving = !Vlv[4].Opened && !Vlv[4].Closed;
    Vlv[4].PosErr = (Vlv[4].Moving && DI[202] && DI[95]) || (Vlv[4].PosErr && !DI[207]);
    Vlv[4].Locked = Vlv[4].PosErr && DI[102];

    /* valve V206 */
    Vlv[5].OpenReq = Grp[24].Release && (Mot[77].Run || DI[203]) && !DI[106];
    Vlv[5].CloseReq = !Grp[24].Release || (DI[140] && !Mot[77].Run);
    Vlv[5].Cmd = (Vlv[5].OpenReq || Vlv[5].Cmd) && !Vlv[5].CloseReq;
    Vlv[5].Opened = Vlv[5].Cmd && (DI[250] || Vlv[5].Opened);
    Vlv[5].Closed = !Vlv[5].Cmd && !Vlv[5].Opened;
    Vlv[5].Moving = !Vlv[5].Opened && !Vlv[5].Closed;
    Vlv[5].PosErr = (Vlv[5].Moving && DI[147] && DI[92]) || (Vlv[5].PosErr && !DI[100]);
    Vlv[5].Locked = sr(&VlvLock[2], Vlv[5].PosErr, DI[221] && DI[52]);

    /* valve V207 */
    Vlv[6].OpenReq = Grp[25].Release && (Mot[89].Run || DI[181]) && DI[144];
    Vlv[6].CloseReq = !Grp[25].Release || (DI[69] && !Mot[89].Run);
    Vlv[6].Cmd = (Vlv[6].OpenReq || Vlv[6].Cmd) && !Vlv[6].CloseReq;
    Vlv[6].Opened = Vlv[6].Cmd && (DI[126] || Vlv[6].Opened);
    Vlv[6].Closed = !Vlv[6].Cmd && !Vlv[6].Opened;
    Vlv[6].Moving = !Vlv[6].Opened && !Vlv[6].Closed;
    Vlv[6].PosErr = (Vlv[6].Moving && DI[229] && DI[237]) || (Vlv[6].PosErr && !DI[71]);
    Vlv[6].Locked = Vlv[6].PosErr && DI[32];

    /* valve V208 */
    Vlv[7].OpenReq = Grp[6].Release && (Mot[21].Run || DI[88]) && DI[28];
    Vlv[7].CloseReq = !Grp[6].Release || (DI[242] && !Mot[21].Run);
    Vlv[7].Cmd = (Vlv[7].OpenReq || Vlv[7].Cmd) && !Vlv[7].CloseReq;
    Vlv[7].Opened = Vlv[7].Cmd && (DI[198] || Vlv[7].Opened);
    Vlv[7].Closed = !Vlv[7].Cmd && !Vlv[7].Opened;
    Vlv[7].Moving = !Vlv[7].Opened && !Vlv[7].Closed;
    Vlv[7].PosErr = (Vlv[7].Moving && DI[91] && !DI[120]) || (Vlv[7].PosErr && !DI[69]);
    Vlv[7].Locked = sr(&VlvLock[3], Vlv[7].PosErr, DI[206] && DI[167]);

    /* valve V209 */
    Vlv[8].OpenReq = Grp[0].Release && (Mot[126].Run || DI[182]) && DI[11];
    Vlv[8].CloseReq = !Grp[0].Release || (DI[78] && !Mot[126].Run);
    Vlv[8].Cmd = (Vlv[8].OpenReq || Vlv[8].Cmd) && !Vlv[8].CloseReq;
    Vlv[8].Opened = Vlv[8].Cmd && (!DI[11] || Vlv[8].Opened);
    Vlv[8].Closed = !Vlv[8].Cmd && !Vlv[8].Opened;
    Vlv[8].Moving = !Vlv[8].Opened && !Vlv[8].Closed;
    Vlv[8].PosErr = (Vlv[8].Moving && DI[64] && !DI[189]) || (Vlv[8].PosErr && !DI[127]);
    Vlv[8].Locked = Vlv[8].PosErr && DI[184];

    /* valve V210 */
    Vlv[9].OpenReq = Grp[25].Release && (Mot[54].Run || DI[255]) && !DI[124];
    Vlv[9].CloseReq = !Grp[25].Release || (DI[154] && !Mot[54].Run);
    Vlv[9].Cmd = (Vlv[9].OpenReq || Vlv[9].Cmd) && !Vlv[9].CloseReq;
    Vlv[9].Opened = Vlv[9].Cmd && (DI[69] || Vlv[9].Opened);
    Vlv[9].Closed = !Vlv[9].Cmd && !Vlv[9].Opened;
    Vlv[9].Moving = !Vlv[9].Opened && !Vlv[9].Closed;
    Vlv[9].PosErr = (Vlv[9].Moving && DI[255] && DI[136]) || (Vlv[9].PosErr && !DI[8]);
    Vlv[9].Locked = sr(&VlvLock[4], Vlv[9].PosErr, DI[243] && DI[98]);

    /* valve V211 */
    Vlv[10].OpenReq = Grp[6].Release && (Mot[51].Run || DI[226]) && !DI[253];
    Vlv[10].CloseReq = !Grp[6].Release || (DI[16] && !Mot[51].Run);
    Vlv[10].Cmd = (Vlv[10].OpenReq || Vlv[10].Cmd) && !Vlv[10].CloseReq;
    Vlv[10].Opened = Vlv[10].Cmd && (DI[251] || Vlv[10].Opened);
    Vlv[10].Closed = !Vlv[10].Cmd && !Vlv[10].Opened;
    Vlv[10].Moving = !Vlv[10].Opened && !Vlv[10].Closed;
    Vlv[10].PosErr = (Vlv[10].Moving && DI[120] && DI[107]) || (Vlv[10].PosErr && !DI[131]);
    Vlv[10].Locked = Vlv[10].PosErr && DI[81];

    /* valve V212 */
    Vlv[11].OpenReq = Grp[14].Release && (Mot[0].Run || DI[184]) && !DI[234];
    Vlv[11].CloseReq = !Grp[14].Release || (DI[63] && !Mot[0].Run);
    Vlv[11].Cmd = (Vlv[11].OpenReq || Vlv[11].Cmd) && !Vlv[11].CloseReq;
    Vlv[11].Opened = Vlv[11].Cmd && (DI[72] || Vlv[11].Opened);
    Vlv[11].Closed = !Vlv[11].Cmd && !Vlv[11].Opened;
    Vlv[11].Moving = !Vlv[11].Opened && !Vlv[11].Closed;
    Vlv[11].PosErr = (Vlv[11].Moving && DI[196] && !DI[77]) || (Vlv[11].PosErr && !DI[196]);
    Vlv[11].Locked = sr(&VlvLock[5], Vlv[11].PosErr, DI[19] && DI[224]);

    /* valve V213 */
    Vlv[12].OpenReq = Grp[1].Release && (Mot[35].Run || DI[230]) && !DI[41];
    Vlv[12].CloseReq = !Grp[1].Release || (DI[254] && !Mot[35].Run);
    Vlv[12].Cmd = (Vlv[12].OpenReq || Vlv[12].Cmd) && !Vlv[12].CloseReq;
    Vlv[12].Opened = Vlv[12].Cmd && (DI[175] || Vlv[12].Opened);
    Vlv[12].Closed = !Vlv[12].Cmd && !Vlv[12].Opened;
    Vlv[12].Moving = !Vlv[12].Opened && !Vlv[12].Closed;
    Vlv[12].PosErr = (Vlv[12].Moving && DI[140] && DI[216]) || (Vlv[12].PosErr && !DI[189]);
    Vlv[12].Locked = Vlv[12].PosErr && DI[154];

    /* valve V214 */
    Vlv[13].OpenReq = Grp[7].Release && (Mot[87].Run || DI[64]) && DI[160];
    Vlv[13].CloseReq = !Grp[7].Release || (DI[190] && !Mot[87].Run);
    Vlv[13].Cmd = (Vlv[13].OpenReq || Vlv[13].Cmd) && !Vlv[13].CloseReq;
    Vlv[13].Opened = Vlv[13].Cmd && (!DI[26] || Vlv[13].Opened);
    Vlv[13].Closed = !Vlv[13].Cmd && !Vlv[13].Opened;
    Vlv[13].Moving = !Vlv[13].Opened && !Vlv[13].Closed;
    Vlv[13].PosErr = (Vlv[13].Moving && DI[39] && DI[125]) || (Vlv[13].PosErr && !DI[198]);
    Vlv[13].Locked = sr(&VlvLock[6], Vlv[13].PosErr, DI[249] && DI[202]);

    /* valve V215 */
    Vlv[14].OpenReq = Grp[9].Release && (Mot[20].Run || DI[109]) && !DI[73];
    Vlv[14].CloseReq = !Grp[9].Release || (DI[225] && !Mot[20].Run);
    Vlv[14].Cmd = (Vlv[14].OpenReq || Vlv[14].Cmd) && !Vlv[14].CloseReq;
    Vlv[14].Opened = Vlv[14].Cmd && (DI[243] || Vlv[14].Opened);
    Vlv[14].Closed = !Vlv[14].Cmd && !Vlv[14].Opened;
    Vlv[14].Moving = !Vlv[14].Opened && !Vlv[14].Closed;
    Vlv[14].PosErr = (Vlv[14].Moving && DI[28] && DI[195]) || (Vlv[14].PosErr && !DI[165]);
    Vlv[14].Locked = Vlv[14].PosErr && DI[47];

    /* valve V216 */
    Vlv[15].OpenReq = Grp[5].Release && (Mot[87].Run || DI[193]) && DI[99];
    Vlv[15].CloseReq = !Grp[5].Release || (DI[100] && !Mot[87].Run);
    Vlv[15].Cmd = (Vlv[15].OpenReq || Vlv[15].Cmd) && !Vlv[15].CloseReq;
    Vlv[15].Opened = Vlv[15].Cmd && (DI[49] || Vlv[15].Opened);
    Vlv[15].Closed = !Vlv[15].Cmd && !Vlv[15].Opened;
    Vlv[15].Moving = !Vlv[15].Opened && !Vlv[15].Closed;
    Vlv[15].PosErr = (Vlv[15].Moving && DI[124] && !DI[62]) || (Vlv[15].PosErr && !DI[57]);
    Vlv[15].Locked = sr(&VlvLock[7], Vlv[15].PosErr, DI[230] && DI[36]);

    /* valve V217 */
    Vlv[16].OpenReq = Grp[8].Release && (Mot[10].Run || DI[81]) && !DI[28];
    Vlv[16].CloseReq = !Grp[8].Release || (DI[54] && !Mot[10].Run);
    Vlv[16].Cmd = (Vlv[16].OpenReq || Vlv[16].Cmd) && !Vlv[16].CloseReq;
    Vlv[16].Opened = Vlv[16].Cmd && (DI[146] || Vlv[16].Opened);
    Vlv[16].Closed = !Vlv[16].Cmd && !Vlv[16].Opened;
    Vlv[16].Moving = !Vlv[16].Opened && !Vlv[16].Closed;
    Vlv[16].PosErr = (Vlv[16].Moving && DI[248] && !DI[111]) || (Vlv[16].PosErr && !DI[108]);
    Vlv[16].Locked = Vlv[16].PosErr && DI[97];

    /* valve V218 */
    Vlv[17].OpenReq = Grp[4].Release && (Mot[31].Run || DI[171]) && !DI[14];
    Vlv[17].CloseReq = !Grp[4].Release || (DI[72] && !Mot[31].Run);
    Vlv[17].Cmd = (Vlv[17].OpenReq || Vlv[17].Cmd) && !Vlv[17].CloseReq;
    Vlv[17].Opened = Vlv[17].Cmd && (!DI[164] || Vlv[17].Opened);
    Vlv[17].Closed = !Vlv[17].Cmd && !Vlv[17].Opened;
    Vlv[17].Moving = !Vlv[17].Opened && !Vlv[17].Closed;
    Vlv[17].PosErr = (Vlv[17].Moving && DI[175] && DI[193]) || (Vlv[17].PosErr && !DI[89]);
    Vlv[17].Locked = sr(&VlvLock[8], Vlv[17].PosErr, DI[212] && DI[33]);

    /* valve V219 */
    Vlv[18].OpenReq = Grp[17].Release && (Mot[104].Run || DI[31]) && DI[13];
    Vlv[18].CloseReq = !Grp[17].Release || (DI[0] && !Mot[104].Run);
    Vlv[18].Cmd = (Vlv[18].OpenReq || Vlv[18].Cmd) && !Vlv[18].CloseReq;
    Vlv[18].Opened = Vlv[18].Cmd && (!DI[141] || Vlv[18].Opened);
    Vlv[18].Closed = !Vlv[18].Cmd && !Vlv[18].Opened;
    Vlv[18].Moving = !Vlv[18].Opened && !Vlv[18].Closed;
    Vlv[18].PosErr = (Vlv[18].Moving && DI[243] && DI[175]) || (Vlv[18].PosErr && !DI[156]);
    Vlv[18].Locked = Vlv[18].PosErr && DI[145];

    /* valve V220 */
    Vlv[19].OpenReq = Grp[4].Release && (Mot[18].Run || DI[241]) && !DI[139];
    Vlv[19].CloseReq = !Grp[4].Release || (DI[23] && !Mot[18].Run);
    Vlv[19].Cmd = (Vlv[19].OpenReq || Vlv[19].Cmd) && !Vlv[19].CloseReq;
    Vlv[19].Opened = Vlv[19].Cmd && (DI[255] || Vlv[19].Opened);
    Vlv[19].Closed = !Vlv[19].Cmd && !Vlv[19].Opened;
    Vlv[19].Moving = !Vlv[19].Opened && !Vlv[19].Closed;
    Vlv[19].PosErr = (Vlv[19].Moving && DI[251] && !DI[112]) || (Vlv[19].PosErr && !DI[199]);
    Vlv[19].Locked = sr(&VlvLock[9], Vlv[19].PosErr, DI[36] && DI[18]);

    /* valve V221 */
    Vlv[20].OpenReq = Grp[20].Release && (Mot[74].Run || DI[222]) && !DI[81];
    Vlv[20].CloseReq = !Grp[20].Release || (DI[60] && !Mot[74].Run);
    Vlv[20].Cmd = (Vlv[20].OpenReq || Vlv[20].Cmd) && !Vlv[20].CloseReq;
    Vlv[20].Opened = Vlv[20].Cmd && (DI[195] || Vlv[20].Opened);
    Vlv[20].Closed = !Vlv[20].Cmd && !Vlv[20].Opened;
    Vlv[20].Moving = !Vlv[20].Opened && !Vlv[20].Closed;
    Vlv[20].PosErr = (Vlv[20].Moving && DI[129] && !DI[72]) || (Vlv[20].PosErr && !DI[250]);
    Vlv[20].Locked = Vlv[20].PosErr && DI[55];

    /* valve V222 */
    Vlv[21].OpenReq = Grp[7].Release && (Mot[33].Run || DI[199]) && !DI[53];
    Vlv[21].CloseReq = !Grp[7].Release || (DI[140] && !Mot[33].Run);
    Vlv[21].Cmd = (Vlv[21].OpenReq || Vlv[21].Cmd) && !Vlv[21].CloseReq;
    Vlv[21].Opened = Vlv[21].Cmd && (DI[156] || Vlv[21].Opened);
    Vlv[21].Closed = !Vlv[21].Cmd && !Vlv[21].Opened;
    Vlv[21].Moving = !Vlv[21].Opened && !Vlv[21].Closed;
    Vlv[21].PosErr = (Vlv[21].Moving && DI[131] && DI[92]) || (Vlv[21].PosErr && !DI[214]);
    Vlv[21].Locked = sr(&VlvLock[10], Vlv[21].PosErr, DI[207] && DI[214]);

    /* valve V223 */
    Vlv[22].OpenReq = Grp[10].Release && (Mot[77].Run || DI[129]) && DI[111];
    Vlv[22].CloseReq = !Grp[10].Release || (DI[75] && !Mot[77].Run);
    Vlv[22].Cmd = (Vlv[22].OpenReq || Vlv[22].Cmd) && !Vlv[22].CloseReq;
    Vlv[22].Opened = Vlv[22].Cmd && (DI[254] || Vlv[22].Opened);
    Vlv[22].Closed = !Vlv[22].Cmd && !Vlv[22].Opened;
    Vlv[22].Moving = !Vlv[22].Opened && !Vlv[22].Closed;
    Vlv[22].PosErr = (Vlv[22].Moving && DI[37] && !DI[66]) || (Vlv[22].PosErr && !DI[191]);
    Vlv[22].Locked = Vlv[22].PosErr && DI[140];

    /* valve V224 */
    Vlv[23].OpenReq = Grp[11].Release && (Mot[65].Run || DI[191]) && !DI[139];
    Vlv[23].CloseReq = !Grp[11].Release || (DI[235] && !Mot[65].Run);
    Vlv[23].Cmd = (Vlv[23].OpenReq || Vlv[23].Cmd) && !Vlv[23].CloseReq;
    Vlv[23].Opened = Vlv[23].Cmd && (DI[88] || Vlv[23].Opened);
    Vlv[23].Closed = !Vlv[23].Cmd && !Vlv[23].Opened;
    Vlv[23].Moving = !Vlv[23].Opened && !Vlv[23].Closed;
    Vlv[23].PosErr = (Vlv[23].Moving && DI[79] && DI[107]) || (Vlv[23].PosErr && !DI[83]);
    Vlv[23].Locked = sr(&VlvLock[11], Vlv[23].PosErr, DI[116] && DI[23]);

    /* valve V225 */
    Vlv[24].OpenReq = Grp[12].Release && (Mot[64].Run || DI[184]) && DI[101];
    Vlv[24].CloseReq = !Grp[12].Release || (DI[37] && !Mot[64].Run);
    Vlv[24].Cmd = (Vlv[24].OpenReq || Vlv[24].Cmd) && !Vlv[24].CloseReq;
    Vlv[24].Opened = Vlv[24].Cmd && (!DI[212] || Vlv[24].Opened);
    Vlv[24].Closed = !Vlv[24].Cmd && !Vlv[24].Opened;
    Vlv[24].Moving = !Vlv[24].Opened && !Vlv[24].Closed;
    Vlv[24].PosErr = (Vlv[24].Moving && DI[110] && DI[115]) || (Vlv[24].PosErr && !DI[148]);
    Vlv[24].Locked = Vlv[24].PosErr && DI[43];

    /* valve V226 */
    Vlv[25].OpenReq = Grp[19].Release && (Mot[31].Run || DI[174]) && DI[156];
    Vlv[25].CloseReq = !Grp[19].Release || (DI[52] && !Mot[31].Run);
    Vlv[25].Cmd = (Vlv[25].OpenReq || Vlv[25].Cmd) && !Vlv[25].CloseReq;
    Vlv[25].Opened = Vlv[25].Cmd && (!DI[61] || Vlv[25].Opened);
    Vlv[25].Closed = !Vlv[25].Cmd && !Vlv[25].Opened;
    Vlv[25].Moving = !Vlv[25].Opened && !Vlv[25].Closed;
    Vlv[25].PosErr = (Vlv[25].Moving && DI[237] && DI[239]) || (Vlv[25].PosErr && !DI[152]);
    Vlv[25].Locked = sr(&VlvLock[12], Vlv[25].PosErr, DI[29] && DI[90]);

    /* valve V227 */
    Vlv[26].OpenReq = Grp[28].Release && (Mot[34].Run || DI[5]) && DI[37];
    Vlv[26].CloseReq = !Grp[28].Release || (DI[236] && !Mot[34].Run);
    Vlv[26].Cmd = (Vlv[26].OpenReq || Vlv[26].Cmd) && !Vlv[26].CloseReq;
    Vlv[26].Opened = Vlv[26].Cmd && (!DI[84] || Vlv[26].Opened);
    Vlv[26].Closed = !Vlv[26].Cmd && !Vlv[26].Opened;
    Vlv[26].Moving = !Vlv[26].Opened && !Vlv[26].Closed;
    Vlv[26].PosErr = (Vlv[26].Moving && DI[15] && !DI[228]) || (Vlv[26].PosErr && !DI[28]);
    Vlv[26].Locked = Vlv[26].PosErr && DI[84];

    /* valve V228 */
    Vlv[27].OpenReq = Grp[23].Release && (Mot[88].Run || DI[114]) && !DI[44];
    Vlv[27].CloseReq = !Grp[23].Release || (DI[147] && !Mot[88].Run);
    Vlv[27].Cmd = (Vlv[27].OpenReq || Vlv[27].Cmd) && !Vlv[27].CloseReq;
    Vlv[27].Opened = Vlv[27].Cmd && (DI[30] || Vlv[27].Opened);
    Vlv[27].Closed = !Vlv[27].Cmd && !Vlv[27].Opened;
    Vlv[27].Moving = !Vlv[27].Opened && !Vlv[27].Closed;
    Vlv[27].PosErr = (Vlv[27].Moving && DI[33] && DI[231]) || (Vlv[27].PosErr && !DI[104]);
    Vlv[27].Locked = sr(&VlvLock[13], Vlv[27].PosErr, DI[250] && DI[127]);

    /* valve V229 */
    Vlv[28].OpenReq = Grp[26].Release && (Mot[104].Run || DI[40]) && DI[249];
    Vlv[28].CloseReq = !Grp[26].Release || (DI[98] && !Mot[104].Run);
    Vlv[28].Cmd = (Vlv[28].OpenReq || Vlv[28].Cmd) && !Vlv[28].CloseReq;
    Vlv[28].Opened = Vlv[28].Cmd && (DI[183] || Vlv[28].Opened);
    Vlv[28].Closed = !Vlv[28].Cmd && !Vlv[28].Opened;
    Vlv[28].Moving = !Vlv[28].Opened && !Vlv[28].Closed;
    Vlv[28].PosErr = (Vlv[28].Moving && DI[213] && DI[49]) || (Vlv[28].PosErr && !DI[69]);
    Vlv[28].Locked = Vlv[28].PosErr && DI[125];

    /* valve V230 */
    Vlv[29].OpenReq = Grp[5].Release && (Mot[27].Run || DI[163]) && !DI[120];
    Vlv[29].CloseReq = !Grp[5].Release || (DI[237] && !Mot[27].Run);
    Vlv[29].Cmd = (Vlv[29].OpenReq || Vlv[29].Cmd) && !Vlv[29].CloseReq;
    Vlv[29].Opened = Vlv[29].Cmd && (DI[181] || Vlv[29].Opened);
    Vlv[29].Closed = !Vlv[29].Cmd && !Vlv[29].Opened;
    Vlv[29].Moving = !Vlv[29].Opened && !Vlv[29].Closed;
    Vlv[29].PosErr = (Vlv[29].Moving && DI[213] && DI[216]) || (Vlv[29].PosErr && !DI[239]);
    Vlv[29].Locked = sr(&VlvLock[14], Vlv[29].PosErr, DI[150] && DI[53]);

    /* valve V231 */
    Vlv[30].OpenReq = Grp[1].Release && (Mot[45].Run || DI[201]) && DI[159];
    Vlv[30].CloseReq = !Grp[1].Release || (DI[191] && !Mot[45].Run);
    Vlv[30].Cmd = (Vlv[30].OpenReq || Vlv[30].Cmd) && !Vlv[30].CloseReq;
    Vlv[30].Opened = Vlv[30].Cmd && (!DI[154] || Vlv[30].Opened);
    Vlv[30].Closed = !Vlv[30].Cmd && !Vlv[30].Opened;
    Vlv[30].Moving = !Vlv[30].Opened && !Vlv[30].Closed;
    Vlv[30].PosErr = (Vlv[30].Moving && DI[98] && DI[47]) || (Vlv[30].PosErr && !DI[166]);
    Vlv[30].Locked = Vlv[30].PosErr && DI[118];

    /* valve V232 */
    Vlv[31].OpenReq = Grp[25].Release && (Mot[3].Run || DI[177]) && !DI[230];
    Vlv[31].CloseReq = !Grp[25].Release || (DI[179] && !Mot[3].Run);
    Vlv[31].Cmd = (Vlv[31].OpenReq || Vlv[31].Cmd) && !Vlv[31].CloseReq;
    Vlv[31].Opened = Vlv[31].Cmd && (!DI[44] || Vlv[31].Opened);
    Vlv[31].Closed = !Vlv[31].Cmd && !Vlv[31].Opened;
    Vlv[31].Moving = !Vlv[31].Opened && !Vlv[31].Closed;
    Vlv[31].PosErr = (Vlv[31].Moving && DI[251] && DI[97]) || (Vlv[31].PosErr && !DI[149]);
    Vlv[31].Locked = sr(&VlvLock[15], Vlv[31].PosErr, DI[203] && DI[71]);

    /* valve V233 */
    Vlv[32].OpenReq = Grp[25].Release && (Mot[122].Run || DI[198]) && !DI[185];
    Vlv[32].CloseReq = !Grp[25].Release || (DI[107] && !Mot[122].Run);
    Vlv[32].Cmd = (Vlv[32].OpenReq || Vlv[32].Cmd) && !Vlv[32].CloseReq;
    Vlv[32].Opened = Vlv[32].Cmd && (!DI[26] || Vlv[32].Opened);
    Vlv[32].Closed = !Vlv[32].Cmd && !Vlv[32].Opened;
    Vlv[32].Moving = !Vlv[32].Opened && !Vlv[32].Closed;
    Vlv[32].PosErr = (Vlv[32].Moving && DI[208] && !DI[162]) || (Vlv[32].PosErr && !DI[65]);
    Vlv[32].Locked = Vlv[32].PosErr && DI[72];

    /* valve V234 */
    Vlv[33].OpenReq = Grp[3].Release && (Mot[70].Run || DI[179]) && DI[63];
    Vlv[33].CloseReq = !Grp[3].Release || (DI[57] && !Mot[70].Run);
    Vlv[33].Cmd = (Vlv[33].OpenReq || Vlv[33].Cmd) && !Vlv[33].CloseReq;
    Vlv[33].Opened = Vlv[33].Cmd && (DI[164] || Vlv[33].Opened);
    Vlv[33].Closed = !Vlv[33].Cmd && !Vlv[33].Opened;
    Vlv[33].Moving = !Vlv[33].Opened && !Vlv[33].Closed;
    Vlv[33].PosErr = (Vlv[33].Moving && DI[56] && DI[228]) || (Vlv[33].PosErr && !DI[153]);
    Vlv[33].Locked = sr(&VlvLock[16], Vlv[33].PosErr, DI[72] && DI[83]);

    /* valve V235 */
    Vlv[34].OpenReq = Grp[28].Release && (Mot[111].Run || DI[90]) && DI[166];
    Vlv[34].CloseReq = !Grp[28].Release || (DI[44] && !Mot[111].Run);
    Vlv[34].Cmd = (Vlv[34].OpenReq || Vlv[34].Cmd) && !Vlv[34].CloseReq;
    Vlv[34].Opened = Vlv[34].Cmd && (DI[2] || Vlv[34].Opened);
    Vlv[34].Closed = !Vlv[34].Cmd && !Vlv[34].Opened;
    Vlv[34].Moving = !Vlv[34].Opened && !Vlv[34].Closed;
    Vlv[34].PosErr = (Vlv[34].Moving && DI[109] && !DI[180]) || (Vlv[34].PosErr && !DI[81]);
    Vlv[34].Locked = Vlv[34].PosErr && DI[18];

    /* valve V236 */
    Vlv[35].OpenReq = Grp[14].Release && (Mot[32].Run || DI[173]) && !DI[136];
    Vlv[35].CloseReq = !Grp[14].Release || (DI[59] && !Mot[32].Run);
    Vlv[35].Cmd = (Vlv[35].OpenReq || Vlv[35].Cmd) && !Vlv[35].CloseReq;
    Vlv[35].Opened = Vlv[35].Cmd && (DI[30] || Vlv[35].Opened);
    Vlv[35].Closed = !Vlv[35].Cmd && !Vlv[35].Opened;
    Vlv[35].Moving = !Vlv[35].Opened && !Vlv[35].Closed;
    Vlv[35].PosErr = (Vlv[35].Moving && DI[15] && !DI[153]) || (Vlv[35].PosErr && !DI[75]);
    Vlv[35].Locked = sr(&VlvLock[17], Vlv[35].PosErr, DI[133] && DI[161]);

    /* valve V237 */
    Vlv[36].OpenReq = Grp[26].Release && (Mot[43].Run || DI[148]) && !DI[159];
    Vlv[36].CloseReq = !Grp[26].Release || (DI[17] && !Mot[43].Run);
    Vlv[36].Cmd = (Vlv[36].OpenReq || Vlv[36].Cmd) && !Vlv[36].CloseReq;
    Vlv[36].Opened = Vlv[36].Cmd && (!DI[194] || Vlv[36].Opened);
    Vlv[36].Closed = !Vlv[36].Cmd && !Vlv[36].Opened;
    Vlv[36].Moving = !Vlv[36].Opened && !Vlv[36].Closed;
    Vlv[36].PosErr = (Vlv[36].Moving && DI[196] && DI[163]) || (Vlv[36].PosErr && !DI[118]);
    Vlv[36].Locked = Vlv[36].PosErr && DI[237];

    /* valve V238 */
    Vlv[37].OpenReq = Grp[19].Release && (Mot[56].Run || DI[49]) && DI[84];
    Vlv[37].CloseReq = !Grp[19].Release || (DI[152] && !Mot[56].Run);
    Vlv[37].Cmd = (Vlv[37].OpenReq || Vlv[37].Cmd) && !Vlv[37].CloseReq;
    Vlv[37].Opened = Vlv[37].Cmd && (!DI[162] || Vlv[37].Opened);
    Vlv[37].Closed = !Vlv[37].Cmd && !Vlv[37].Opened;
    Vlv[37].Moving = !Vlv[37].Opened && !Vlv[37].Closed;
    Vlv[37].PosErr = (Vlv[37].Moving && DI[160] && DI[150]) || (Vlv[37].PosErr && !DI[244]);
    Vlv[37].Locked = sr(&VlvLock[18], Vlv[37].PosErr, DI[222] && DI[44]);

    /* valve V239 */
    Vlv[38].OpenReq = Grp[28].Release && (Mot[102].Run || DI[11]) && DI[204];
    Vlv[38].CloseReq = !Grp[28].Release || (DI[100] && !Mot[102].Run);
    Vlv[38].Cmd = (Vlv[38].OpenReq || Vlv[38].Cmd) && !Vlv[38].CloseReq;
    Vlv[38].Opened = Vlv[38].Cmd && (!DI[0] || Vlv[38].Opened);
    Vlv[38].Closed = !Vlv[38].Cmd && !Vlv[38].Opened;
    Vlv[38].Moving = !Vlv[38].Opened && !Vlv[38].Closed;
    Vlv[38].PosErr = (Vlv[38].Moving && DI[77] && DI[245]) || (Vlv[38].PosErr && !DI[143]);
    Vlv[38].Locked = Vlv[38].PosErr && DI[151];

    /* valve V240 */
    Vlv[39].OpenReq = Grp[11].Release && (Mot[70].Run || DI[185]) && DI[255];
    Vlv[39].CloseReq = !Grp[11].Release || (DI[191] && !Mot[70].Run);
    Vlv[39].Cmd = (Vlv[39].OpenReq || Vlv[39].Cmd) && !Vlv[39].CloseReq;
    Vlv[39].Opened = Vlv[39].Cmd && (!DI[237] || Vlv[39].Opened);
    Vlv[39].Closed = !Vlv[39].Cmd && !Vlv[39].Opened;
    Vlv[39].Moving = !Vlv[39].Opened && !Vlv[39].Closed;
    Vlv[39].PosErr = (Vlv[39].Moving && DI[211] && !DI[172]) || (Vlv[39].PosErr && !DI[196]);
    Vlv[39].Locked = sr(&VlvLock[19], Vlv[39].PosErr, DI[134] && DI[39]);

    /* valve V241 */
    Vlv[40].OpenReq = Grp[7].Release && (Mot[108].Run || DI[66]) && DI[0];
    Vlv[40].CloseReq = !Grp[7].Release || (DI[39] && !Mot[108].Run);
    Vlv[40].Cmd = (Vlv[40].OpenReq || Vlv[40].Cmd) && !Vlv[40].CloseReq;
    Vlv[40].Opened = Vlv[40].Cmd && (!DI[240] || Vlv[40].Opened);
    Vlv[40].Closed = !Vlv[40].Cmd && !Vlv[40].Opened;
    Vlv[40].Moving = !Vlv[40].Opened && !Vlv[40].Closed;
    Vlv[40].PosErr = (Vlv[40].Moving && DI[237] && DI[136]) || (Vlv[40].PosErr && !DI[217]);
    Vlv[40].Locked = Vlv[40].PosErr && DI[48];

    /* valve V242 */
    Vlv[41].OpenReq = Grp[15].Release && (Mot[9].Run || DI[190]) && DI[70];
    Vlv[41].CloseReq = !Grp[15].Release || (DI[83] && !Mot[9].Run);
    Vlv[41].Cmd = (Vlv[41].OpenReq || Vlv[41].Cmd) && !Vlv[41].CloseReq;
    Vlv[41].Opened = Vlv[41].Cmd && (DI[226] || Vlv[41].Opened);
    Vlv[41].Closed = !Vlv[41].Cmd && !Vlv[41].Opened;
    Vlv[41].Moving = !Vlv[41].Opened && !Vlv[41].Closed;
    Vlv[41].PosErr = (Vlv[41].Moving && DI[164] && !DI[233]) || (Vlv[41].PosErr && !DI[71]);
    Vlv[41].Locked = sr(&VlvLock[20], Vlv[41].PosErr, DI[215] && DI[175]);

    /* valve V243 */
    Vlv[42].OpenReq = Grp[29].Release && (Mot[58].Run || DI[66]) && DI[148];
    Vlv[42].CloseReq = !Grp[29].Release || (DI[211] && !Mot[58].Run);
    Vlv[42].Cmd = (Vlv[42].OpenReq || Vlv[42].Cmd) && !Vlv[42].CloseReq;
    Vlv[42].Opened = Vlv[42].Cmd && (!DI[229] || Vlv[42].Opened);
    Vlv[42].Closed = !Vlv[42].Cmd && !Vlv[42].Opened;
    Vlv[42].Moving = !Vlv[42].Opened && !Vlv[42].Closed;
    Vlv[42].PosErr = (Vlv[42].Moving && DI[21] && !DI[75]) || (Vlv[42].PosErr && !DI[111]);
    Vlv[42].Locked = Vlv[42].PosErr && DI[118];

    /* valve V244 */
    Vlv[43].OpenReq = Grp[8].Release && (Mot[67].Run || DI[120]) && !DI[8];
    Vlv[43].CloseReq = !Grp[8].Release || (DI[36] && !Mot[67].Run);
    Vlv[43].Cmd = (Vlv[43].OpenReq || Vlv[43].Cmd) && !Vlv[43].CloseReq;
    Vlv[43].Opened = Vlv[43].Cmd && (DI[140] || Vlv[43].Opened);
    Vlv[43].Closed = !Vlv[43].Cmd && !Vlv[43].Opened;
    Vlv[43].Moving = !Vlv[43].Opened && !Vlv[43].Closed;
    Vlv[43].PosErr = (Vlv[43].Moving && DI[186] && DI[144]) || (Vlv[43].PosErr && !DI[215]);
    Vlv[43].Locked = sr(&VlvLock[21], Vlv[43].PosErr, DI[109] && DI[217]);

    /* valve V245 */
    Vlv[44].OpenReq = Grp[16].Release && (Mot[38].Run || DI[110]) && DI[20];
    Vlv[44].CloseReq = !Grp[16].Release || (DI[234] && !Mot[38].Run);
    Vlv[44].Cmd = (Vlv[44].OpenReq || Vlv[44].Cmd) && !Vlv[44].CloseReq;
    Vlv[44].Opened = Vlv[44].Cmd && (DI[44] || Vlv[44].Opened);
    Vlv[44].Closed = !Vlv[44].Cmd && !Vlv[44].Opened;
    Vlv[44].Moving = !Vlv[44].Opened && !Vlv[44].Closed;
    Vlv[44].PosErr = (Vlv[44].Moving && DI[240] && DI[246]) || (Vlv[44].PosErr && !DI[191]);
    Vlv[44].Locked = Vlv[44].PosErr && DI[112];

    /* valve V246 */
    Vlv[45].OpenReq = Grp[19].Release && (Mot[42].Run || DI[205]) && !DI[58];
    Vlv[45].CloseReq = !Grp[19].Release || (DI[114] && !Mot[42].Run);
    Vlv[45].Cmd = (Vlv[45].OpenReq || Vlv[45].Cmd) && !Vlv[45].CloseReq;
    Vlv[45].Opened = Vlv[45].Cmd && (DI[240] || Vlv[45].Opened);
    Vlv[45].Closed = !Vlv[45].Cmd && !Vlv[45].Opened;
    Vlv[45].Moving = !Vlv[45].Opened && !Vlv[45].Closed;
    Vlv[45].PosErr = (Vlv[45].Moving && DI[116] && !DI[160]) || (Vlv[45].PosErr && !DI[124]);
    Vlv[45].Locked = sr(&VlvLock[22], Vlv[45].PosErr, DI[165] && DI[14]);

    /* valve V247 */
    Vlv[46].OpenReq = Grp[14].Release && (Mot[63].Run || DI[206]) && DI[66];
    Vlv[46].CloseReq = !Grp[14].Release || (DI[52] && !Mot[63].Run);
    Vlv[46].Cmd = (Vlv[46].OpenReq || Vlv[46].Cmd) && !Vlv[46].CloseReq;
    Vlv[46].Opened = Vlv[46].Cmd && (DI[166] || Vlv[46].Opened);
    Vlv[46].Closed = !Vlv[46].Cmd && !Vlv[46].Opened;
    Vlv[46].Moving = !Vlv[46].Opened && !Vlv[46].Closed;
    Vlv[46].PosErr = (Vlv[46].Moving && DI[24] && DI[76]) || (Vlv[46].PosErr && !DI[63]);
    Vlv[46].Locked = Vlv[46].PosErr && DI[198];

    /* valve V248 */
    Vlv[47].OpenReq = Grp[21].Release && (Mot[51].Run || DI[153]) && DI[45];
    Vlv[47].CloseReq = !Grp[21].Release || (DI[253] && !Mot[51].Run);
    Vlv[47].Cmd = (Vlv[47].OpenReq || Vlv[47].Cmd) && !Vlv[47].CloseReq;
    Vlv[47].Opened = Vlv[47].Cmd && (!DI[84] || Vlv[47].Opened);
    Vlv[47].Closed = !Vlv[47].Cmd && !Vlv[47].Opened;
    Vlv[47].Moving = !Vlv[47].Opened && !Vlv[47].Closed;
    Vlv[47].PosErr = (Vlv[47].Moving && DI[178] && DI[134]) || (Vlv[47].PosErr && !DI[251]);
    Vlv[47].Locked = sr(&VlvLock[23], Vlv[47].PosErr, DI[89] && DI[190]);

    /* valve V249 */
    Vlv[48].OpenReq = Grp[28].Release && (Mot[125].Run || DI[200]) && DI[179];
    Vlv[48].CloseReq = !Grp[28].Release || (DI[89] && !Mot[125].Run);
    Vlv[48].Cmd = (Vlv[48].OpenReq || Vlv[48].Cmd) && !Vlv[48].CloseReq;
    Vlv[48].Opened = Vlv[48].Cmd && (DI[255] || Vlv[48].Opened);
    Vlv[48].Closed = !Vlv[48].Cmd && !Vlv[48].Opened;
    Vlv[48].Moving = !Vlv[48].Opened && !Vlv[48].Closed;
    Vlv[48].PosErr = (Vlv[48].Moving && DI[153] && DI[201]) || (Vlv[48].PosErr && !DI[94]);
    Vlv[48].Locked = Vlv[48].PosErr && DI[66];

    /* valve V250 */
    Vlv[49].OpenReq = Grp[26].Release && (Mot[10].Run || DI[121]) && DI[7];
    Vlv[49].CloseReq = !Grp[26].Release || (DI[157] && !Mot[10].Run);
    Vlv[49].Cmd = (Vlv[49].OpenReq || Vlv[49].Cmd) && !Vlv[49].CloseReq;
    Vlv[49].Opened = Vlv[49].Cmd && (DI[210] || Vlv[49].Opened);
    Vlv[49].Closed = !Vlv[49].Cmd && !Vlv[49].Opened;
    Vlv[49].Moving = !Vlv[49].Opened && !Vlv[49].Closed;
    Vlv[49].PosErr = (Vlv[49].Moving && DI[46] && !DI[234]) || (Vlv[49].PosErr && !DI[147]);
    Vlv[49].Locked = sr(&VlvLock[24], Vlv[49].PosErr, DI[178] && DI[75]);

    /* valve V251 */
    Vlv[50].OpenReq = Grp[12].Release && (Mot[37].Run || DI[253]) && !DI[169];
    Vlv[50].CloseReq = !Grp[12].Release || (DI[237] && !Mot[37].Run);
    Vlv[50].Cmd = (Vlv[50].OpenReq || Vlv[50].Cmd) && !Vlv[50].CloseReq;
    Vlv[50].Opened = Vlv[50].Cmd && (!DI[238] || Vlv[50].Opened);
    Vlv[50].Closed = !Vlv[50].Cmd && !Vlv[50].Opened;
    Vlv[50].Moving = !Vlv[50].Opened && !Vlv[50].Closed;
    Vlv[50].PosErr = (Vlv[50].Moving && DI[200] && !DI[234]) || (Vlv[50].PosErr && !DI[187]);
    Vlv[50].Locked = Vlv[50].PosErr && DI[167];

    /* valve V252 */
    Vlv[51].OpenReq = Grp[24].Release && (Mot[93].Run || DI[145]) && DI[56];
    Vlv[51].CloseReq = !Grp[24].Release || (DI[133] && !Mot[93].Run);
    Vlv[51].Cmd = (Vlv[51].OpenReq || Vlv[51].Cmd) && !Vlv[51].CloseReq;
    Vlv[51].Opened = Vlv[51].Cmd && (!DI[122] || Vlv[51].Opened);
    Vlv[51].Closed = !Vlv[51].Cmd && !Vlv[51].Opened;
    Vlv[51].Moving = !Vlv[51].Opened && !Vlv[51].Closed;
    Vlv[51].PosErr = (Vlv[51].Moving && DI[175] && !DI[72]) || (Vlv[51].PosErr && !DI[170]);
    Vlv[51].Locked = sr(&VlvLock[25], Vlv[51].PosErr, DI[91] && DI[110]);

    /* valve V253 */
    Vlv[52].OpenReq = Grp[12].Release && (Mot[92].Run || DI[101]) && DI[115];
    Vlv[52].CloseReq = !Grp[12].Release || (DI[38] && !Mot[92].Run);
    Vlv[52].Cmd = (Vlv[52].OpenReq || Vlv[52].Cmd) && !Vlv[52].CloseReq;
    Vlv[52].Opened = Vlv[52].Cmd && (!DI[61] || Vlv[52].Opened);
    Vlv[52].Closed = !Vlv[52].Cmd && !Vlv[52].Opened;
    Vlv[52].Moving = !Vlv[52].Opened && !Vlv[52].Closed;
    Vlv[52].PosErr = (Vlv[52].Moving && DI[48] && DI[77]) || (Vlv[52].PosErr && !DI[193]);
    Vlv[52].Locked = Vlv[52].PosErr && DI[229];

    /* valve V254 */
    Vlv[53].OpenReq = Grp[15].Release && (Mot[19].Run || DI[207]) && DI[240];
    Vlv[53].CloseReq = !Grp[15].Release || (DI[63] && !Mot[19].Run);
    Vlv[53].Cmd = (Vlv[53].OpenReq || Vlv[53].Cmd) && !Vlv[53].CloseReq;
    Vlv[53].Opened = Vlv[53].Cmd && (DI[236] || Vlv[53].Opened);
    Vlv[53].Closed = !Vlv[53].Cmd && !Vlv[53].Opened;
    Vlv[53].Moving = !Vlv[53].Opened && !Vlv[53].Closed;
    Vlv[53].PosErr = (Vlv[53].Moving && DI[75] && DI[166]) || (Vlv[53].PosErr && !DI[209]);
    Vlv[53].Locked = sr(&VlvLock[26], Vlv[53].PosErr, DI[230] && DI[203]);

    /* valve V255 */
    Vlv[54].OpenReq = Grp[14].Release && (Mot[27].Run || DI[27]) && !DI[59];
    Vlv[54].CloseReq = !Grp[14].Release || (DI[81] && !Mot[27].Run);
    Vlv[54].Cmd = (Vlv[54].OpenReq || Vlv[54].Cmd) && !Vlv[54].CloseReq;
    Vlv[54].Opened = Vlv[54].Cmd && (DI[64] || Vlv[54].Opened);
    Vlv[54].Closed = !Vlv[54].Cmd && !Vlv[54].Opened;
    Vlv[54].Moving = !Vlv[54].Opened && !Vlv[54].Closed;
    Vlv[54].PosErr = (Vlv[54].Moving && DI[233] && !DI[84]) || (Vlv[54].PosErr && !DI[74]);
    Vlv[54].Locked = Vlv[54].PosErr && DI[117];

    /* valve V256 */
    Vlv[55].OpenReq = Grp[22].Release && (Mot[14].Run || DI[211]) && DI[225];
    Vlv[55].CloseReq = !Grp[22].Release || (DI[61] && !Mot[14].Run);
    Vlv[55].Cmd = (Vlv[55].OpenReq || Vlv[55].Cmd) && !Vlv[55].CloseReq;
    Vlv[55].Opened = Vlv[55].Cmd && (DI[58] || Vlv[55].Opened);
    Vlv[55].Closed = !Vlv[55].Cmd && !Vlv[55].Opened;
    Vlv[55].Moving = !Vlv[55].Opened && !Vlv[55].Closed;
    Vlv[55].PosErr = (Vlv[55].Moving && DI[209] && !DI[45]) || (Vlv[55].PosErr && !DI[28]);
    Vlv[55].Locked = sr(&VlvLock[27], Vlv[55].PosErr, DI[234] && DI[20]);

    /* valve V257 */
    Vlv[56].OpenReq = Grp[22].Release && (Mot[19].Run || DI[125]) && DI[114];
    Vlv[56].CloseReq = !Grp[22].Release || (DI[144] && !Mot[19].Run);
    Vlv[56].Cmd = (Vlv[56].OpenReq || Vlv[56].Cmd) && !Vlv[56].CloseReq;
    Vlv[56].Opened = Vlv[56].Cmd && (!DI[128] || Vlv[56].Opened);
    Vlv[56].Closed = !Vlv[56].Cmd && !Vlv[56].Opened;
    Vlv[56].Moving = !Vlv[56].Opened && !Vlv[56].Closed;
    Vlv[56].PosErr = (Vlv[56].Moving && DI[192] && DI[141]) || (Vlv[56].PosErr && !DI[39]);
    Vlv[56].Locked = Vlv[56].PosErr && DI[111];

    /* valve V258 */
    Vlv[57].OpenReq = Grp[18].Release && (Mot[95].Run || DI[13]) && DI[247];
    Vlv[57].CloseReq = !Grp[18].Release || (DI[244] && !Mot[95].Run);
    Vlv[57].Cmd = (Vlv[57].OpenReq || Vlv[57].Cmd) && !Vlv[57].CloseReq;
    Vlv[57].Opened = Vlv[57].Cmd && (DI[80] || Vlv[57].Opened);
    Vlv[57].Closed = !Vlv[57].Cmd && !Vlv[57].Opened;
    Vlv[57].Moving = !Vlv[57].Opened && !Vlv[57].Closed;
    Vlv[57].PosErr = (Vlv[57].Moving && DI[124] && DI[14]) || (Vlv[57].PosErr && !DI[99]);
    Vlv[57].Locked = sr(&VlvLock[28], Vlv[57].PosErr, DI[215] && DI[208]);

    /* valve V259 */
    Vlv[58].OpenReq = Grp[8].Release && (Mot[112].Run || DI[183]) && DI[22];
    Vlv[58].CloseReq = !Grp[8].Release || (DI[122] && !Mot[112].Run);
    Vlv[58].Cmd = (Vlv[58].OpenReq || Vlv[58].Cmd) && !Vlv[58].CloseReq;
    Vlv[58].Opened = Vlv[58].Cmd && (!DI[53] || Vlv[58].Opened);
    Vlv[58].Closed = !Vlv[58].Cmd && !Vlv[58].Opened;
    Vlv[58].Moving = !Vlv[58].Opened && !Vlv[58].Closed;
    Vlv[58].PosErr = (Vlv[58].Moving && DI[27] && DI[98]) || (Vlv[58].PosErr && !DI[41]);
    Vlv[58].Locked = Vlv[58].PosErr && DI[224];

    /* valve V260 */
    Vlv[59].OpenReq = Grp[11].Release && (Mot[125].Run || DI[200]) && !DI[78];
    Vlv[59].CloseReq = !Grp[11].Release || (DI[181] && !Mot[125].Run);
    Vlv[59].Cmd = (Vlv[59].OpenReq || Vlv[59].Cmd) && !Vlv[59].CloseReq;
    Vlv[59].Opened = Vlv[59].Cmd && (DI[188] || Vlv[59].Opened);
    Vlv[59].Closed = !Vlv[59].Cmd && !Vlv[59].Opened;
    Vlv[59].Moving = !Vlv[59].Opened && !Vlv[59].Closed;
    Vlv[59].PosErr = (Vlv[59].Moving && DI[142] && DI[130]) || (Vlv[59].PosErr && !DI[203]);
    Vlv[59].Locked = sr(&VlvLock[29], Vlv[59].PosErr, DI[13] && DI[108]);

    /* valve V261 */
    Vlv[60].OpenReq = Grp[29].Release && (Mot[16].Run || DI[232]) && !DI[41];
    Vlv[60].CloseReq = !Grp[29].Release || (DI[171] && !Mot[16].Run);
    Vlv[60].Cmd = (Vlv[60].OpenReq || Vlv[60].Cmd) && !Vlv[60].CloseReq;
    Vlv[60].Opened = Vlv[60].Cmd && (!DI[218] || Vlv[60].Opened);
    Vlv[60].Closed = !Vlv[60].Cmd && !Vlv[60].Opened;
    Vlv[60].Moving = !Vlv[60].Opened && !Vlv[60].Closed;
    Vlv[60].PosErr = (Vlv[60].Moving && DI[36] && DI[238]) || (Vlv[60].PosErr && !DI[130]);
    Vlv[60].Locked = Vlv[60].PosErr && DI[95];

    /* valve V262 */
    Vlv[61].OpenReq = Grp[11].Release && (Mot[121].Run || DI[168]) && !DI[60];
    Vlv[61].CloseReq = !Grp[11].Release || (DI[30] && !Mot[121].Run);
    Vlv[61].Cmd = (Vlv[61].OpenReq || Vlv[61].Cmd) && !Vlv[61].CloseReq;
    Vlv[61].Opened = Vlv[61].Cmd && (DI[78] || Vlv[61].Opened);
    Vlv[61].Closed = !Vlv[61].Cmd && !Vlv[61].Opened;
    Vlv[61].Moving = !Vlv[61].Opened && !Vlv[61].Closed;
    Vlv[61].PosErr = (Vlv[61].Moving && DI[6] && !DI[78]) || (Vlv[61].PosErr && !DI[70]);
    Vlv[61].Locked = sr(&VlvLock[30], Vlv[61].PosErr, DI[133] && DI[98]);

    /* valve V263 */
    Vlv[62].OpenReq = Grp[19].Release && (Mot[107].Run || DI[191]) && DI[15];
    Vlv[62].CloseReq = !Grp[19].Release || (DI[150] && !Mot[107].Run);
    Vlv[62].Cmd = (Vlv[62].OpenReq || Vlv[62].Cmd) && !Vlv[62].CloseReq;
    Vlv[62].Opened = Vlv[62].Cmd && (DI[133] || Vlv[62].Opened);
    Vlv[62].Closed = !Vlv[62].Cmd && !Vlv[62].Opened;
    Vlv[62].Moving = !Vlv[62].Opened && !Vlv[62].Closed;
    Vlv[62].PosErr = (Vlv[62].Moving && DI[241] && DI[45]) || (Vlv[62].PosErr && !DI[6]);
    Vlv[62].Locked = Vlv[62].PosErr && DI[197];

    /* valve V264 */
    Vlv[63].OpenReq = Grp[19].Release && (Mot[94].Run || DI[215]) && DI[69];
    Vlv[63].CloseReq = !Grp[19].Release || (DI[251] && !Mot[94].Run);
    Vlv[63].Cmd = (Vlv[63].OpenReq || Vlv[63].Cmd) && !Vlv[63].CloseReq;
    Vlv[63].Opened = Vlv[63].Cmd && (DI[207] || Vlv[63].Opened);
    Vlv[63].Closed = !Vlv[63].Cmd && !Vlv[63].Opened;
    Vlv[63].Moving = !Vlv[63].Opened && !Vlv[63].Closed;
    Vlv[63].PosErr = (Vlv[63].Moving && DI[206] && !DI[179]) || (Vlv[63].PosErr && !DI[148]);
    Vlv[63].Locked = sr(&VlvLock[31], Vlv[63].PosErr, DI[146] && DI[166]);

    /* valve V265 */
    Vlv[64].OpenReq = Grp[6].Release && (Mot[30].Run || DI[242]) && !DI[209];
    Vlv[64].CloseReq = !Grp[6].Release || (DI[202] && !Mot[30].Run);
    Vlv[64].Cmd = (Vlv[64].OpenReq || Vlv[64].Cmd) && !Vlv[64].CloseReq;
    Vlv[64].Opened = Vlv[64].Cmd && (DI[112] || Vlv[64].Opened);
    Vlv[64].Closed = !Vlv[64].Cmd && !Vlv[64].Opened;
    Vlv[64].Moving = !Vlv[64].Opened && !Vlv[64].Closed;
    Vlv[64].PosErr = (Vlv[64].Moving && DI[227] && !DI[255]) || (Vlv[64].PosErr && !DI[26]);
    Vlv[64].Locked = Vlv[64].PosErr && DI[172];

    /* valve V266 */
    Vlv[65].OpenReq = Grp[5].Release && (Mot[32].Run || DI[169]) && !DI[217];
    Vlv[65].CloseReq = !Grp[5].Release || (DI[159] && !Mot[32].Run);
    Vlv[65].Cmd = (Vlv[65].OpenReq || Vlv[65].Cmd) && !Vlv[65].CloseReq;
    Vlv[65].Opened = Vlv[65].Cmd && (!DI[229] || Vlv[65].Opened);
    Vlv[65].Closed = !Vlv[65].Cmd && !Vlv[65].Opened;
    Vlv[65].Moving = !Vlv[65].Opened && !Vlv[65].Closed;
    Vlv[65].PosErr = (Vlv[65].Moving && DI[223] && DI[146]) || (Vlv[65].PosErr && !DI[44]);
    Vlv[65].Locked = sr(&VlvLock[32], Vlv[65].PosErr, DI[232] && DI[243]);

    /* valve V267 */
    Vlv[66].OpenReq = Grp[0].Release && (Mot[22].Run || DI[17]) && !DI[224];
    Vlv[66].CloseReq = !Grp[0].Release || (DI[32] && !Mot[22].Run);
    Vlv[66].Cmd = (Vlv[66].OpenReq || Vlv[66].Cmd) && !Vlv[66].CloseReq;
    Vlv[66].Opened = Vlv[66].Cmd && (!DI[58] || Vlv[66].Opened);
    Vlv[66].Closed = !Vlv[66].Cmd && !Vlv[66].Opened;
    Vlv[66].Moving = !Vlv[66].Opened && !Vlv[66].Closed;
    Vlv[66].PosErr = (Vlv[66].Moving && DI[60] && DI[211]) || (Vlv[66].PosErr && !DI[9]);
    Vlv[66].Locked = Vlv[66].PosErr && DI[109];

    /* valve V268 */
    Vlv[67].OpenReq = Grp[24].Release && (Mot[95].Run || DI[167]) && !DI[81];
    Vlv[67].CloseReq = !Grp[24].Release || (DI[45] && !Mot[95].Run);
    Vlv[67].Cmd = (Vlv[67].OpenReq || Vlv[67].Cmd) && !Vlv[67].CloseReq;
    Vlv[67].Opened = Vlv[67].Cmd && (DI[15] || Vlv[67].Opened);
    Vlv[67].Closed = !Vlv[67].Cmd && !Vlv[67].Opened;
    Vlv[67].Moving = !Vlv[67].Opened && !Vlv[67].Closed;
    Vlv[67].PosErr = (Vlv[67].Moving && DI[63] && DI[7]) || (Vlv[67].PosErr && !DI[198]);
    Vlv[67].Locked = sr(&VlvLock[33], Vlv[67].PosErr, DI[127] && DI[220]);

    /* valve V269 */
    Vlv[68].OpenReq = Grp[15].Release && (Mot[65].Run || DI[115]) && DI[199];
    Vlv[68].CloseReq = !Grp[15].Release || (DI[207] && !Mot[65].Run);
    Vlv[68].Cmd = (Vlv[68].OpenReq || Vlv[68].Cmd) && !Vlv[68].CloseReq;
    Vlv[68].Opened = Vlv[68].Cmd && (DI[166] || Vlv[68].Opened);
    Vlv[68].Closed = !Vlv[68].Cmd && !Vlv[68].Opened;
    Vlv[68].Moving = !Vlv[68].Opened && !Vlv[68].Closed;
    Vlv[68].PosErr = (Vlv[68].Moving && DI[138] && !DI[234]) || (Vlv[68].PosErr && !DI[2]);
    Vlv[68].Locked = Vlv[68].PosErr && DI[78];

    /* valve V270 */
    Vlv[69].OpenReq = Grp[20].Release && (Mot[7].Run || DI[52]) && !DI[229];
    Vlv[69].CloseReq = !Grp[20].Release || (DI[27] && !Mot[7].Run);
    Vlv[69].Cmd = (Vlv[69].OpenReq || Vlv[69].Cmd) && !Vlv[69].CloseReq;
    Vlv[69].Opened = Vlv[69].Cmd && (DI[169] || Vlv[69].Opened);
    Vlv[69].Closed = !Vlv[69].Cmd && !Vlv[69].Opened;
    Vlv[69].Moving = !Vlv[69].Opened && !Vlv[69].Closed;
    Vlv[69].PosErr = (Vlv[69].Moving && DI[58] && !DI[4]) || (Vlv[69].PosErr && !DI[113]);
    Vlv[69].Locked = sr(&VlvLock[34], Vlv[69].PosErr, DI[76] && DI[216]);

    /* valve V271 */
    Vlv[70].OpenReq = Grp[22].Release && (Mot[75].Run || DI[87]) && DI[254];
    Vlv[70].CloseReq = !Grp[22].Release || (DI[56] && !Mot[75].Run);
    Vlv[70].Cmd = (Vlv[70].OpenReq || Vlv[70].Cmd) && !Vlv[70].CloseReq;
    Vlv[70].Opened = Vlv[70].Cmd && (DI[88] || Vlv[70].Opened);
    Vlv[70].Closed = !Vlv[70].Cmd && !Vlv[70].Opened;
    Vlv[70].Moving = !Vlv[70].Opened && !Vlv[70].Closed;
    Vlv[70].PosErr = (Vlv[70].Moving && DI[177] && !DI[149]) || (Vlv[70].PosErr && !DI[77]);
    Vlv[70].Locked = Vlv[70].PosErr && DI[244];

    /* valve V272 */
    Vlv[71].OpenReq = Grp[17].Release && (Mot[123].Run || DI[188]) && !DI[249];
    Vlv[71].CloseReq = !Grp[17].Release || (DI[137] && !Mot[123].Run);
    Vlv[71].Cmd = (Vlv[71].OpenReq || Vlv[71].Cmd) && !Vlv[71].CloseReq;
    Vlv[71].Opened = Vlv[71].Cmd && (!DI[91] || Vlv[71].Opened);
    Vlv[71].Closed = !Vlv[71].Cmd && !Vlv[71].Opened;
    Vlv[71].Moving = !Vlv[71].Opened && !Vlv[71].Closed;
    Vlv[71].PosErr = (Vlv[71].Moving && DI[4] && DI[97]) || (Vlv[71].PosErr && !DI[245]);
    Vlv[71].Locked = sr(&VlvLock[35], Vlv[71].PosErr, DI[40] && DI[82]);

    /* valve V273 */
    Vlv[72].OpenReq = Grp[5].Release && (Mot[6].Run || DI[77]) && !DI[94];
    Vlv[72].CloseReq = !Grp[5].Release || (DI[43] && !Mot[6].Run);
    Vlv[72].Cmd = (Vlv[72].OpenReq || Vlv[72].Cmd) && !Vlv[72].CloseReq;
    Vlv[72].Opened = Vlv[72].Cmd && (DI[47] || Vlv[72].Opened);
    Vlv[72].Closed = !Vlv[72].Cmd && !Vlv[72].Opened;
    Vlv[72].Moving = !Vlv[72].Opened && !Vlv[72].Closed;
    Vlv[72].PosErr = (Vlv[72].Moving && DI[74] && !DI[240]) || (Vlv[72].PosErr && !DI[251]);
    Vlv[72].Locked = Vlv[72].PosErr && DI[63];

    /* valve V274 */
    Vlv[73].OpenReq = Grp[5].Release && (Mot[6].Run || DI[52]) && !DI[218];
    Vlv[73].CloseReq = !Grp[5].Release || (DI[144] && !Mot[6].Run);
    Vlv[73].Cmd = (Vlv[73].OpenReq || Vlv[73].Cmd) && !Vlv[73].CloseReq;
    Vlv[73].Opened = Vlv[73].Cmd && (DI[251] || Vlv[73].Opened);
    Vlv[73].Closed = !Vlv[73].Cmd && !Vlv[73].Opened;
    Vlv[73].Moving = !Vlv[73].Opened && !Vlv[73].Closed;
    Vlv[73].PosErr = (Vlv[73].Moving && DI[22] && !DI[123]) || (Vlv[73].PosErr && !DI[108]);
    Vlv[73].Locked = sr(&VlvLock[36], Vlv[73].PosErr, DI[32] && DI[139]);

    /* valve V275 */
    Vlv[74].OpenReq = Grp[6].Release && (Mot[65].Run || DI[105]) && DI[183];
    Vlv[74].CloseReq = !Grp[6].Release || (DI[38] && !Mot[65].Run);
    Vlv[74].Cmd = (Vlv[74].OpenReq || Vlv[74].Cmd) && !Vlv[74].CloseReq;
    Vlv[74].Opened = Vlv[74].Cmd && (DI[226] || Vlv[74].Opened);
    Vlv[74].Closed = !Vlv[74].Cmd && !Vlv[74].Opened;
    Vlv[74].Moving = !Vlv[74].Opened && !Vlv[74].Closed;
    Vlv[74].PosErr = (Vlv[74].Moving && DI[44] && DI[168]) || (Vlv[74].PosErr && !DI[188]);
    Vlv[74].Locked = Vlv[74].PosErr && DI[254];

    /* valve V276 */
    Vlv[75].OpenReq = Grp[21].Release && (Mot[29].Run || DI[153]) && !DI[184];
    Vlv[75].CloseReq = !Grp[21].Release || (DI[183] && !Mot[29].Run);
    Vlv[75].Cmd = (Vlv[75].OpenReq || Vlv[75].Cmd) && !Vlv[75].CloseReq;
    Vlv[75].Opened = Vlv[75].Cmd && (DI[17] || Vlv[75].Opened);
    Vlv[75].Closed = !Vlv[75].Cmd && !Vlv[75].Opened;
    Vlv[75].Moving = !Vlv[75].Opened && !Vlv[75].Closed;
    Vlv[75].PosErr = (Vlv[75].Moving && DI[131] && DI[80]) || (Vlv[75].PosErr && !DI[145]);
    Vlv[75].Locked = sr(&VlvLock[37], Vlv[75].PosErr, DI[20] && DI[129]);

    /* valve V277 */
    Vlv[76].OpenReq = Grp[19].Release && (Mot[71].Run || DI[227]) && DI[230];
    Vlv[76].CloseReq = !Grp[19].Release || (DI[82] && !Mot[71].Run);
    Vlv[76].Cmd = (Vlv[76].OpenReq || Vlv[76].Cmd) && !Vlv[76].CloseReq;
    Vlv[76].Opened = Vlv[76].Cmd && (DI[79] || Vlv[76].Opened);
    Vlv[76].Closed = !Vlv[76].Cmd && !Vlv[76].Opened;
    Vlv[76].Moving = !Vlv[76].Opened && !Vlv[76].Closed;
    Vlv[76].PosErr = (Vlv[76].Moving && DI[210] && !DI[143]) || (Vlv[76].PosErr && !DI[105]);
    Vlv[76].Locked = Vlv[76].PosErr && DI[57];

    /* valve V278 */
    Vlv[77].OpenReq = Grp[20].Release && (Mot[13].Run || DI[222]) && DI[140];
    Vlv[77].CloseReq = !Grp[20].Release || (DI[75] && !Mot[13].Run);
    Vlv[77].Cmd = (Vlv[77].OpenReq || Vlv[77].Cmd) && !Vlv[77].CloseReq;
    Vlv[77].Opened = Vlv[77].Cmd && (DI[6] || Vlv[77].Opened);
    Vlv[77].Closed = !Vlv[77].Cmd && !Vlv[77].Opened;
    Vlv[77].Moving = !Vlv[77].Opened && !Vlv[77].Closed;
    Vlv[77].PosErr = (Vlv[77].Moving && DI[205] && DI[172]) || (Vlv[77].PosErr && !DI[80]);
    Vlv[77].Locked = sr(&VlvLock[38], Vlv[77].PosErr, DI[129] && DI[76]);

    /* valve V279 */
    Vlv[78].OpenReq = Grp[11].Release && (Mot[35].Run || DI[166]) && !DI[109];
    Vlv[78].CloseReq = !Grp[11].Release || (DI[249] && !Mot[35].Run);
    Vlv[78].Cmd = (Vlv[78].OpenReq || Vlv[78].Cmd) && !Vlv[78].CloseReq;
    Vlv[78].Opened = Vlv[78].Cmd && (DI[64] || Vlv[78].Opened);
    Vlv[78].Closed = !Vlv[78].Cmd && !Vlv[78].Opened;
    Vlv[78].Moving = !Vlv[78].Opened && !Vlv[78].Closed;
    Vlv[78].PosErr = (Vlv[78].Moving && DI[105] && !DI[238]) || (Vlv[78].PosErr && !DI[132]);
    Vlv[78].Locked = Vlv[78].PosErr && DI[81];

    /* valve V280 */
    Vlv[79].OpenReq = Grp[13].Release && (Mot[92].Run || DI[50]) && DI[85];
    Vlv[79].CloseReq = !Grp[13].Release || (DI[25] && !Mot[92].Run);
    Vlv[79].Cmd = (Vlv[79].OpenReq || Vlv[79].Cmd) && !Vlv[79].CloseReq;
    Vlv[79].Opened = Vlv[79].Cmd && (DI[49] || Vlv[79].Opened);
    Vlv[79].Closed = !Vlv[79].Cmd && !Vlv[79].Opened;
    Vlv[79].Moving = !Vlv[79].Opened && !Vlv[79].Closed;
    Vlv[79].PosErr = (Vlv[79].Moving && DI[85] && !DI[97]) || (Vlv[79].PosErr && !DI[61]);
    Vlv[79].Locked = sr(&VlvLock[39], Vlv[79].PosErr, DI[32] && DI[136]);

    /* valve V281 */
    Vlv[80].OpenReq = Grp[29].Release && (Mot[57].Run || DI[169]) && !DI[230];
    Vlv[80].CloseReq = !Grp[29].Release || (DI[243] && !Mot[57].Run);
    Vlv[80].Cmd = (Vlv[80].OpenReq || Vlv[80].Cmd) && !Vlv[80].CloseReq;
    Vlv[80].Opened = Vlv[80].Cmd && (!DI[136] || Vlv[80].Opened);
    Vlv[80].Closed = !Vlv[80].Cmd && !Vlv[80].Opened;
    Vlv[80].Moving = !Vlv[80].Opened && !Vlv[80].Closed;
    Vlv[80].PosErr = (Vlv[80].Moving && DI[201] && !DI[67]) || (Vlv[80].PosErr && !DI[142]);
    Vlv[80].Locked = Vlv[80].PosErr && DI[249];

    /* valve V282 */
    Vlv[81].OpenReq = Grp[5].Release && (Mot[96].Run || DI[13]) && DI[131];
    Vlv[81].CloseReq = !Grp[5].Release || (DI[100] && !Mot[96].Run);
    Vlv[81].Cmd = (Vlv[81].OpenReq || Vlv[81].Cmd) && !Vlv[81].CloseReq;
    Vlv[81].Opened = Vlv[81].Cmd && (DI[47] || Vlv[81].Opened);
    Vlv[81].Closed = !Vlv[81].Cmd && !Vlv[81].Opened;
    Vlv[81].Moving = !Vlv[81].Opened && !Vlv[81].Closed;
    Vlv[81].PosErr = (Vlv[81].Moving && DI[6] && !DI[126]) || (Vlv[81].PosErr && !DI[156]);
    Vlv[81].Locked = sr(&VlvLock[40], Vlv[81].PosErr, DI[59] && DI[119]);

    /* valve V283 */
    Vlv[82].OpenReq = Grp[26].Release && (Mot[43].Run || DI[178]) && !DI[62];
    Vlv[82].CloseReq = !Grp[26].Release || (DI[245] && !Mot[43].Run);
    Vlv[82].Cmd = (Vlv[82].OpenReq || Vlv[82].Cmd) && !Vlv[82].CloseReq;
    Vlv[82].Opened = Vlv[82].Cmd && (DI[38] || Vlv[82].Opened);
    Vlv[82].Closed = !Vlv[82].Cmd && !Vlv[82].Opened;
    Vlv[82].Moving = !Vlv[82].Opened && !Vlv[82].Closed;
    Vlv[82].PosErr = (Vlv[82].Moving && DI[26] && DI[94]) || (Vlv[82].PosErr && !DI[95]);
    Vlv[82].Locked = Vlv[82].PosErr && DI[151];

    /* valve V284 */
    Vlv[83].OpenReq = Grp[26].Release && (Mot[23].Run || DI[70]) && !DI[167];
    Vlv[83].CloseReq = !Grp[26].Release || (DI[153] && !Mot[23].Run);
    Vlv[83].Cmd = (Vlv[83].OpenReq || Vlv[83].Cmd) && !Vlv[83].CloseReq;
    Vlv[83].Opened = Vlv[83].Cmd && (!DI[35] || Vlv[83].Opened);
    Vlv[83].Closed = !Vlv[83].Cmd && !Vlv[83].Opened;
    Vlv[83].Moving = !Vlv[83].Opened && !Vlv[83].Closed;
    Vlv[83].PosErr = (Vlv[83].Moving && DI[226] && !DI[89]) || (Vlv[83].PosErr && !DI[3]);
    Vlv[83].Locked = sr(&VlvLock[41], Vlv[83].PosErr, DI[207] && DI[102]);

    /* valve V285 */
    Vlv[84].OpenReq = Grp[27].Release && (Mot[56].Run || DI[213]) && !DI[49];
    Vlv[84].CloseReq = !Grp[27].Release || (DI[71] && !Mot[56].Run);
    Vlv[84].Cmd = (Vlv[84].OpenReq || Vlv[84].Cmd) && !Vlv[84].CloseReq;
    Vlv[84].Opened = Vlv[84].Cmd && (DI[170] || Vlv[84].Opened);
    Vlv[84].Closed = !Vlv[84].Cmd && !Vlv[84].Opened;
    Vlv[84].Moving = !Vlv[84].Opened && !Vlv[84].Closed;
    Vlv[84].PosErr = (Vlv[84].Moving && DI[84] && DI[203]) || (Vlv[84].PosErr && !DI[246]);
    Vlv[84].Locked = Vlv[84].PosErr && DI[132];

    /* valve V286 */
    Vlv[85].OpenReq = Grp[21].Release && (Mot[63].Run || DI[100]) && DI[44];
    Vlv[85].CloseReq = !Grp[21].Release || (DI[137] && !Mot[63].Run);
    Vlv[85].Cmd = (Vlv[85].OpenReq || Vlv[85].Cmd) && !Vlv[85].CloseReq;
    Vlv[85].Opened = Vlv[85].Cmd && (!DI[104] || Vlv[85].Opened);
    Vlv[85].Closed = !Vlv[85].Cmd && !Vlv[85].Opened;
    Vlv[85].Moving = !Vlv[85].Opened && !Vlv[85].Closed;
    Vlv[85].PosErr = (Vlv[85].Moving && DI[193] && DI[120]) || (Vlv[85].PosErr && !DI[184]);
    Vlv[85].Locked = sr(&VlvLock[42], Vlv[85].PosErr, DI[207] && DI[81]);

    /* valve V287 */
    Vlv[86].OpenReq = Grp[2].Release && (Mot[81].Run || DI[228]) && !DI[60];
    Vlv[86].CloseReq = !Grp[2].Release || (DI[198] && !Mot[81].Run);
    Vlv[86].Cmd = (Vlv[86].OpenReq || Vlv[86].Cmd) && !Vlv[86].CloseReq;
    Vlv[86].Opened = Vlv[86].Cmd && (DI[194] || Vlv[86].Opened);
    Vlv[86].Closed = !Vlv[86].Cmd && !Vlv[86].Opened;
    Vlv[86].Moving = !Vlv[86].Opened && !Vlv[86].Closed;
    Vlv[86].PosErr = (Vlv[86].Moving && DI[10] && DI[11]) || (Vlv[86].PosErr && !DI[46]);
    Vlv[86].Locked = Vlv[86].PosErr && DI[160];

    /* valve V288 */
    Vlv[87].OpenReq = Grp[6].Release && (Mot[118].Run || DI[163]) && !DI[153];
    Vlv[87].CloseReq = !Grp[6].Release || (DI[37] && !Mot[118].Run);
    Vlv[87].Cmd = (Vlv[87].OpenReq || Vlv[87].Cmd) && !Vlv[87].CloseReq;
    Vlv[87].Opened = Vlv[87].Cmd && (!DI[219] || Vlv[87].Opened);
    Vlv[87].Closed = !Vlv[87].Cmd && !Vlv[87].Opened;
    Vlv[87].Moving = !Vlv[87].Opened && !Vlv[87].Closed;
    Vlv[87].PosErr = (Vlv[87].Moving && DI[179] && DI[135]) || (Vlv[87].PosErr && !DI[12]);
    Vlv[87].Locked = sr(&VlvLock[43], Vlv[87].PosErr, DI[71] && DI[241]);

    /* valve V289 */
    Vlv[88].OpenReq = Grp[0].Release && (Mot[53].Run || DI[178]) && DI[194];
    Vlv[88].CloseReq = !Grp[0].Release || (DI[88] && !Mot[53].Run);
    Vlv[88].Cmd = (Vlv[88].OpenReq || Vlv[88].Cmd) && !Vlv[88].CloseReq;
    Vlv[88].Opened = Vlv[88].Cmd && (DI[43] || Vlv[88].Opened);
    Vlv[88].Closed = !Vlv[88].Cmd && !Vlv[88].Opened;
    Vlv[88].Moving = !Vlv[88].Opened && !Vlv[88].Closed;
    Vlv[88].PosErr = (Vlv[88].Moving && DI[73] && !DI[204]) || (Vlv[88].PosErr && !DI[107]);
    Vlv[88].Locked = Vlv[88].PosErr && DI[204];

    /* valve V290 */
    Vlv[89].OpenReq = Grp[14].Release && (Mot[33].Run || DI[70]) && DI[92];
    Vlv[89].CloseReq = !Grp[14].Release || (DI[61] && !Mot[33].Run);
    Vlv[89].Cmd = (Vlv[89].OpenReq || Vlv[89].Cmd) && !Vlv[89].CloseReq;
    Vlv[89].Opened = Vlv[89].Cmd && (!DI[39] || Vlv[89].Opened);
    Vlv[89].Closed = !Vlv[89].Cmd && !Vlv[89].Opened;
    Vlv[89].Moving = !Vlv[89].Opened && !Vlv[89].Closed;
    Vlv[89].PosErr = (Vlv[89].Moving && DI[212] && !DI[158]) || (Vlv[89].PosErr && !DI[17]);
    Vlv[89].Locked = sr(&VlvLock[44], Vlv[89].PosErr, DI[214] && DI[134]);

    /* alarms 0 and following */
    Alm[0].Active = Vlv[28].Locked && DI[91];
    Alm[0].Unack = sr(&AlmUnack[0], Alm[0].Active && !Alm[0].Old, AckAll || DI[120]);
    Alm[0].Horn = Alm[0].Unack && !HornOff;
    Alm[0].Old = Alm[0].Active;
    Alm[1].Active = !Grp[29].EStopOk && !DI[139];
    Alm[1].Unack = sr(&AlmUnack[1], Alm[1].Active && !Alm[1].Old, AckAll || DI[2]);
    Alm[1].Horn = Alm[1].Unack && !HornOff;
    Alm[1].Old = Alm[1].Active;
    Alm[2].Active = Mot[3].Fault && !DI[76];
    Alm[2].Unack = sr(&AlmUnack[2], Alm[2].Active && !Alm[2].Old, AckAll || DI[89]);
    Alm[2].Horn = Alm[2].Unack && !HornOff;
    Alm[2].Old = Alm[2].Active;
    Alm[3].Active = Mot[39].FbkErr && !DI[105];
    Alm[3].Unack = sr(&AlmUnack[3], Alm[3].Active && !Alm[3].Old, AckAll || DI[130]);
    Alm[3].Horn = Alm[3].Unack && !HornOff;
    Alm[3].Old = Alm[3].Active;
    Alm[4].Active = Mot[89].FbkErr && DI[87];
    Alm[4].Unack = sr(&AlmUnack[4], Alm[4].Active && !Alm[4].Old, AckAll || DI[222]);
    Alm[4].Horn = Alm[4].Unack && !HornOff;
    Alm[4].Old = Alm[4].Active;
    Alm[5].Active = Vlv[61].Locked && !DI[47];
    Alm[5].Unack = sr(&AlmUnack[5], Alm[5].Active && !Alm[5].Old, AckAll || DI[117]);
    Alm[5].Horn = Alm[5].Unack && !HornOff;
    Alm[5].Old = Alm[5].Active;
    Alm[6].Active = !Grp[16].EStopOk && DI[226];
    Alm[6].Unack = sr(&AlmUnack[6], Alm[6].Active && !Alm[6].Old, AckAll || DI[249]);
    Alm[6].Horn = Alm[6].Unack && !HornOff;
    Alm[6].Old = Alm[6].Active;
    Alm[7].Active = Mot[91].Fault && !DI[7];
    Alm[7].Unack = sr(&AlmUnack[7], Alm[7].Active && !Alm[7].Old, AckAll || DI[209]);
    Alm[7].Horn = Alm[7].Unack && !HornOff;
    Alm[7].Old = Alm[7].Active;
    Alm[8].Active = Vlv[82].PosErr && DI[195];
    Alm[8].Unack = sr(&AlmUnack[8], Alm[8].Active && !Alm[8].Old, AckAll || DI[238]);
    Alm[8].Horn = Alm[8].Unack && !HornOff;
    Alm[8].Old = Alm[8].Active;
    Alm[9].Active = !Grp[13].EStopOk && DI[130];
    Alm[9].Unack = sr(&AlmUnack[9], Alm[9].Active && !Alm[9].Old, AckAll || DI[248]);
    Alm[9].Horn = Alm[9].Unack && !HornOff;
    Alm[9].Old = Alm[9].Active;
    Alm[10].Active = !Grp[12].EStopOk && DI[112];
    Alm[10].Unack = sr(&AlmUnack[10], Alm[10].Active && !Alm[10].Old, AckAll || DI[207]);
    Alm[10].Horn = Alm[10].Unack && !HornOff;
    Alm[10].Old = Alm[10].Active;
    Alm[11].Active = Vlv[43].PosErr && DI[6];
    Alm[11].Unack = sr(&AlmUnack[11], Alm[11].Active && !Alm[11].Old, AckAll || DI[235]);
    Alm[11].Horn = Alm[11].Unack && !HornOff;
    Alm[11].Old = Alm[11].Active;
    Alm[12].Active = Vlv[56].Locked && !DI[21];
    Alm[12].Unack = sr(&AlmUnack[12], Alm[12].Active && !Alm[12].Old, AckAll || DI[61]);
    Alm[12].Horn = Alm[12].Unack && !HornOff;
    Alm[12].Old = Alm[12].Active;
    Alm[13].Active = Mot[83].Fault && !DI[91];
    Alm[13].Unack = sr(&AlmUnack[13], Alm[13].Active && !Alm[13].Old, AckAll || DI[65]);
    Alm[13].Horn = Alm[13].Unack && !HornOff;
    Alm[13].Old = Alm[13].Active;
    Alm[14].Active = Vlv[21].PosErr && !DI[100];
    Alm[14].Unack = sr(&AlmUnack[14], Alm[14].Active && !Alm[14].Old, AckAll || DI[55]);
    Alm[14].Horn = Alm[14].Unack && !HornOff;
    Alm[14].Old = Alm[14].Active;
    Alm[15].Active = Mot[95].Fault && !DI[216];
    Alm[15].Unack = sr(&AlmUnack[15], Alm[15].Active && !Alm[15].Old, AckAll || DI[211]);
    Alm[15].Horn = Alm[15].Unack && !HornOff;
    Alm[15].Old = Alm[15].Active;
    Alm[16].Active = Mot[117].FbkErr && DI[44];
    Alm[16].Unack = sr(&AlmUnack[16], Alm[16].Active && !Alm[16].Old, AckAll || DI[43]);
    Alm[16].Horn = Alm[16].Unack && !HornOff;
    Alm[16].Old = Alm[16].Active;
    Alm[17].Active = Vlv[22].Locked && DI[4];
    Alm[17].Unack = sr(&AlmUnack[17], Alm[17].Active && !Alm[17].Old, AckAll || DI[127]);
    Alm[17].Horn = Alm[17].Unack && !HornOff;
    Alm[17].Old = Alm[17].Active;
    Alm[18].Active = Vlv[48].PosErr && DI[89];
    Alm[18].Unack = sr(&AlmUnack[18], Alm[18].Active && !Alm[18].Old, AckAll || DI[178]);
    Alm[18].Horn = Alm[18].Unack && !HornOff;
    Alm[18].Old = Alm[18].Active;
    Alm[19].Active = !Grp[20].EStopOk && DI[141];
    Alm[19].Unack = sr(&AlmUnack[19], Alm[19].Active && !Alm[19].Old, AckAll || DI[240]);
    Alm[19].Horn = Alm[19].Unack && !HornOff;
    Alm[19].Old = Alm[19].Active;

    /* alarms 20 and following */
    Alm[20].Active = Vlv[57].PosErr && DI[50];
    Alm[20].Unack = sr(&AlmUnack[20], Alm[20].Active && !Alm[20].Old, AckAll || DI[7]);
    Alm[20].Horn = Alm[20].Unack && !HornOff;
    Alm[20].Old = Alm[20].Active;
    Alm[21].Active = Vlv[81].Locked && DI[230];
    Alm[21].Unack = sr(&AlmUnack[21], Alm[21].Active && !Alm[21].Old, AckAll || DI[97]);
    Alm[21].Horn = Alm[21].Unack && !HornOff;
    Alm[21].Old = Alm[21].Active;
    Alm[22].Active = Mot[18].FbkErr && !DI[179];
    Alm[22].Unack = sr(&AlmUnack[22], Alm[22].Active && !Alm[22].Old, AckAll || DI[222]);
    Alm[22].Horn = Alm[22].Unack && !HornOff;
    Alm[22].Old = Alm[22].Active;
    Alm[23].Active = !Grp[18].EStopOk && DI[103];
    Alm[23].Unack = sr(&AlmUnack[23], Alm[23].Active && !Alm[23].Old, AckAll || DI[95]);
    Alm[23].Horn = Alm[23].Unack && !HornOff;
    Alm[23].Old = Alm[23].Active;
    Alm[24].Active = !Grp[18].EStopOk && !DI[91];
    Alm[24].Unack = sr(&AlmUnack[24], Alm[24].Active && !Alm[24].Old, AckAll || DI[80]);
    Alm[24].Horn = Alm[24].Unack && !HornOff;
    Alm[24].Old = Alm[24].Active;
    Alm[25].Active = Vlv[71].PosErr && DI[50];
    Alm[25].Unack = sr(&AlmUnack[25], Alm[25].Active && !Alm[25].Old, AckAll || DI[11]);
    Alm[25].Horn = Alm[25].Unack && !HornOff;
    Alm[25].Old = Alm[25].Active;
    Alm[26].Active = Mot[12].Fault && DI[116];
    Alm[26].Unack = sr(&AlmUnack[26], Alm[26].Active && !Alm[26].Old, AckAll || DI[165]);
    Alm[26].Horn = Alm[26].Unack && !HornOff;
    Alm[26].Old = Alm[26].Active;
    Alm[27].Active = Mot[6].Fault && DI[9];
    Alm[27].Unack = sr(&AlmUnack[27], Alm[27].Active && !Alm[27].Old, AckAll || DI[212]);
    Alm[27].Horn = Alm[27].Unack && !HornOff;
    Alm[27].Old = Alm[27].Active;
    Alm[28].Active = !Grp[17].EStopOk && DI[212];
    Alm[28].Unack = sr(&AlmUnack[28], Alm[28].Active && !Alm[28].Old, AckAll || DI[136]);
    Alm[28].Horn = Alm[28].Unack && !HornOff;
    Alm[28].Old = Alm[28].Active;
    Alm[29].Active = Vlv[14].PosErr && DI[102];
    Alm[29].Unack = sr(&AlmUnack[29], Alm[29].Active && !Alm[29].Old, AckAll || DI[249]);
    Alm[29].Horn = Alm[29].Unack && !HornOff;
    Alm[29].Old = Alm[29].Active;
    Alm[30].Active = !Grp[5].EStopOk && !DI[173];
    Alm[30].Unack = sr(&AlmUnack[30], Alm[30].Active && !Alm[30].Old, AckAll || DI[12]);
    Alm[30].Horn = Alm[30].Unack && !HornOff;
    Alm[30].Old = Alm[30].Active;
    Alm[31].Active = Vlv[85].PosErr && DI[121];
    Alm[31].Unack = sr(&AlmUnack[31], Alm[31].Active && !Alm[31].Old, AckAll || DI[23]);
    Alm[31].Horn = Alm[31].Unack && !HornOff;
    Alm[31].Old = Alm[31].Active;
    Alm[32].Active = Vlv[82].PosErr && !DI[46];
    Alm[32].Unack = sr(&AlmUnack[32], Alm[32].Active && !Alm[32].Old, AckAll || DI[76]);
    Alm[32].Horn = Alm[32].Unack && !HornOff;
    Alm[32].Old = Alm[32].Active;
    Alm[33].Active = Vlv[78].PosErr && DI[74];
    Alm[33].Unack = sr(&AlmUnack[33], Alm[33].Active && !Alm[33].Old, AckAll || DI[155]);
    Alm[33].Horn = Alm[33].Unack && !HornOff;
    Alm[33].Old = Alm[33].Active;
    Alm[34].Active = Vlv[86].Locked && DI[219];
    Alm[34].Unack = sr(&AlmUnack[34], Alm[34].Active && !Alm[34].Old, AckAll || DI[55]);
    Alm[34].Horn = Alm[34].Unack && !HornOff;
    Alm[34].Old = Alm[34].Active;
    Alm[35].Active = Mot[71].Fault && !DI[136];
    Alm[35].Unack = sr(&AlmUnack[35], Alm[35].Active && !Alm[35].Old, AckAll || DI[26]);
    Alm[35].Horn = Alm[35].Unack && !HornOff;
    Alm[35].Old = Alm[35].Active;
    Alm[36].Active = Mot[128].FbkErr && DI[42];
    Alm[36].Unack = sr(&AlmUnack[36], Alm[36].Active && !Alm[36].Old, AckAll || DI[233]);
    Alm[36].Horn = Alm[36].Unack && !HornOff;
    Alm[36].Old = Alm[36].Active;
    Alm[37].Active = Vlv[85].PosErr && DI[183];
    Alm[37].Unack = sr(&AlmUnack[37], Alm[37].Active && !Alm[37].Old, AckAll || DI[241]);
    Alm[37].Horn = Alm[37].Unack && !HornOff;
    Alm[37].Old = Alm[37].Active;
    Alm[38].Active = Vlv[0].Locked && DI[168];
    Alm[38].Unack = sr(&AlmUnack[38], Alm[38].Active && !Alm[38].Old, AckAll || DI[145]);
    Alm[38].Horn = Alm[38].Unack && !HornOff;
    Alm[38].Old = Alm[38].Active;
    Alm[39].Active = !Grp[8].EStopOk && DI[186];
    Alm[39].Unack = sr(&AlmUnack[39], Alm[39].Active && !Alm[39].Old, AckAll || DI[23]);
    Alm[39].Horn = Alm[39].Unack && !HornOff;
    Alm[39].Old = Alm[39].Active;

    /* alarms 40 and following */
    Alm[40].Active = Vlv[47].Locked && !DI[139];
    Alm[40].Unack = sr(&AlmUnack[40], Alm[40].Active && !Alm[40].Old, AckAll || DI[113]);
    Alm[40].Horn = Alm[40].Unack && !HornOff;
    Alm[40].Old = Alm[40].Active;
    Alm[41].Active = Vlv[2].PosErr && DI[44];
    Alm[41].Unack = sr(&AlmUnack[41], Alm[41].Active && !Alm[41].Old, AckAll || DI[236]);
    Alm[41].Horn = Alm[41].Unack && !HornOff;
    Alm[41].Old = Alm[41].Active;
    Alm[42].Active = Mot[59].FbkErr && DI[254];
    Alm[42].Unack = sr(&AlmUnack[42], Alm[42].Active && !Alm[42].Old, AckAll || DI[198]);
    Alm[42].Horn = Alm[42].Unack && !HornOff;
    Alm[42].Old = Alm[42].Active;
    Alm[43].Active = Mot[55].Fault && DI[225];
    Alm[43].Unack = sr(&AlmUnack[43], Alm[43].Active && !Alm[43].Old, AckAll || DI[190]);
    Alm[43].Horn = Alm[43].Unack && !HornOff;
    Alm[43].Old = Alm[43].Active;
    Alm[44].Active = Vlv[77].PosErr && !DI[225];
    Alm[44].Unack = sr(&AlmUnack[44], Alm[44].Active && !Alm[44].Old, AckAll || DI[232]);
    Alm[44].Horn = Alm[44].Unack && !HornOff;
    Alm[44].Old = Alm[44].Active;
    Alm[45].Active = Vlv[10].Locked && DI[246];
    Alm[45].Unack = sr(&AlmUnack[45], Alm[45].Active && !Alm[45].Old, AckAll || DI[230]);
    Alm[45].Horn = Alm[45].Unack && !HornOff;
    Alm[45].Old = Alm[45].Active;
    Alm[46].Active = Vlv[17].PosErr && DI[84];
    Alm[46].Unack = sr(&AlmUnack[46], Alm[46].Active && !Alm[46].Old, AckAll || DI[6]);
    Alm[46].Horn = Alm[46].Unack && !HornOff;
    Alm[46].Old = Alm[46].Active;
    Alm[47].Active = Vlv[28].PosErr && DI[20];
    Alm[47].Unack = sr(&AlmUnack[47], Alm[47].Active && !Alm[47].Old, AckAll || DI[98]);
    Alm[47].Horn = Alm[47].Unack && !HornOff;
    Alm[47].Old = Alm[47].Active;
    Alm[48].Active = Mot[18].Fault && DI[229];
    Alm[48].Unack = sr(&AlmUnack[48], Alm[48].Active && !Alm[48].Old, AckAll || DI[197]);
    Alm[48].Horn = Alm[48].Unack && !HornOff;
    Alm[48].Old = Alm[48].Active;
    Alm[49].Active = !Grp[16].EStopOk && !DI[44];
    Alm[49].Unack = sr(&AlmUnack[49], Alm[49].Active && !Alm[49].Old, AckAll || DI[156]);
    Alm[49].Horn = Alm[49].Unack && !HornOff;
    Alm[49].Old = Alm[49].Active;
    Alm[50].Active = Vlv[81].Locked && DI[141];
    Alm[50].Unack = sr(&AlmUnack[50], Alm[50].Active && !Alm[50].Old, AckAll || DI[85]);
    Alm[50].Horn = Alm[50].Unack && !HornOff;
    Alm[50].Old = Alm[50].Active;
    Alm[51].Active = Mot[115].FbkErr && DI[176];
    Alm[51].Unack = sr(&AlmUnack[51], Alm[51].Active && !Alm[51].Old, AckAll || DI[216]);
    Alm[51].Horn = Alm[51].Unack && !HornOff;
    Alm[51].Old = Alm[51].Active;
    Alm[52].Active = Mot[111].Fault && !DI[88];
    Alm[52].Unack = sr(&AlmUnack[52], Alm[52].Active && !Alm[52].Old, AckAll || DI[16]);
    Alm[52].Horn = Alm[52].Unack && !HornOff;
    Alm[52].Old = Alm[52].Active;
    Alm[53].Active = Mot[114].Fault && DI[245];
    Alm[53].Unack = sr(&AlmUnack[53], Alm[53].Active && !Alm[53].Old, AckAll || DI[130]);
    Alm[53].Horn = Alm[53].Unack && !HornOff;
    Alm[53].Old = Alm[53].Active;
    Alm[54].Active = Mot[78].Fault && !DI[204];
    Alm[54].Unack = sr(&AlmUnack[54], Alm[54].Active && !Alm[54].Old, AckAll || DI[228]);
    Alm[54].Horn = Alm[54].Unack && !HornOff;
    Alm[54].Old = Alm[54].Active;
    Alm[55].Active = Mot[113].Fault && DI[45];
    Alm[55].Unack = sr(&AlmUnack[55], Alm[55].Active && !Alm[55].Old, AckAll || DI[192]);
    Alm[55].Horn = Alm[55].Unack && !HornOff;
    Alm[55].Old = Alm[55].Active;
    Alm[56].Active = Mot[88].FbkErr && DI[251];
    Alm[56].Unack = sr(&AlmUnack[56], Alm[56].Active && !Alm[56].Old, AckAll || DI[8]);
    Alm[56].Horn = Alm[56].Unack && !HornOff;
    Alm[56].Old = Alm[56].Active;
    Alm[57].Active = Vlv[38].Locked && !DI[158];
    Alm[57].Unack = sr(&AlmUnack[57], Alm[57].Active && !Alm[57].Old, AckAll || DI[177]);
    Alm[57].Horn = Alm[57].Unack && !HornOff;
    Alm[57].Old = Alm[57].Active;
    Alm[58].Active = Vlv[79].Locked && DI[35];
    Alm[58].Unack = sr(&AlmUnack[58], Alm[58].Active && !Alm[58].Old, AckAll || DI[184]);
    Alm[58].Horn = Alm[58].Unack && !HornOff;
    Alm[58].Old = Alm[58].Active;
    Alm[59].Active = !Grp[14].EStopOk && DI[197];
    Alm[59].Unack = sr(&AlmUnack[59], Alm[59].Active && !Alm[59].Old, AckAll || DI[34]);
    Alm[59].Horn = Alm[59].Unack && !HornOff;
    Alm[59].Old = Alm[59].Active;

    /* alarms 60 and following */
    Alm[60].Active = Mot[88].Fault && DI[225];
    Alm[60].Unack = sr(&AlmUnack[60], Alm[60].Active && !Alm[60].Old, AckAll || DI[40]);
    Alm[60].Horn = Alm[60].Unack && !HornOff;
    Alm[60].Old = Alm[60].Active;
    Alm[61].Active = Mot[4].FbkErr && DI[199];
    Alm[61].Unack = sr(&AlmUnack[61], Alm[61].Active && !Alm[61].Old, AckAll || DI[181]);
    Alm[61].Horn = Alm[61].Unack && !HornOff;
    Alm[61].Old = Alm[61].Active;
    Alm[62].Active = Vlv[83].Locked && DI[206];
    Alm[62].Unack = sr(&AlmUnack[62], Alm[62].Active && !Alm[62].Old, AckAll || DI[195]);
    Alm[62].Horn = Alm[62].Unack && !HornOff;
    Alm[62].Old = Alm[62].Active;
    Alm[63].Active = Vlv[14].PosErr && DI[146];
    Alm[63].Unack = sr(&AlmUnack[63], Alm[63].Active && !Alm[63].Old, AckAll || DI[187]);
    Alm[63].Horn = Alm[63].Unack && !HornOff;
    Alm[63].Old = Alm[63].Active;
    Alm[64].Active = !Grp[6].EStopOk && DI[43];
    Alm[64].Unack = sr(&AlmUnack[64], Alm[64].Active && !Alm[64].Old, AckAll || DI[10]);
    Alm[64].Horn = Alm[64].Unack && !HornOff;
    Alm[64].Old = Alm[64].Active;
    Alm[65].Active = Mot[70].Fault && DI[51];
    Alm[65].Unack = sr(&AlmUnack[65], Alm[65].Active && !Alm[65].Old, AckAll || DI[15]);
    Alm[65].Horn = Alm[65].Unack && !HornOff;
    Alm[65].Old = Alm[65].Active;
    Alm[66].Active = Mot[48].FbkErr && DI[37];
    Alm[66].Unack = sr(&AlmUnack[66], Alm[66].Active && !Alm[66].Old, AckAll || DI[39]);
    Alm[66].Horn = Alm[66].Unack && !HornOff;
    Alm[66].Old = Alm[66].Active;
    Alm[67].Active = Mot[34].FbkErr && DI[32];
    Alm[67].Unack = sr(&AlmUnack[67], Alm[67].Active && !Alm[67].Old, AckAll || DI[13]);
    Alm[67].Horn = Alm[67].Unack && !HornOff;
    Alm[67].Old = Alm[67].Active;
    Alm[68].Active = !Grp[0].EStopOk && DI[94];
    Alm[68].Unack = sr(&AlmUnack[68], Alm[68].Active && !Alm[68].Old, AckAll || DI[148]);
    Alm[68].Horn = Alm[68].Unack && !HornOff;
    Alm[68].Old = Alm[68].Active;
    Alm[69].Active = Vlv[16].PosErr && DI[49];
    Alm[69].Unack = sr(&AlmUnack[69], Alm[69].Active && !Alm[69].Old, AckAll || DI[20]);
    Alm[69].Horn = Alm[69].Unack && !HornOff;
    Alm[69].Old = Alm[69].Active;
    Alm[70].Active = Vlv[85].Locked && !DI[169];
    Alm[70].Unack = sr(&AlmUnack[70], Alm[70].Active && !Alm[70].Old, AckAll || DI[87]);
    Alm[70].Horn = Alm[70].Unack && !HornOff;
    Alm[70].Old = Alm[70].Active;
    Alm[71].Active = Mot[51].Fault && DI[129];
    Alm[71].Unack = sr(&AlmUnack[71], Alm[71].Active && !Alm[71].Old, AckAll || DI[57]);
    Alm[71].Horn = Alm[71].Unack && !HornOff;
    Alm[71].Old = Alm[71].Active;
    Alm[72].Active = Vlv[78].PosErr && DI[133];
    Alm[72].Unack = sr(&AlmUnack[72], Alm[72].Active && !Alm[72].Old, AckAll || DI[66]);
    Alm[72].Horn = Alm[72].Unack && !HornOff;
    Alm[72].Old = Alm[72].Active;
    Alm[73].Active = Vlv[37].Locked && DI[29];
    Alm[73].Unack = sr(&AlmUnack[73], Alm[73].Active && !Alm[73].Old, AckAll || DI[224]);
    Alm[73].Horn = Alm[73].Unack && !HornOff;
    Alm[73].Old = Alm[73].Active;
    Alm[74].Active = Vlv[77].Locked && !DI[57];
    Alm[74].Unack = sr(&AlmUnack[74], Alm[74].Active && !Alm[74].Old, AckAll || DI[208]);
    Alm[74].Horn = Alm[74].Unack && !HornOff;
    Alm[74].Old = Alm[74].Active;
    Alm[75].Active = Vlv[36].Locked && !DI[65];
    Alm[75].Unack = sr(&AlmUnack[75], Alm[75].Active && !Alm[75].Old, AckAll || DI[87]);
    Alm[75].Horn = Alm[75].Unack && !HornOff;
    Alm[75].Old = Alm[75].Active;
    Alm[76].Active = Mot[43].Fault && DI[125];
    Alm[76].Unack = sr(&AlmUnack[76], Alm[76].Active && !Alm[76].Old, AckAll || DI[186]);
    Alm[76].Horn = Alm[76].Unack && !HornOff;
    Alm[76].Old = Alm[76].Active;
    Alm[77].Active = Vlv[37].PosErr && DI[54];
    Alm[77].Unack = sr(&AlmUnack[77], Alm[77].Active && !Alm[77].Old, AckAll || DI[22]);
    Alm[77].Horn = Alm[77].Unack && !HornOff;
    Alm[77].Old = Alm[77].Active;
    Alm[78].Active = !Grp[5].EStopOk && DI[74];
    Alm[78].Unack = sr(&AlmUnack[78], Alm[78].Active && !Alm[78].Old, AckAll || DI[197]);
    Alm[78].Horn = Alm[78].Unack && !HornOff;
    Alm[78].Old = Alm[78].Active;
    Alm[79].Active = Vlv[30].Locked && DI[109];
    Alm[79].Unack = sr(&AlmUnack[79], Alm[79].Active && !Alm[79].Old, AckAll || DI[135]);
    Alm[79].Horn = Alm[79].Unack && !HornOff;
    Alm[79].Old = Alm[79].Active;

    /* alarms 80 and following */
    Alm[80].Active = Mot[65].FbkErr && DI[242];
    Alm[80].Unack = sr(&AlmUnack[80], Alm[80].Active && !Alm[80].Old, AckAll || DI[239]);
    Alm[80].Horn = Alm[80].Unack && !HornOff;
    Alm[80].Old = Alm[80].Active;
    Alm[81].Active = Mot[80].Fault && DI[229];
    Alm[81].Unack = sr(&AlmUnack[81], Alm[81].Active && !Alm[81].Old, AckAll || DI[229]);
    Alm[81].Horn = Alm[81].Unack && !HornOff;
    Alm[81].Old = Alm[81].Active;
    Alm[82].Active = Vlv[4].Locked && DI[21];
    Alm[82].Unack = sr(&AlmUnack[82], Alm[82].Active && !Alm[82].Old, AckAll || DI[116]);
    Alm[82].Horn = Alm[82].Unack && !HornOff;
    Alm[82].Old = Alm[82].Active;
    Alm[83].Active = Vlv[57].PosErr && DI[146];
    Alm[83].Unack = sr(&AlmUnack[83], Alm[83].Active && !Alm[83].Old, AckAll || DI[208]);
    Alm[83].Horn = Alm[83].Unack && !HornOff;
    Alm[83].Old = Alm[83].Active;
    Alm[84].Active = Vlv[33].Locked && DI[218];
    Alm[84].Unack = sr(&AlmUnack[84], Alm[84].Active && !Alm[84].Old, AckAll || DI[37]);
    Alm[84].Horn = Alm[84].Unack && !HornOff;
    Alm[84].Old = Alm[84].Active;
    Alm[85].Active = Vlv[63].Locked && !DI[107];
    Alm[85].Unack = sr(&AlmUnack[85], Alm[85].Active && !Alm[85].Old, AckAll || DI[228]);
    Alm[85].Horn = Alm[85].Unack && !HornOff;
    Alm[85].Old = Alm[85].Active;
    Alm[86].Active = Mot[61].FbkErr && DI[59];
    Alm[86].Unack = sr(&AlmUnack[86], Alm[86].Active && !Alm[86].Old, AckAll || DI[125]);
    Alm[86].Horn = Alm[86].Unack && !HornOff;
    Alm[86].Old = Alm[86].Active;
    Alm[87].Active = Vlv[84].PosErr && DI[50];
    Alm[87].Unack = sr(&AlmUnack[87], Alm[87].Active && !Alm[87].Old, AckAll || DI[83]);
    Alm[87].Horn = Alm[87].Unack && !HornOff;
    Alm[87].Old = Alm[87].Active;
    Alm[88].Active = Mot[69].FbkErr && !DI[192];
    Alm[88].Unack = sr(&AlmUnack[88], Alm[88].Active && !Alm[88].Old, AckAll || DI[41]);
    Alm[88].Horn = Alm[88].Unack && !HornOff;
    Alm[88].Old = Alm[88].Active;
    Alm[89].Active = Mot[22].FbkErr && !DI[231];
    Alm[89].Unack = sr(&AlmUnack[89], Alm[89].Active && !Alm[89].Old, AckAll || DI[218]);
    Alm[89].Horn = Alm[89].Unack && !HornOff;
    Alm[89].Old = Alm[89].Active;
    Alm[90].Active = Vlv[74].PosErr && DI[46];
    Alm[90].Unack = sr(&AlmUnack[90], Alm[90].Active && !Alm[90].Old, AckAll || DI[91]);
    Alm[90].Horn = Alm[90].Unack && !HornOff;
    Alm[90].Old = Alm[90].Active;
    Alm[91].Active = Vlv[62].Locked && DI[12];
    Alm[91].Unack = sr(&AlmUnack[91], Alm[91].Active && !Alm[91].Old, AckAll || DI[107]);
    Alm[91].Horn = Alm[91].Unack && !HornOff;
    Alm[91].Old = Alm[91].Active;
    Alm[92].Active = !Grp[22].EStopOk && DI[160];
    Alm[92].Unack = sr(&AlmUnack[92], Alm[92].Active && !Alm[92].Old, AckAll || DI[91]);
    Alm[92].Horn = Alm[92].Unack && !HornOff;
    Alm[92].Old = Alm[92].Active;
    Alm[93].Active = Mot[44].Fault && !DI[89];
    Alm[93].Unack = sr(&AlmUnack[93], Alm[93].Active && !Alm[93].Old, AckAll || DI[74]);
    Alm[93].Horn = Alm[93].Unack && !HornOff;
    Alm[93].Old = Alm[93].Active;
    Alm[94].Active = Vlv[36].PosErr && DI[226];
    Alm[94].Unack = sr(&AlmUnack[94], Alm[94].Active && !Alm[94].Old, AckAll || DI[229]);
    Alm[94].Horn = Alm[94].Unack && !HornOff;
    Alm[94].Old = Alm[94].Active;
    Alm[95].Active = Mot[67].Fault && !DI[164];
    Alm[95].Unack = sr(&AlmUnack[95], Alm[95].Active && !Alm[95].Old, AckAll || DI[194]);
    Alm[95].Horn = Alm[95].Unack && !HornOff;
    Alm[95].Old = Alm[95].Active;
    Alm[96].Active = Mot[75].FbkErr && DI[55];
    Alm[96].Unack = sr(&AlmUnack[96], Alm[96].Active && !Alm[96].Old, AckAll || DI[74]);
    Alm[96].Horn = Alm[96].Unack && !HornOff;
    Alm[96].Old = Alm[96].Active;
    Alm[97].Active = Vlv[60].PosErr && !DI[229];
    Alm[97].Unack = sr(&AlmUnack[97], Alm[97].Active && !Alm[97].Old, AckAll || DI[213]);
    Alm[97].Horn = Alm[97].Unack && !HornOff;
    Alm[97].Old = Alm[97].Active;
    Alm[98].Active = Mot[85].Fault && !DI[83];
    Alm[98].Unack = sr(&AlmUnack[98], Alm[98].Active && !Alm[98].Old, AckAll || DI[221]);
    Alm[98].Horn = Alm[98].Unack && !HornOff;
    Alm[98].Old = Alm[98].Active;
    Alm[99].Active = Vlv[78].PosErr && !DI[57];
    Alm[99].Unack = sr(&AlmUnack[99], Alm[99].Active && !Alm[99].Old, AckAll || DI[182]);
    Alm[99].Horn = Alm[99].Unack && !HornOff;
    Alm[99].Old = Alm[99].Active;

    /* alarms 100 and following */
    Alm[100].Active = Vlv[14].PosErr && DI[102];
    Alm[100].Unack = sr(&AlmUnack[100], Alm[100].Active && !Alm[100].Old, AckAll || DI[235]);
    Alm[100].Horn = Alm[100].Unack && !HornOff;
    Alm[100].Old = Alm[100].Active;
    Alm[101].Active = Vlv[82].PosErr && DI[71];
    Alm[101].Unack = sr(&AlmUnack[101], Alm[101].Active && !Alm[101].Old, AckAll || DI[142]);
    Alm[101].Horn = Alm[101].Unack && !HornOff;
    Alm[101].Old = Alm[101].Active;
    Alm[102].Active = Vlv[49].PosErr && !DI[192];
    Alm[102].Unack = sr(&AlmUnack[102], Alm[102].Active && !Alm[102].Old, AckAll || DI[10]);
    Alm[102].Horn = Alm[102].Unack && !HornOff;
    Alm[102].Old = Alm[102].Active;
    Alm[103].Active = Vlv[69].PosErr && DI[1];
    Alm[103].Unack = sr(&AlmUnack[103], Alm[103].Active && !Alm[103].Old, AckAll || DI[200]);
    Alm[103].Horn = Alm[103].Unack && !HornOff;
    Alm[103].Old = Alm[103].Active;
    Alm[104].Active = !Grp[16].EStopOk && DI[177];
    Alm[104].Unack = sr(&AlmUnack[104], Alm[104].Active && !Alm[104].Old, AckAll || DI[32]);
    Alm[104].Horn = Alm[104].Unack && !HornOff;
    Alm[104].Old = Alm[104].Active;
    Alm[105].Active = Mot[30].Fault && DI[236];
    Alm[105].Unack = sr(&AlmUnack[105], Alm[105].Active && !Alm[105].Old, AckAll || DI[248]);
    Alm[105].Horn = Alm[105].Unack && !HornOff;
    Alm[105].Old = Alm[105].Active;
    Alm[106].Active = Mot[84].FbkErr && !DI[175];
    Alm[106].Unack = sr(&AlmUnack[106], Alm[106].Active && !Alm[106].Old, AckAll || DI[22]);
    Alm[106].Horn = Alm[106].Unack && !HornOff;
    Alm[106].Old = Alm[106].Active;
    Alm[107].Active = Mot[127].Fault && DI[191];
    Alm[107].Unack = sr(&AlmUnack[107], Alm[107].Active && !Alm[107].Old, AckAll || DI[63]);
    Alm[107].Horn = Alm[107].Unack && !HornOff;
    Alm[107].Old = Alm[107].Active;
    Alm[108].Active = Mot[83].FbkErr && DI[117];
    Alm[108].Unack = sr(&AlmUnack[108], Alm[108].Active && !Alm[108].Old, AckAll || DI[43]);
    Alm[108].Horn = Alm[108].Unack && !HornOff;
    Alm[108].Old = Alm[108].Active;
    Alm[109].Active = Mot[74].Fault && DI[96];
    Alm[109].Unack = sr(&AlmUnack[109], Alm[109].Active && !Alm[109].Old, AckAll || DI[233]);
    Alm[109].Horn = Alm[109].Unack && !HornOff;
    Alm[109].Old = Alm[109].Active;
    Alm[110].Active = Vlv[36].Locked && DI[13];
    Alm[110].Unack = sr(&AlmUnack[110], Alm[110].Active && !Alm[110].Old, AckAll || DI[104]);
    Alm[110].Horn = Alm[110].Unack && !HornOff;
    Alm[110].Old = Alm[110].Active;
    Alm[111].Active = Vlv[26].Locked && !DI[92];
    Alm[111].Unack = sr(&AlmUnack[111], Alm[111].Active && !Alm[111].Old, AckAll || DI[111]);
    Alm[111].Horn = Alm[111].Unack && !HornOff;
    Alm[111].Old = Alm[111].Active;
    Alm[112].Active = Mot[16].FbkErr && DI[142];
    Alm[112].Unack = sr(&AlmUnack[112], Alm[112].Active && !Alm[112].Old, AckAll || DI[111]);
    Alm[112].Horn = Alm[112].Unack && !HornOff;
    Alm[112].Old = Alm[112].Active;
    Alm[113].Active = !Grp[15].EStopOk && !DI[48];
    Alm[113].Unack = sr(&AlmUnack[113], Alm[113].Active && !Alm[113].Old, AckAll || DI[233]);
    Alm[113].Horn = Alm[113].Unack && !HornOff;
    Alm[113].Old = Alm[113].Active;
    Alm[114].Active = Vlv[72].Locked && DI[216];
    Alm[114].Unack = sr(&AlmUnack[114], Alm[114].Active && !Alm[114].Old, AckAll || DI[7]);
    Alm[114].Horn = Alm[114].Unack && !HornOff;
    Alm[114].Old = Alm[114].Active;
    Alm[115].Active = Vlv[2].Locked && !DI[74];
    Alm[115].Unack = sr(&AlmUnack[115], Alm[115].Active && !Alm[115].Old, AckAll || DI[57]);
    Alm[115].Horn = Alm[115].Unack && !HornOff;
    Alm[115].Old = Alm[115].Active;
    Alm[116].Active = Vlv[13].PosErr && !DI[168];
    Alm[116].Unack = sr(&AlmUnack[116], Alm[116].Active && !Alm[116].Old, AckAll || DI[241]);
    Alm[116].Horn = Alm[116].Unack && !HornOff;
    Alm[116].Old = Alm[116].Active;
    Alm[117].Active = Mot[66].Fault && !DI[93];
    Alm[117].Unack = sr(&AlmUnack[117], Alm[117].Active && !Alm[117].Old, AckAll || DI[182]);
    Alm[117].Horn = Alm[117].Unack && !HornOff;
    Alm[117].Old = Alm[117].Active;
    Alm[118].Active = !Grp[20].EStopOk && DI[179];
    Alm[118].Unack = sr(&AlmUnack[118], Alm[118].Active && !Alm[118].Old, AckAll || DI[133]);
    Alm[118].Horn = Alm[118].Unack && !HornOff;
    Alm[118].Old = Alm[118].Active;
    Alm[119].Active = Mot[47].FbkErr && DI[141];
    Alm[119].Unack = sr(&AlmUnack[119], Alm[119].Active && !Alm[119].Old, AckAll || DI[67]);
    Alm[119].Horn = Alm[119].Unack && !HornOff;
    Alm[119].Old = Alm[119].Active;

    /* alarms 120 and following */
    Alm[120].Active = !Grp[1].EStopOk && !DI[157];
    Alm[120].Unack = sr(&AlmUnack[120], Alm[120].Active && !Alm[120].Old, AckAll || DI[183]);
    Alm[120].Horn = Alm[120].Unack && !HornOff;
    Alm[120].Old = Alm[120].Active;
    Alm[121].Active = Vlv[83].Locked && DI[62];
    Alm[121].Unack = sr(&AlmUnack[121], Alm[121].Active && !Alm[121].Old, AckAll || DI[241]);
    Alm[121].Horn = Alm[121].Unack && !HornOff;
    Alm[121].Old = Alm[121].Active;
    Alm[122].Active = Vlv[13].PosErr && !DI[183];
    Alm[122].Unack = sr(&AlmUnack[122], Alm[122].Active && !Alm[122].Old, AckAll || DI[240]);
    Alm[122].Horn = Alm[122].Unack && !HornOff;
    Alm[122].Old = Alm[122].Active;
    Alm[123].Active = !Grp[6].EStopOk && DI[239];
    Alm[123].Unack = sr(&AlmUnack[123], Alm[123].Active && !Alm[123].Old, AckAll || DI[32]);
    Alm[123].Horn = Alm[123].Unack && !HornOff;
    Alm[123].Old = Alm[123].Active;
    Alm[124].Active = Vlv[8].PosErr && DI[14];
    Alm[124].Unack = sr(&AlmUnack[124], Alm[124].Active && !Alm[124].Old, AckAll || DI[135]);
    Alm[124].Horn = Alm[124].Unack && !HornOff;
    Alm[124].Old = Alm[124].Active;
    Alm[125].Active = Mot[129].Fault && DI[40];
    Alm[125].Unack = sr(&AlmUnack[125], Alm[125].Active && !Alm[125].Old, AckAll || DI[91]);
    Alm[125].Horn = Alm[125].Unack && !HornOff;
    Alm[125].Old = Alm[125].Active;
    Alm[126].Active = Vlv[59].PosErr && DI[239];
    Alm[126].Unack = sr(&AlmUnack[126], Alm[126].Active && !Alm[126].Old, AckAll || DI[26]);
    Alm[126].Horn = Alm[126].Unack && !HornOff;
    Alm[126].Old = Alm[126].Active;
    Alm[127].Active = Mot[47].FbkErr && DI[179];
    Alm[127].Unack = sr(&AlmUnack[127], Alm[127].Active && !Alm[127].Old, AckAll || DI[228]);
    Alm[127].Horn = Alm[127].Unack && !HornOff;
    Alm[127].Old = Alm[127].Active;
    Alm[128].Active = Mot[33].Fault && DI[105];
    Alm[128].Unack = sr(&AlmUnack[128], Alm[128].Active && !Alm[128].Old, AckAll || DI[54]);
    Alm[128].Horn = Alm[128].Unack && !HornOff;
    Alm[128].Old = Alm[128].Active;
    Alm[129].Active = Vlv[79].Locked && DI[116];
    Alm[129].Unack = sr(&AlmUnack[129], Alm[129].Active && !Alm[129].Old, AckAll || DI[190]);
    Alm[129].Horn = Alm[129].Unack && !HornOff;
    Alm[129].Old = Alm[129].Active;
    Alm[130].Active = !Grp[21].EStopOk && !DI[100];
    Alm[130].Unack = sr(&AlmUnack[130], Alm[130].Active && !Alm[130].Old, AckAll || DI[17]);
    Alm[130].Horn = Alm[130].Unack && !HornOff;
    Alm[130].Old = Alm[130].Active;
    Alm[131].Active = !Grp[0].EStopOk && DI[190];
    Alm[131].Unack = sr(&AlmUnack[131], Alm[131].Active && !Alm[131].Old, AckAll || DI[240]);
    Alm[131].Horn = Alm[131].Unack && !HornOff;
    Alm[131].Old = Alm[131].Active;
    Alm[132].Active = Vlv[63].Locked && !DI[78];
    Alm[132].Unack = sr(&AlmUnack[132], Alm[132].Active && !Alm[132].Old, AckAll || DI[183]);
    Alm[132].Horn = Alm[132].Unack && !HornOff;
    Alm[132].Old = Alm[132].Active;
    Alm[133].Active = !Grp[4].EStopOk && DI[225];
    Alm[133].Unack = sr(&AlmUnack[133], Alm[133].Active && !Alm[133].Old, AckAll || DI[170]);
    Alm[133].Horn = Alm[133].Unack && !HornOff;
    Alm[133].Old = Alm[133].Active;
    Alm[134].Active = Vlv[66].Locked && !DI[25];
    Alm[134].Unack = sr(&AlmUnack[134], Alm[134].Active && !Alm[134].Old, AckAll || DI[123]);
    Alm[134].Horn = Alm[134].Unack && !HornOff;
    Alm[134].Old = Alm[134].Active;
    Alm[135].Active = Vlv[4].PosErr && !DI[75];
    Alm[135].Unack = sr(&AlmUnack[135], Alm[135].Active && !Alm[135].Old, AckAll || DI[13]);
    Alm[135].Horn = Alm[135].Unack && !HornOff;
    Alm[135].Old = Alm[135].Active;
    Alm[136].Active = Vlv[53].PosErr && DI[102];
    Alm[136].Unack = sr(&AlmUnack[136], Alm[136].Active && !Alm[136].Old, AckAll || DI[217]);
    Alm[136].Horn = Alm[136].Unack && !HornOff;
    Alm[136].Old = Alm[136].Active;
    Alm[137].Active = !Grp[22].EStopOk && DI[155];
    Alm[137].Unack = sr(&AlmUnack[137], Alm[137].Active && !Alm[137].Old, AckAll || DI[31]);
    Alm[137].Horn = Alm[137].Unack && !HornOff;
    Alm[137].Old = Alm[137].Active;
    Alm[138].Active = Vlv[27].Locked && DI[197];
    Alm[138].Unack = sr(&AlmUnack[138], Alm[138].Active && !Alm[138].Old, AckAll || DI[30]);
    Alm[138].Horn = Alm[138].Unack && !HornOff;
    Alm[138].Old = Alm[138].Active;
    Alm[139].Active = Vlv[72].PosErr && !DI[248];
    Alm[139].Unack = sr(&AlmUnack[139], Alm[139].Active && !Alm[139].Old, AckAll || DI[17]);
    Alm[139].Horn = Alm[139].Unack && !HornOff;
    Alm[139].Old = Alm[139].Active;

    /* alarms 140 and following */
    Alm[140].Active = Vlv[78].Locked && !DI[22];
    Alm[140].Unack = sr(&AlmUnack[140], Alm[140].Active && !Alm[140].Old, AckAll || DI[127]);
    Alm[140].Horn = Alm[140].Unack && !HornOff;
    Alm[140].Old = Alm[140].Active;
    Alm[141].Active = Vlv[7].PosErr && DI[92];
    Alm[141].Unack = sr(&AlmUnack[141], Alm[141].Active && !Alm[141].Old, AckAll || DI[254]);
    Alm[141].Horn = Alm[141].Unack && !HornOff;
    Alm[141].Old = Alm[141].Active;
    Alm[142].Active = Mot[41].FbkErr && !DI[95];
    Alm[142].Unack = sr(&AlmUnack[142], Alm[142].Active && !Alm[142].Old, AckAll || DI[253]);
    Alm[142].Horn = Alm[142].Unack && !HornOff;
    Alm[142].Old = Alm[142].Active;
    Alm[143].Active = Vlv[88].Locked && DI[139];
    Alm[143].Unack = sr(&AlmUnack[143], Alm[143].Active && !Alm[143].Old, AckAll || DI[32]);
    Alm[143].Horn = Alm[143].Unack && !HornOff;
    Alm[143].Old = Alm[143].Active;
    Alm[144].Active = Mot[117].Fault && DI[226];
    Alm[144].Unack = sr(&AlmUnack[144], Alm[144].Active && !Alm[144].Old, AckAll || DI[70]);
    Alm[144].Horn = Alm[144].Unack && !HornOff;
    Alm[144].Old = Alm[144].Active;
    Alm[145].Active = Vlv[85].PosErr && DI[190];
    Alm[145].Unack = sr(&AlmUnack[145], Alm[145].Active && !Alm[145].Old, AckAll || DI[36]);
    Alm[145].Horn = Alm[145].Unack && !HornOff;
    Alm[145].Old = Alm[145].Active;
    Alm[146].Active = !Grp[7].EStopOk && DI[217];
    Alm[146].Unack = sr(&AlmUnack[146], Alm[146].Active && !Alm[146].Old, AckAll || DI[105]);
    Alm[146].Horn = Alm[146].Unack && !HornOff;
    Alm[146].Old = Alm[146].Active;
    Alm[147].Active = Mot[111].FbkErr && DI[92];
    Alm[147].Unack = sr(&AlmUnack[147], Alm[147].Active && !Alm[147].Old, AckAll || DI[88]);
    Alm[147].Horn = Alm[147].Unack && !HornOff;
    Alm[147].Old = Alm[147].Active;
    Alm[148].Active = Mot[88].FbkErr && DI[221];
    Alm[148].Unack = sr(&AlmUnack[148], Alm[148].Active && !Alm[148].Old, AckAll || DI[212]);
    Alm[148].Horn = Alm[148].Unack && !HornOff;
    Alm[148].Old = Alm[148].Active;
    Alm[149].Active = Mot[74].Fault && !DI[69];
    Alm[149].Unack = sr(&AlmUnack[149], Alm[149].Active && !Alm[149].Old, AckAll || DI[84]);
    Alm[149].Horn = Alm[149].Unack && !HornOff;
    Alm[149].Old = Alm[149].Active;
    Alm[150].Active = Vlv[63].PosErr && DI[212];
    Alm[150].Unack = sr(&AlmUnack[150], Alm[150].Active && !Alm[150].Old, AckAll || DI[85]);
    Alm[150].Horn = Alm[150].Unack && !HornOff;
    Alm[150].Old = Alm[150].Active;
    Alm[151].Active = !Grp[3].EStopOk && DI[59];
    Alm[151].Unack = sr(&AlmUnack[151], Alm[151].Active && !Alm[151].Old, AckAll || DI[219]);
    Alm[151].Horn = Alm[151].Unack && !HornOff;
    Alm[151].Old = Alm[151].Active;
    Alm[152].Active = Mot[11].FbkErr && DI[90];
    Alm[152].Unack = sr(&AlmUnack[152], Alm[152].Active && !Alm[152].Old, AckAll || DI[108]);
    Alm[152].Horn = Alm[152].Unack && !HornOff;
    Alm[152].Old = Alm[152].Active;
    Alm[153].Active = Mot[31].Fault && DI[38];
    Alm[153].Unack = sr(&AlmUnack[153], Alm[153].Active && !Alm[153].Old, AckAll || DI[166]);
    Alm[153].Horn = Alm[153].Unack && !HornOff;
    Alm[153].Old = Alm[153].Active;
    Alm[154].Active = Vlv[7].Locked && DI[39];
    Alm[154].Unack = sr(&AlmUnack[154], Alm[154].Active && !Alm[154].Old, AckAll || DI[108]);
    Alm[154].Horn = Alm[154].Unack && !HornOff;
    Alm[154].Old = Alm[154].Active;
    Alm[155].Active = Mot[105].FbkErr && !DI[215];
    Alm[155].Unack = sr(&AlmUnack[155], Alm[155].Active && !Alm[155].Old, AckAll || DI[108]);
    Alm[155].Horn = Alm[155].Unack && !HornOff;
    Alm[155].Old = Alm[155].Active;
    Alm[156].Active = !Grp[8].EStopOk && DI[60];
    Alm[156].Unack = sr(&AlmUnack[156], Alm[156].Active && !Alm[156].Old, AckAll || DI[47]);
    Alm[156].Horn = Alm[156].Unack && !HornOff;
    Alm[156].Old = Alm[156].Active;
    Alm[157].Active = Vlv[39].PosErr && !DI[112];
    Alm[157].Unack = sr(&AlmUnack[157], Alm[157].Active && !Alm[157].Old, AckAll || DI[170]);
    Alm[157].Horn = Alm[157].Unack && !HornOff;
    Alm[157].Old = Alm[157].Active;
    Alm[158].Active = Mot[117].Fault && DI[246];
    Alm[158].Unack = sr(&AlmUnack[158], Alm[158].Active && !Alm[158].Old, AckAll || DI[144]);
    Alm[158].Horn = Alm[158].Unack && !HornOff;
    Alm[158].Old = Alm[158].Active;
    Alm[159].Active = Vlv[74].Locked && DI[3];
    Alm[159].Unack = sr(&AlmUnack[159], Alm[159].Active && !Alm[159].Old, AckAll || DI[254]);
    Alm[159].Horn = Alm[159].Unack && !HornOff;
    Alm[159].Old = Alm[159].Active;

    /* alarms 160 and following */
    Alm[160].Active = Vlv[9].Locked && !DI[4];
    Alm[160].Unack = sr(&AlmUnack[160], Alm[160].Active && !Alm[160].Old, AckAll || DI[140]);
    Alm[160].Horn = Alm[160].Unack && !HornOff;
    Alm[160].Old = Alm[160].Active;
    Alm[161].Active = !Grp[11].EStopOk && DI[190];
    Alm[161].Unack = sr(&AlmUnack[161], Alm[161].Active && !Alm[161].Old, AckAll || DI[21]);
    Alm[161].Horn = Alm[161].Unack && !HornOff;
    Alm[161].Old = Alm[161].Active;
    Alm[162].Active = !Grp[21].EStopOk && !DI[58];
    Alm[162].Unack = sr(&AlmUnack[162], Alm[162].Active && !Alm[162].Old, AckAll || DI[104]);
    Alm[162].Horn = Alm[162].Unack && !HornOff;
    Alm[162].Old = Alm[162].Active;
    Alm[163].Active = Mot[22].Fault && DI[49];
    Alm[163].Unack = sr(&AlmUnack[163], Alm[163].Active && !Alm[163].Old, AckAll || DI[135]);
    Alm[163].Horn = Alm[163].Unack && !HornOff;
    Alm[163].Old = Alm[163].Active;
    Alm[164].Active = Vlv[18].PosErr && !DI[45];
    Alm[164].Unack = sr(&AlmUnack[164], Alm[164].Active && !Alm[164].Old, AckAll || DI[170]);
    Alm[164].Horn = Alm[164].Unack && !HornOff;
    Alm[164].Old = Alm[164].Active;
    Alm[165].Active = Mot[120].FbkErr && !DI[57];
    Alm[165].Unack = sr(&AlmUnack[165], Alm[165].Active && !Alm[165].Old, AckAll || DI[157]);
    Alm[165].Horn = Alm[165].Unack && !HornOff;
    Alm[165].Old = Alm[165].Active;
    Alm[166].Active = Mot[19].FbkErr && DI[212];
    Alm[166].Unack = sr(&AlmUnack[166], Alm[166].Active && !Alm[166].Old, AckAll || DI[70]);
    Alm[166].Horn = Alm[166].Unack && !HornOff;
    Alm[166].Old = Alm[166].Active;
    Alm[167].Active = Mot[37].FbkErr && !DI[214];
    Alm[167].Unack = sr(&AlmUnack[167], Alm[167].Active && !Alm[167].Old, AckAll || DI[190]);
    Alm[167].Horn = Alm[167].Unack && !HornOff;
    Alm[167].Old = Alm[167].Active;
    Alm[168].Active = Vlv[37].PosErr && DI[168];
    Alm[168].Unack = sr(&AlmUnack[168], Alm[168].Active && !Alm[168].Old, AckAll || DI[0]);
    Alm[168].Horn = Alm[168].Unack && !HornOff;
    Alm[168].Old = Alm[168].Active;
    Alm[169].Active = Mot[97].Fault && DI[90];
    Alm[169].Unack = sr(&AlmUnack[169], Alm[169].Active && !Alm[169].Old, AckAll || DI[31]);
    Alm[169].Horn = Alm[169].Unack && !HornOff;
    Alm[169].Old = Alm[169].Active;
    Alm[170].Active = Vlv[22].PosErr && DI[70];
    Alm[170].Unack = sr(&AlmUnack[170], Alm[170].Active && !Alm[170].Old, AckAll || DI[9]);
    Alm[170].Horn = Alm[170].Unack && !HornOff;
    Alm[170].Old = Alm[170].Active;
    Alm[171].Active = Vlv[26].Locked && !DI[84];
    Alm[171].Unack = sr(&AlmUnack[171], Alm[171].Active && !Alm[171].Old, AckAll || DI[134]);
    Alm[171].Horn = Alm[171].Unack && !HornOff;
    Alm[171].Old = Alm[171].Active;
    Alm[172].Active = Mot[20].Fault && DI[113];
    Alm[172].Unack = sr(&AlmUnack[172], Alm[172].Active && !Alm[172].Old, AckAll || DI[163]);
    Alm[172].Horn = Alm[172].Unack && !HornOff;
    Alm[172].Old = Alm[172].Active;
    Alm[173].Active = Mot[68].Fault && !DI[243];
    Alm[173].Unack = sr(&AlmUnack[173], Alm[173].Active && !Alm[173].Old, AckAll || DI[214]);
    Alm[173].Horn = Alm[173].Unack && !HornOff;
    Alm[173].Old = Alm[173].Active;
    Alm[174].Active = Vlv[34].PosErr && !DI[96];
    Alm[174].Unack = sr(&AlmUnack[174], Alm[174].Active && !Alm[174].Old, AckAll || DI[57]);
    Alm[174].Horn = Alm[174].Unack && !HornOff;
    Alm[174].Old = Alm[174].Active;
    Alm[175].Active = Vlv[13].Locked && !DI[126];
    Alm[175].Unack = sr(&AlmUnack[175], Alm[175].Active && !Alm[175].Old, AckAll || DI[150]);
    Alm[175].Horn = Alm[175].Unack && !HornOff;
    Alm[175].Old = Alm[175].Active;
    Alm[176].Active = !Grp[7].EStopOk && DI[255];
    Alm[176].Unack = sr(&AlmUnack[176], Alm[176].Active && !Alm[176].Old, AckAll || DI[68]);
    Alm[176].Horn = Alm[176].Unack && !HornOff;
    Alm[176].Old = Alm[176].Active;
    Alm[177].Active = Mot[85].Fault && DI[99];
    Alm[177].Unack = sr(&AlmUnack[177], Alm[177].Active && !Alm[177].Old, AckAll || DI[121]);
    Alm[177].Horn = Alm[177].Unack && !HornOff;
    Alm[177].Old = Alm[177].Active;
    Alm[178].Active = !Grp[15].EStopOk && DI[235];
    Alm[178].Unack = sr(&AlmUnack[178], Alm[178].Active && !Alm[178].Old, AckAll || DI[223]);
    Alm[178].Horn = Alm[178].Unack && !HornOff;
    Alm[178].Old = Alm[178].Active;
    Alm[179].Active = Mot[104].Fault && !DI[197];
    Alm[179].Unack = sr(&AlmUnack[179], Alm[179].Active && !Alm[179].Old, AckAll || DI[221]);
    Alm[179].Horn = Alm[179].Unack && !HornOff;
    Alm[179].Old = Alm[179].Active;

    /* alarms 180 and following */
    Alm[180].Active = !Grp[14].EStopOk && !DI[191];
    Alm[180].Unack = sr(&AlmUnack[180], Alm[180].Active && !Alm[180].Old, AckAll || DI[221]);
    Alm[180].Horn = Alm[180].Unack && !HornOff;
    Alm[180].Old = Alm[180].Active;
    Alm[181].Active = !Grp[0].EStopOk && DI[18];
    Alm[181].Unack = sr(&AlmUnack[181], Alm[181].Active && !Alm[181].Old, AckAll || DI[46]);
    Alm[181].Horn = Alm[181].Unack && !HornOff;
    Alm[181].Old = Alm[181].Active;
    Alm[182].Active = Mot[45].Fault && DI[154];
    Alm[182].Unack = sr(&AlmUnack[182], Alm[182].Active && !Alm[182].Old, AckAll || DI[211]);
    Alm[182].Horn = Alm[182].Unack && !HornOff;
    Alm[182].Old = Alm[182].Active;
    Alm[183].Active = Vlv[83].PosErr && !DI[115];
    Alm[183].Unack = sr(&AlmUnack[183], Alm[183].Active && !Alm[183].Old, AckAll || DI[64]);
    Alm[183].Horn = Alm[183].Unack && !HornOff;
    Alm[183].Old = Alm[183].Active;
    Alm[184].Active = !Grp[19].EStopOk && DI[154];
    Alm[184].Unack = sr(&AlmUnack[184], Alm[184].Active && !Alm[184].Old, AckAll || DI[253]);
    Alm[184].Horn = Alm[184].Unack && !HornOff;
    Alm[184].Old = Alm[184].Active;
    Alm[185].Active = !Grp[11].EStopOk && DI[126];
    Alm[185].Unack = sr(&AlmUnack[185], Alm[185].Active && !Alm[185].Old, AckAll || DI[2]);
    Alm[185].Horn = Alm[185].Unack && !HornOff;
    Alm[185].Old = Alm[185].Active;
    Alm[186].Active = !Grp[17].EStopOk && !DI[186];
    Alm[186].Unack = sr(&AlmUnack[186], Alm[186].Active && !Alm[186].Old, AckAll || DI[84]);
    Alm[186].Horn = Alm[186].Unack && !HornOff;
    Alm[186].Old = Alm[186].Active;
    Alm[187].Active = Vlv[11].Locked && DI[68];
    Alm[187].Unack = sr(&AlmUnack[187], Alm[187].Active && !Alm[187].Old, AckAll || DI[215]);
    Alm[187].Horn = Alm[187].Unack && !HornOff;
    Alm[187].Old = Alm[187].Active;
    Alm[188].Active = !Grp[25].EStopOk && DI[10];
    Alm[188].Unack = sr(&AlmUnack[188], Alm[188].Active && !Alm[188].Old, AckAll || DI[179]);
    Alm[188].Horn = Alm[188].Unack && !HornOff;
    Alm[188].Old = Alm[188].Active;
    Alm[189].Active = Vlv[86].PosErr && DI[176];
    Alm[189].Unack = sr(&AlmUnack[189], Alm[189].Active && !Alm[189].Old, AckAll || DI[241]);
    Alm[189].Horn = Alm[189].Unack && !HornOff;
    Alm[189].Old = Alm[189].Active;
    Alm[190].Active = Vlv[44].Locked && DI[162];
    Alm[190].Unack = sr(&AlmUnack[190], Alm[190].Active && !Alm[190].Old, AckAll || DI[249]);
    Alm[190].Horn = Alm[190].Unack && !HornOff;
    Alm[190].Old = Alm[190].Active;
    Alm[191].Active = Mot[115].Fault && !DI[198];
    Alm[191].Unack = sr(&AlmUnack[191], Alm[191].Active && !Alm[191].Old, AckAll || DI[130]);
    Alm[191].Horn = Alm[191].Unack && !HornOff;
    Alm[191].Old = Alm[191].Active;
    Alm[192].Active = !Grp[0].EStopOk && DI[215];
    Alm[192].Unack = sr(&AlmUnack[192], Alm[192].Active && !Alm[192].Old, AckAll || DI[142]);
    Alm[192].Horn = Alm[192].Unack && !HornOff;
    Alm[192].Old = Alm[192].Active;
    Alm[193].Active = !Grp[2].EStopOk && DI[181];
    Alm[193].Unack = sr(&AlmUnack[193], Alm[193].Active && !Alm[193].Old, AckAll || DI[108]);
    Alm[193].Horn = Alm[193].Unack && !HornOff;
    Alm[193].Old = Alm[193].Active;
    Alm[194].Active = Mot[107].Fault && !DI[78];
    Alm[194].Unack = sr(&AlmUnack[194], Alm[194].Active && !Alm[194].Old, AckAll || DI[190]);
    Alm[194].Horn = Alm[194].Unack && !HornOff;
    Alm[194].Old = Alm[194].Active;
    Alm[195].Active = !Grp[9].EStopOk && DI[57];
    Alm[195].Unack = sr(&AlmUnack[195], Alm[195].Active && !Alm[195].Old, AckAll || DI[165]);
    Alm[195].Horn = Alm[195].Unack && !HornOff;
    Alm[195].Old = Alm[195].Active;
    Alm[196].Active = Mot[63].FbkErr && DI[135];
    Alm[196].Unack = sr(&AlmUnack[196], Alm[196].Active && !Alm[196].Old, AckAll || DI[46]);
    Alm[196].Horn = Alm[196].Unack && !HornOff;
    Alm[196].Old = Alm[196].Active;
    Alm[197].Active = Vlv[46].PosErr && DI[212];
    Alm[197].Unack = sr(&AlmUnack[197], Alm[197].Active && !Alm[197].Old, AckAll || DI[255]);
    Alm[197].Horn = Alm[197].Unack && !HornOff;
    Alm[197].Old = Alm[197].Active;
    Alm[198].Active = Mot[78].Fault && !DI[48];
    Alm[198].Unack = sr(&AlmUnack[198], Alm[198].Active && !Alm[198].Old, AckAll || DI[166]);
    Alm[198].Horn = Alm[198].Unack && !HornOff;
    Alm[198].Old = Alm[198].Active;
    Alm[199].Active = Mot[65].Fault && DI[204];
    Alm[199].Unack = sr(&AlmUnack[199], Alm[199].Active && !Alm[199].Old, AckAll || DI[12]);
    Alm[199].Horn = Alm[199].Unack && !HornOff;
    Alm[199].Old = Alm[199].Active;

    /* alarms 200 and following */
    Alm[200].Active = Vlv[4].PosErr && DI[243];
    Alm[200].Unack = sr(&AlmUnack[200], Alm[200].Active && !Alm[200].Old, AckAll || DI[241]);
    Alm[200].Horn = Alm[200].Unack && !HornOff;
    Alm[200].Old = Alm[200].Active;
    Alm[201].Active = Mot[47].FbkErr && DI[69];
    Alm[201].Unack = sr(&AlmUnack[201], Alm[201].Active && !Alm[201].Old, AckAll || DI[8]);
    Alm[201].Horn = Alm[201].Unack && !HornOff;
    Alm[201].Old = Alm[201].Active;
    Alm[202].Active = Mot[20].FbkErr && DI[176];
    Alm[202].Unack = sr(&AlmUnack[202], Alm[202].Active && !Alm[202].Old, AckAll || DI[128]);
    Alm[202].Horn = Alm[202].Unack && !HornOff;
    Alm[202].Old = Alm[202].Active;
    Alm[203].Active = !Grp[2].EStopOk && DI[204];
    Alm[203].Unack = sr(&AlmUnack[203], Alm[203].Active && !Alm[203].Old, AckAll || DI[19]);
    Alm[203].Horn = Alm[203].Unack && !HornOff;
    Alm[203].Old = Alm[203].Active;
    Alm[204].Active = Vlv[40].Locked && !DI[52];
    Alm[204].Unack = sr(&AlmUnack[204], Alm[204].Active && !Alm[204].Old, AckAll || DI[115]);
    Alm[204].Horn = Alm[204].Unack && !HornOff;
    Alm[204].Old = Alm[204].Active;
    Alm[205].Active = Mot[114].Fault && !DI[36];
    Alm[205].Unack = sr(&AlmUnack[205], Alm[205].Active && !Alm[205].Old, AckAll || DI[178]);
    Alm[205].Horn = Alm[205].Unack && !HornOff;
    Alm[205].Old = Alm[205].Active;
    Alm[206].Active = Vlv[3].PosErr && DI[227];
    Alm[206].Unack = sr(&AlmUnack[206], Alm[206].Active && !Alm[206].Old, AckAll || DI[0]);
    Alm[206].Horn = Alm[206].Unack && !HornOff;
    Alm[206].Old = Alm[206].Active;
    Alm[207].Active = Mot[53].Fault && !DI[123];
    Alm[207].Unack = sr(&AlmUnack[207], Alm[207].Active && !Alm[207].Old, AckAll || DI[52]);
    Alm[207].Horn = Alm[207].Unack && !HornOff;
    Alm[207].Old = Alm[207].Active;
    Alm[208].Active = Vlv[7].Locked && DI[63];
    Alm[208].Unack = sr(&AlmUnack[208], Alm[208].Active && !Alm[208].Old, AckAll || DI[243]);
    Alm[208].Horn = Alm[208].Unack && !HornOff;
    Alm[208].Old = Alm[208].Active;
    Alm[209].Active = Vlv[10].Locked && DI[23];
    Alm[209].Unack = sr(&AlmUnack[209], Alm[209].Active && !Alm[209].Old, AckAll || DI[99]);
    Alm[209].Horn = Alm[209].Unack && !HornOff;
    Alm[209].Old = Alm[209].Active;
    Alm[210].Active = Vlv[32].Locked && DI[188];
    Alm[210].Unack = sr(&AlmUnack[210], Alm[210].Active && !Alm[210].Old, AckAll || DI[85]);
    Alm[210].Horn = Alm[210].Unack && !HornOff;
    Alm[210].Old = Alm[210].Active;
    Alm[211].Active = !Grp[8].EStopOk && DI[64];
    Alm[211].Unack = sr(&AlmUnack[211], Alm[211].Active && !Alm[211].Old, AckAll || DI[178]);
    Alm[211].Horn = Alm[211].Unack && !HornOff;
    Alm[211].Old = Alm[211].Active;
    Alm[212].Active = Mot[108].FbkErr && DI[156];
    Alm[212].Unack = sr(&AlmUnack[212], Alm[212].Active && !Alm[212].Old, AckAll || DI[34]);
    Alm[212].Horn = Alm[212].Unack && !HornOff;
    Alm[212].Old = Alm[212].Active;
    Alm[213].Active = Vlv[42].Locked && !DI[46];
    Alm[213].Unack = sr(&AlmUnack[213], Alm[213].Active && !Alm[213].Old, AckAll || DI[243]);
    Alm[213].Horn = Alm[213].Unack && !HornOff;
    Alm[213].Old = Alm[213].Active;
    Alm[214].Active = Vlv[77].PosErr && DI[206];
    Alm[214].Unack = sr(&AlmUnack[214], Alm[214].Active && !Alm[214].Old, AckAll || DI[210]);
    Alm[214].Horn = Alm[214].Unack && !HornOff;
    Alm[214].Old = Alm[214].Active;
    Alm[215].Active = Mot[60].Fault && !DI[141];
    Alm[215].Unack = sr(&AlmUnack[215], Alm[215].Active && !Alm[215].Old, AckAll || DI[100]);
    Alm[215].Horn = Alm[215].Unack && !HornOff;
    Alm[215].Old = Alm[215].Active;
    Alm[216].Active = !Grp[17].EStopOk && DI[219];
    Alm[216].Unack = sr(&AlmUnack[216], Alm[216].Active && !Alm[216].Old, AckAll || DI[20]);
    Alm[216].Horn = Alm[216].Unack && !HornOff;
    Alm[216].Old = Alm[216].Active;
    Alm[217].Active = Vlv[74].Locked && DI[179];
    Alm[217].Unack = sr(&AlmUnack[217], Alm[217].Active && !Alm[217].Old, AckAll || DI[94]);
    Alm[217].Horn = Alm[217].Unack && !HornOff;
    Alm[217].Old = Alm[217].Active;
    Alm[218].Active = !Grp[21].EStopOk && DI[238];
    Alm[218].Unack = sr(&AlmUnack[218], Alm[218].Active && !Alm[218].Old, AckAll || DI[247]);
    Alm[218].Horn = Alm[218].Unack && !HornOff;
    Alm[218].Old = Alm[218].Active;
    Alm[219].Active = Mot[19].Fault && DI[172];
    Alm[219].Unack = sr(&AlmUnack[219], Alm[219].Active && !Alm[219].Old, AckAll || DI[97]);
    Alm[219].Horn = Alm[219].Unack && !HornOff;
    Alm[219].Old = Alm[219].Active;

    /* alarms 220 and following */
    Alm[220].Active = Vlv[43].Locked && !DI[102];
    Alm[220].Unack = sr(&AlmUnack[220], Alm[220].Active && !Alm[220].Old, AckAll || DI[197]);
    Alm[220].Horn = Alm[220].Unack && !HornOff;
    Alm[220].Old = Alm[220].Active;
    Alm[221].Active = !Grp[27].EStopOk && DI[252];
    Alm[221].Unack = sr(&AlmUnack[221], Alm[221].Active && !Alm[221].Old, AckAll || DI[112]);
    Alm[221].Horn = Alm[221].Unack && !HornOff;
    Alm[221].Old = Alm[221].Active;
    Alm[222].Active = Vlv[48].PosErr && !DI[82];
    Alm[222].Unack = sr(&AlmUnack[222], Alm[222].Active && !Alm[222].Old, AckAll || DI[44]);
    Alm[222].Horn = Alm[222].Unack && !HornOff;
    Alm[222].Old = Alm[222].Active;
    Alm[223].Active = !Grp[25].EStopOk && !DI[22];
    Alm[223].Unack = sr(&AlmUnack[223], Alm[223].Active && !Alm[223].Old, AckAll || DI[3]);
    Alm[223].Horn = Alm[223].Unack && !HornOff;
    Alm[223].Old = Alm[223].Active;
    Alm[224].Active = Mot[75].Fault && DI[90];
    Alm[224].Unack = sr(&AlmUnack[224], Alm[224].Active && !Alm[224].Old, AckAll || DI[46]);
    Alm[224].Horn = Alm[224].Unack && !HornOff;
    Alm[224].Old = Alm[224].Active;
    Alm[225].Active = Vlv[6].Locked && DI[92];
    Alm[225].Unack = sr(&AlmUnack[225], Alm[225].Active && !Alm[225].Old, AckAll || DI[221]);
    Alm[225].Horn = Alm[225].Unack && !HornOff;
    Alm[225].Old = Alm[225].Active;
    Alm[226].Active = Vlv[41].PosErr && DI[32];
    Alm[226].Unack = sr(&AlmUnack[226], Alm[226].Active && !Alm[226].Old, AckAll || DI[57]);
    Alm[226].Horn = Alm[226].Unack && !HornOff;
    Alm[226].Old = Alm[226].Active;
    Alm[227].Active = Vlv[34].PosErr && DI[43];
    Alm[227].Unack = sr(&AlmUnack[227], Alm[227].Active && !Alm[227].Old, AckAll || DI[133]);
    Alm[227].Horn = Alm[227].Unack && !HornOff;
    Alm[227].Old = Alm[227].Active;
    Alm[228].Active = Vlv[27].Locked && !DI[2];
    Alm[228].Unack = sr(&AlmUnack[228], Alm[228].Active && !Alm[228].Old, AckAll || DI[99]);
    Alm[228].Horn = Alm[228].Unack && !HornOff;
    Alm[228].Old = Alm[228].Active;
    Alm[229].Active = Vlv[16].PosErr && !DI[198];
    Alm[229].Unack = sr(&AlmUnack[229], Alm[229].Active && !Alm[229].Old, AckAll || DI[18]);
    Alm[229].Horn = Alm[229].Unack && !HornOff;
    Alm[229].Old = Alm[229].Active;

    int32_t sum = 0;
    for (int i = 0; i < 130; i++) {
        if (Mot[i].Run) sum += 1;
        if (Mot[i].Fault) sum += 3;
        if (Mot[i].Lamp) sum += i;
    }
    for (int i = 0; i < 90; i++) {
        if (Vlv[i].Opened) sum += 5;
        if (Vlv[i].Locked) sum += i;
    }
    for (int i = 0; i < 230; i++)
        if (Alm[i].Horn) sum += i;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
