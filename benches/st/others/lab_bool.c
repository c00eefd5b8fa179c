/* relay logic of a small plant: 451 rungs */
#include <stdbool.h>
#include "st.h"

static bool DI[64];
static uint32_t rnd = 12345;
static uint32_t w0, w1;
static bool Sys_Auto, Sys_Man, Sys_EStop, Sys_Reset, Sys_Run, Sys_Flash, Sys_Horn, Sys_AnyFault;
static bool M01_Start, M01_Stop, M01_Ovl, M01_Perm, M01_Ilk, M01_Cmd, M01_Run, M01_Fault;
static bool M01_Warn, M01_Lamp, M02_Start, M02_Stop, M02_Ovl, M02_Perm, M02_Ilk, M02_Cmd;
static bool M02_Run, M02_Fault, M02_Warn, M02_Lamp, M03_Start, M03_Stop, M03_Ovl, M03_Perm;
static bool M03_Ilk, M03_Cmd, M03_Run, M03_Fault, M03_Warn, M03_Lamp, M04_Start, M04_Stop;
static bool M04_Ovl, M04_Perm, M04_Ilk, M04_Cmd, M04_Run, M04_Fault, M04_Warn, M04_Lamp;
static bool M05_Start, M05_Stop, M05_Ovl, M05_Perm, M05_Ilk, M05_Cmd, M05_Run, M05_Fault;
static bool M05_Warn, M05_Lamp, M06_Start, M06_Stop, M06_Ovl, M06_Perm, M06_Ilk, M06_Cmd;
static bool M06_Run, M06_Fault, M06_Warn, M06_Lamp, M07_Start, M07_Stop, M07_Ovl, M07_Perm;
static bool M07_Ilk, M07_Cmd, M07_Run, M07_Fault, M07_Warn, M07_Lamp, M08_Start, M08_Stop;
static bool M08_Ovl, M08_Perm, M08_Ilk, M08_Cmd, M08_Run, M08_Fault, M08_Warn, M08_Lamp;
static bool M09_Start, M09_Stop, M09_Ovl, M09_Perm, M09_Ilk, M09_Cmd, M09_Run, M09_Fault;
static bool M09_Warn, M09_Lamp, M10_Start, M10_Stop, M10_Ovl, M10_Perm, M10_Ilk, M10_Cmd;
static bool M10_Run, M10_Fault, M10_Warn, M10_Lamp, M11_Start, M11_Stop, M11_Ovl, M11_Perm;
static bool M11_Ilk, M11_Cmd, M11_Run, M11_Fault, M11_Warn, M11_Lamp, M12_Start, M12_Stop;
static bool M12_Ovl, M12_Perm, M12_Ilk, M12_Cmd, M12_Run, M12_Fault, M12_Warn, M12_Lamp;
static bool M13_Start, M13_Stop, M13_Ovl, M13_Perm, M13_Ilk, M13_Cmd, M13_Run, M13_Fault;
static bool M13_Warn, M13_Lamp, M14_Start, M14_Stop, M14_Ovl, M14_Perm, M14_Ilk, M14_Cmd;
static bool M14_Run, M14_Fault, M14_Warn, M14_Lamp, M15_Start, M15_Stop, M15_Ovl, M15_Perm;
static bool M15_Ilk, M15_Cmd, M15_Run, M15_Fault, M15_Warn, M15_Lamp, M16_Start, M16_Stop;
static bool M16_Ovl, M16_Perm, M16_Ilk, M16_Cmd, M16_Run, M16_Fault, M16_Warn, M16_Lamp;
static bool M17_Start, M17_Stop, M17_Ovl, M17_Perm, M17_Ilk, M17_Cmd, M17_Run, M17_Fault;
static bool M17_Warn, M17_Lamp, M18_Start, M18_Stop, M18_Ovl, M18_Perm, M18_Ilk, M18_Cmd;
static bool M18_Run, M18_Fault, M18_Warn, M18_Lamp, M19_Start, M19_Stop, M19_Ovl, M19_Perm;
static bool M19_Ilk, M19_Cmd, M19_Run, M19_Fault, M19_Warn, M19_Lamp, M20_Start, M20_Stop;
static bool M20_Ovl, M20_Perm, M20_Ilk, M20_Cmd, M20_Run, M20_Fault, M20_Warn, M20_Lamp;
static bool M21_Start, M21_Stop, M21_Ovl, M21_Perm, M21_Ilk, M21_Cmd, M21_Run, M21_Fault;
static bool M21_Warn, M21_Lamp, M22_Start, M22_Stop, M22_Ovl, M22_Perm, M22_Ilk, M22_Cmd;
static bool M22_Run, M22_Fault, M22_Warn, M22_Lamp, M23_Start, M23_Stop, M23_Ovl, M23_Perm;
static bool M23_Ilk, M23_Cmd, M23_Run, M23_Fault, M23_Warn, M23_Lamp, M24_Start, M24_Stop;
static bool M24_Ovl, M24_Perm, M24_Ilk, M24_Cmd, M24_Run, M24_Fault, M24_Warn, M24_Lamp;
static bool M25_Start, M25_Stop, M25_Ovl, M25_Perm, M25_Ilk, M25_Cmd, M25_Run, M25_Fault;
static bool M25_Warn, M25_Lamp, M26_Start, M26_Stop, M26_Ovl, M26_Perm, M26_Ilk, M26_Cmd;
static bool M26_Run, M26_Fault, M26_Warn, M26_Lamp, M27_Start, M27_Stop, M27_Ovl, M27_Perm;
static bool M27_Ilk, M27_Cmd, M27_Run, M27_Fault, M27_Warn, M27_Lamp, M28_Start, M28_Stop;
static bool M28_Ovl, M28_Perm, M28_Ilk, M28_Cmd, M28_Run, M28_Fault, M28_Warn, M28_Lamp;
static bool V01_Req, V01_OpenCmd, V01_CloseCmd, V01_IsOpen, V01_IsClosed, V01_Fault, V02_Req, V02_OpenCmd;
static bool V02_CloseCmd, V02_IsOpen, V02_IsClosed, V02_Fault, V03_Req, V03_OpenCmd, V03_CloseCmd, V03_IsOpen;
static bool V03_IsClosed, V03_Fault, V04_Req, V04_OpenCmd, V04_CloseCmd, V04_IsOpen, V04_IsClosed, V04_Fault;
static bool V05_Req, V05_OpenCmd, V05_CloseCmd, V05_IsOpen, V05_IsClosed, V05_Fault, V06_Req, V06_OpenCmd;
static bool V06_CloseCmd, V06_IsOpen, V06_IsClosed, V06_Fault, V07_Req, V07_OpenCmd, V07_CloseCmd, V07_IsOpen;
static bool V07_IsClosed, V07_Fault, V08_Req, V08_OpenCmd, V08_CloseCmd, V08_IsOpen, V08_IsClosed, V08_Fault;
static bool V09_Req, V09_OpenCmd, V09_CloseCmd, V09_IsOpen, V09_IsClosed, V09_Fault, V10_Req, V10_OpenCmd;
static bool V10_CloseCmd, V10_IsOpen, V10_IsClosed, V10_Fault, V11_Req, V11_OpenCmd, V11_CloseCmd, V11_IsOpen;
static bool V11_IsClosed, V11_Fault, V12_Req, V12_OpenCmd, V12_CloseCmd, V12_IsOpen, V12_IsClosed, V12_Fault;
static bool V13_Req, V13_OpenCmd, V13_CloseCmd, V13_IsOpen, V13_IsClosed, V13_Fault, V14_Req, V14_OpenCmd;
static bool V14_CloseCmd, V14_IsOpen, V14_IsClosed, V14_Fault, V15_Req, V15_OpenCmd, V15_CloseCmd, V15_IsOpen;
static bool V15_IsClosed, V15_Fault, V16_Req, V16_OpenCmd, V16_CloseCmd, V16_IsOpen, V16_IsClosed, V16_Fault;
static bool S00, S01, S02, S03, S04, S05, S06, S07;
static bool S08, S09, S10, S11, A01_Trip, A01_Act, A01_New, A01_Ack;
static bool A02_Trip, A02_Act, A02_New, A02_Ack, A03_Trip, A03_Act, A03_New, A03_Ack;
static bool A04_Trip, A04_Act, A04_New, A04_Ack, A05_Trip, A05_Act, A05_New, A05_Ack;
static bool A06_Trip, A06_Act, A06_New, A06_Ack, A07_Trip, A07_Act, A07_New, A07_Ack;
static bool A08_Trip, A08_Act, A08_New, A08_Ack, A09_Trip, A09_Act, A09_New, A09_Ack;
static bool A10_Trip, A10_Act, A10_New, A10_Ack, A11_Trip, A11_Act, A11_New, A11_Ack;
static bool A12_Trip, A12_Act, A12_New, A12_Ack, Grp0, Grp1, Grp2, Grp3;
static bool Grp4, Grp5, Grp6;

static uint32_t rol(uint32_t v, int n) { return (v << n) | (v >> (32 - n)); }

void scan(void)
{
    uint32_t x, t;
    int32_t n;
    int i;

    rnd = rnd * 1664525u + 1013904223u;
    x = rnd;
    w0 ^= x & rol(x, 7) & rol(x, 13);
    rnd = rnd * 1664525u + 1013904223u;
    x = rnd;
    w1 ^= x & rol(x, 5) & rol(x, 18);
    t = w0;
    for (i = 0; i < 32; i++) {
        DI[i] = (t & 1) != 0;
        t >>= 1;
    }
    t = w1;
    for (i = 32; i < 64; i++) {
        DI[i] = (t & 1) != 0;
        t >>= 1;
    }

    /* machine mode */
    Sys_EStop = !DI[0] && !DI[1];
    Sys_Reset = DI[2] && !Sys_EStop;
    Sys_Auto = (DI[3] || Sys_Auto) && !DI[4] && !Sys_EStop;
    Sys_Man = !Sys_Auto && DI[5];
    Sys_Run = ((DI[6] && Sys_Auto) || Sys_Run) && !DI[7] && !Sys_AnyFault;
    Sys_Flash = !Sys_Flash;

    /* motor 1 */
    M01_Start = (Sys_Auto && Sys_Run && DI[43]) || (Sys_Man && DI[33]);
    M01_Stop = DI[46] || !DI[47] || Sys_EStop;
    M01_Ovl = DI[2];
    M01_Perm = (DI[38] || DI[15]) && !Sys_EStop;
    M01_Ilk = DI[6] || Sys_Man;
    M01_Fault = (M01_Ovl || (M01_Cmd && !DI[52] && !DI[45]) || M01_Fault) && !Sys_Reset;
    M01_Cmd = (M01_Start || M01_Cmd) && !M01_Stop && M01_Perm && M01_Ilk && !M01_Fault;
    M01_Run = M01_Cmd && !DI[38];
    M01_Warn = (M01_Cmd && !M01_Run) || (DI[3] && M01_Ovl);
    M01_Lamp = M01_Run || (M01_Fault && Sys_Flash);

    /* motor 2 */
    M02_Start = (Sys_Auto && Sys_Run && DI[0]) || (Sys_Man && DI[30]);
    M02_Stop = (DI[38] && DI[53]) || Sys_EStop;
    M02_Ovl = DI[26];
    M02_Perm = (DI[47] && !DI[52]) || Sys_Man;
    M02_Ilk = (M01_Run && DI[31]) || (Sys_Man && DI[7]);
    M02_Fault = (M02_Ovl || (M02_Cmd && !DI[33] && !DI[47]) || M02_Fault) && !Sys_Reset;
    M02_Cmd = (M02_Start || M02_Cmd) && !M02_Stop && M02_Perm && M02_Ilk && !M02_Fault;
    M02_Run = M02_Cmd && !DI[35];
    M02_Warn = (M02_Cmd && !M02_Run) || (DI[19] && M02_Ovl);
    M02_Lamp = M02_Run || (M02_Fault && Sys_Flash);

    /* motor 3 */
    M03_Start = (Sys_Auto && Sys_Run && DI[7]) || (Sys_Man && DI[48]);
    M03_Stop = DI[42] || !DI[51] || Sys_EStop;
    M03_Ovl = DI[12];
    M03_Perm = !Sys_EStop && (DI[53] || !DI[56]);
    M03_Ilk = DI[42] || Sys_Man;
    M03_Fault = (M03_Ovl || (M03_Cmd && !DI[7] && !DI[14]) || M03_Fault) && !Sys_Reset;
    M03_Cmd = (M03_Start || M03_Cmd) && !M03_Stop && M03_Perm && M03_Ilk && !M03_Fault;
    M03_Run = M03_Cmd && (DI[7] || DI[37]);
    M03_Warn = (M03_Cmd && !M03_Run) || (DI[26] && M03_Ovl);
    M03_Lamp = M03_Run || (M03_Fault && Sys_Flash);

    /* motor 4 */
    M04_Start = (Sys_Auto && Sys_Run && DI[1]) || (Sys_Man && DI[42]);
    M04_Stop = (!DI[2] && Sys_Man) || (DI[30] && Sys_Auto);
    M04_Ovl = !DI[46];
    M04_Perm = (DI[54] && !DI[5]) || Sys_Man;
    M04_Ilk = DI[18] || Sys_Man;
    M04_Fault = (M04_Ovl || (M04_Cmd && !DI[9] && !DI[32]) || M04_Fault) && !Sys_Reset;
    M04_Cmd = (M04_Start || M04_Cmd) && !M04_Stop && M04_Perm && M04_Ilk && !M04_Fault;
    M04_Run = M04_Cmd && (DI[1] || DI[58]);
    M04_Warn = (M04_Cmd && !M04_Run) || (DI[17] && M04_Ovl);
    M04_Lamp = M04_Run || (M04_Fault && Sys_Flash);

    /* motor 5 */
    M05_Start = (Sys_Auto && Sys_Run && DI[40]) || (Sys_Man && DI[44]);
    M05_Stop = (DI[59] && DI[48]) || Sys_EStop;
    M05_Ovl = !DI[9];
    M05_Perm = (DI[28] && !DI[20]) || Sys_Man;
    M05_Ilk = (M04_Run && DI[63]) || (Sys_Man && DI[52]);
    M05_Fault = (M05_Ovl || (M05_Cmd && !DI[23] && !DI[23]) || M05_Fault) && !Sys_Reset;
    M05_Cmd = (M05_Start || M05_Cmd) && !M05_Stop && M05_Perm && M05_Ilk && !M05_Fault;
    M05_Run = M05_Cmd && (DI[7] || DI[6]);
    M05_Warn = (M05_Cmd && !M05_Run) || (DI[42] && M05_Ovl);
    M05_Lamp = M05_Run || (M05_Fault && Sys_Flash);

    /* motor 6 */
    M06_Start = (Sys_Auto && Sys_Run && DI[9]) || (Sys_Man && DI[48]);
    M06_Stop = (DI[53] && DI[12]) || Sys_EStop;
    M06_Ovl = DI[0];
    M06_Perm = (DI[24] && !DI[21]) || Sys_Man;
    M06_Ilk = (M05_Run && DI[27]) || (Sys_Man && DI[41]);
    M06_Fault = (M06_Ovl || (M06_Cmd && !DI[18] && !DI[52]) || M06_Fault) && !Sys_Reset;
    M06_Cmd = (M06_Start || M06_Cmd) && !M06_Stop && M06_Perm && M06_Ilk && !M06_Fault;
    M06_Run = M06_Cmd && (DI[44] || DI[40]);
    M06_Warn = (M06_Cmd && !M06_Run) || (DI[35] && M06_Ovl);
    M06_Lamp = M06_Run || (M06_Fault && Sys_Flash);

    /* motor 7 */
    M07_Start = (Sys_Auto && Sys_Run && DI[5]) || (Sys_Man && DI[52]);
    M07_Stop = (!DI[60] && Sys_Man) || (DI[38] && Sys_Auto);
    M07_Ovl = DI[31];
    M07_Perm = (DI[20] && !DI[11]) || Sys_Man;
    M07_Ilk = (M06_Run && DI[38]) || (Sys_Man && DI[38]);
    M07_Fault = (M07_Ovl || (M07_Cmd && !DI[28] && !DI[22]) || M07_Fault) && !Sys_Reset;
    M07_Cmd = (M07_Start || M07_Cmd) && !M07_Stop && M07_Perm && M07_Ilk && !M07_Fault;
    M07_Run = M07_Cmd && !DI[55];
    M07_Warn = (M07_Cmd && !M07_Run) || (DI[54] && M07_Ovl);
    M07_Lamp = M07_Run || (M07_Fault && Sys_Flash);

    /* motor 8 */
    M08_Start = (Sys_Auto && Sys_Run && DI[59]) || (Sys_Man && DI[3]);
    M08_Stop = DI[0] || !DI[13] || Sys_EStop;
    M08_Ovl = DI[17];
    M08_Perm = (DI[44] && !DI[30]) || Sys_Man;
    M08_Ilk = DI[58] || Sys_Man;
    M08_Fault = (M08_Ovl || (M08_Cmd && !DI[54] && !DI[2]) || M08_Fault) && !Sys_Reset;
    M08_Cmd = (M08_Start || M08_Cmd) && !M08_Stop && M08_Perm && M08_Ilk && !M08_Fault;
    M08_Run = M08_Cmd && !DI[7];
    M08_Warn = (M08_Cmd && !M08_Run) || (DI[3] && M08_Ovl);
    M08_Lamp = M08_Run || (M08_Fault && Sys_Flash);

    /* motor 9 */
    M09_Start = (Sys_Auto && Sys_Run && DI[35]) || (Sys_Man && DI[6]);
    M09_Stop = (DI[36] && DI[25]) || Sys_EStop;
    M09_Ovl = !DI[57];
    M09_Perm = (DI[23] && !DI[23]) || Sys_Man;
    M09_Ilk = (M08_Run && DI[32]) || (Sys_Man && DI[48]);
    M09_Fault = (M09_Ovl || (M09_Cmd && !DI[5] && !DI[21]) || M09_Fault) && !Sys_Reset;
    M09_Cmd = (M09_Start || M09_Cmd) && !M09_Stop && M09_Perm && M09_Ilk && !M09_Fault;
    M09_Run = M09_Cmd && !DI[12];
    M09_Warn = (M09_Cmd && !M09_Run) || (DI[36] && M09_Ovl);
    M09_Lamp = M09_Run || (M09_Fault && Sys_Flash);

    /* motor 10 */
    M10_Start = (Sys_Auto && Sys_Run && DI[41]) || (Sys_Man && DI[63]);
    M10_Stop = (DI[44] && DI[32]) || Sys_EStop;
    M10_Ovl = DI[27];
    M10_Perm = (DI[50] || DI[44]) && !Sys_EStop;
    M10_Ilk = (M09_Run && DI[20]) || (Sys_Man && DI[34]);
    M10_Fault = (M10_Ovl || (M10_Cmd && !DI[1] && !DI[61]) || M10_Fault) && !Sys_Reset;
    M10_Cmd = (M10_Start || M10_Cmd) && !M10_Stop && M10_Perm && M10_Ilk && !M10_Fault;
    M10_Run = M10_Cmd && !DI[40];
    M10_Warn = (M10_Cmd && !M10_Run) || (DI[51] && M10_Ovl);
    M10_Lamp = M10_Run || (M10_Fault && Sys_Flash);

    /* motor 11 */
    M11_Start = (Sys_Auto && Sys_Run && DI[33]) || (Sys_Man && DI[37]);
    M11_Stop = (DI[21] && DI[59]) || Sys_EStop;
    M11_Ovl = DI[59];
    M11_Perm = !Sys_EStop && (DI[45] || !DI[41]);
    M11_Ilk = DI[39] || Sys_Man;
    M11_Fault = (M11_Ovl || (M11_Cmd && !DI[1] && !DI[15]) || M11_Fault) && !Sys_Reset;
    M11_Cmd = (M11_Start || M11_Cmd) && !M11_Stop && M11_Perm && M11_Ilk && !M11_Fault;
    M11_Run = M11_Cmd && !DI[9];
    M11_Warn = (M11_Cmd && !M11_Run) || (DI[53] && M11_Ovl);
    M11_Lamp = M11_Run || (M11_Fault && Sys_Flash);

    /* motor 12 */
    M12_Start = (Sys_Auto && Sys_Run && DI[38]) || (Sys_Man && DI[51]);
    M12_Stop = (!DI[22] && Sys_Man) || (DI[34] && Sys_Auto);
    M12_Ovl = DI[11];
    M12_Perm = (DI[3] || DI[15]) && !Sys_EStop;
    M12_Ilk = (M11_Run && DI[57]) || (Sys_Man && DI[6]);
    M12_Fault = (M12_Ovl || (M12_Cmd && !DI[9] && !DI[45]) || M12_Fault) && !Sys_Reset;
    M12_Cmd = (M12_Start || M12_Cmd) && !M12_Stop && M12_Perm && M12_Ilk && !M12_Fault;
    M12_Run = M12_Cmd && (DI[29] || DI[60]);
    M12_Warn = (M12_Cmd && !M12_Run) || (DI[18] && M12_Ovl);
    M12_Lamp = M12_Run || (M12_Fault && Sys_Flash);

    /* motor 13 */
    M13_Start = (Sys_Auto && Sys_Run && DI[63]) || (Sys_Man && DI[37]);
    M13_Stop = (!DI[13] && Sys_Man) || (DI[51] && Sys_Auto);
    M13_Ovl = DI[43];
    M13_Perm = !Sys_EStop && (DI[62] || !DI[9]);
    M13_Ilk = (M12_Run && DI[63]) || (Sys_Man && DI[60]);
    M13_Fault = (M13_Ovl || (M13_Cmd && !DI[46] && !DI[63]) || M13_Fault) && !Sys_Reset;
    M13_Cmd = (M13_Start || M13_Cmd) && !M13_Stop && M13_Perm && M13_Ilk && !M13_Fault;
    M13_Run = M13_Cmd && (DI[59] || DI[0]);
    M13_Warn = (M13_Cmd && !M13_Run) || (DI[25] && M13_Ovl);
    M13_Lamp = M13_Run || (M13_Fault && Sys_Flash);

    /* motor 14 */
    M14_Start = (Sys_Auto && Sys_Run && DI[39]) || (Sys_Man && DI[43]);
    M14_Stop = (DI[40] && DI[19]) || Sys_EStop;
    M14_Ovl = !DI[59];
    M14_Perm = (DI[24] && !DI[56]) || Sys_Man;
    M14_Ilk = DI[44] || Sys_Man;
    M14_Fault = (M14_Ovl || (M14_Cmd && !DI[49] && !DI[21]) || M14_Fault) && !Sys_Reset;
    M14_Cmd = (M14_Start || M14_Cmd) && !M14_Stop && M14_Perm && M14_Ilk && !M14_Fault;
    M14_Run = M14_Cmd && !DI[30];
    M14_Warn = (M14_Cmd && !M14_Run) || (DI[37] && M14_Ovl);
    M14_Lamp = M14_Run || (M14_Fault && Sys_Flash);

    /* motor 15 */
    M15_Start = (Sys_Auto && Sys_Run && DI[1]) || (Sys_Man && DI[26]);
    M15_Stop = DI[5] || !DI[58] || Sys_EStop;
    M15_Ovl = !DI[61];
    M15_Perm = !Sys_EStop && (DI[2] || !DI[15]);
    M15_Ilk = (M14_Run && DI[28]) || (Sys_Man && DI[32]);
    M15_Fault = (M15_Ovl || (M15_Cmd && !DI[24] && !DI[1]) || M15_Fault) && !Sys_Reset;
    M15_Cmd = (M15_Start || M15_Cmd) && !M15_Stop && M15_Perm && M15_Ilk && !M15_Fault;
    M15_Run = M15_Cmd && (DI[61] || DI[11]);
    M15_Warn = (M15_Cmd && !M15_Run) || (DI[43] && M15_Ovl);
    M15_Lamp = M15_Run || (M15_Fault && Sys_Flash);

    /* motor 16 */
    M16_Start = (Sys_Auto && Sys_Run && DI[56]) || (Sys_Man && DI[15]);
    M16_Stop = (!DI[26] && Sys_Man) || (DI[22] && Sys_Auto);
    M16_Ovl = !DI[15];
    M16_Perm = !Sys_EStop && (DI[55] || !DI[32]);
    M16_Ilk = DI[47] || Sys_Man;
    M16_Fault = (M16_Ovl || (M16_Cmd && !DI[24] && !DI[53]) || M16_Fault) && !Sys_Reset;
    M16_Cmd = (M16_Start || M16_Cmd) && !M16_Stop && M16_Perm && M16_Ilk && !M16_Fault;
    M16_Run = M16_Cmd && (DI[8] || DI[23]);
    M16_Warn = (M16_Cmd && !M16_Run) || (DI[16] && M16_Ovl);
    M16_Lamp = M16_Run || (M16_Fault && Sys_Flash);

    /* motor 17 */
    M17_Start = (Sys_Auto && Sys_Run && DI[43]) || (Sys_Man && DI[32]);
    M17_Stop = DI[27] || !DI[57] || Sys_EStop;
    M17_Ovl = DI[15];
    M17_Perm = !Sys_EStop && (DI[6] || !DI[57]);
    M17_Ilk = (M16_Run && DI[28]) || (Sys_Man && DI[58]);
    M17_Fault = (M17_Ovl || (M17_Cmd && !DI[42] && !DI[18]) || M17_Fault) && !Sys_Reset;
    M17_Cmd = (M17_Start || M17_Cmd) && !M17_Stop && M17_Perm && M17_Ilk && !M17_Fault;
    M17_Run = M17_Cmd && !DI[24];
    M17_Warn = (M17_Cmd && !M17_Run) || (DI[19] && M17_Ovl);
    M17_Lamp = M17_Run || (M17_Fault && Sys_Flash);

    /* motor 18 */
    M18_Start = (Sys_Auto && Sys_Run && DI[16]) || (Sys_Man && DI[50]);
    M18_Stop = (!DI[58] && Sys_Man) || (DI[36] && Sys_Auto);
    M18_Ovl = DI[42];
    M18_Perm = (DI[0] || DI[7]) && !Sys_EStop;
    M18_Ilk = DI[56] || Sys_Man;
    M18_Fault = (M18_Ovl || (M18_Cmd && !DI[3] && !DI[49]) || M18_Fault) && !Sys_Reset;
    M18_Cmd = (M18_Start || M18_Cmd) && !M18_Stop && M18_Perm && M18_Ilk && !M18_Fault;
    M18_Run = M18_Cmd && (DI[55] || DI[4]);
    M18_Warn = (M18_Cmd && !M18_Run) || (DI[0] && M18_Ovl);
    M18_Lamp = M18_Run || (M18_Fault && Sys_Flash);

    /* motor 19 */
    M19_Start = (Sys_Auto && Sys_Run && DI[51]) || (Sys_Man && DI[2]);
    M19_Stop = (!DI[2] && Sys_Man) || (DI[63] && Sys_Auto);
    M19_Ovl = !DI[56];
    M19_Perm = (DI[6] || DI[40]) && !Sys_EStop;
    M19_Ilk = (M18_Run && DI[31]) || (Sys_Man && DI[5]);
    M19_Fault = (M19_Ovl || (M19_Cmd && !DI[16] && !DI[43]) || M19_Fault) && !Sys_Reset;
    M19_Cmd = (M19_Start || M19_Cmd) && !M19_Stop && M19_Perm && M19_Ilk && !M19_Fault;
    M19_Run = M19_Cmd && (DI[25] || DI[59]);
    M19_Warn = (M19_Cmd && !M19_Run) || (DI[7] && M19_Ovl);
    M19_Lamp = M19_Run || (M19_Fault && Sys_Flash);

    /* motor 20 */
    M20_Start = (Sys_Auto && Sys_Run && DI[4]) || (Sys_Man && DI[41]);
    M20_Stop = (DI[54] && DI[11]) || Sys_EStop;
    M20_Ovl = !DI[24];
    M20_Perm = !Sys_EStop && (DI[54] || !DI[15]);
    M20_Ilk = DI[6] || Sys_Man;
    M20_Fault = (M20_Ovl || (M20_Cmd && !DI[53] && !DI[59]) || M20_Fault) && !Sys_Reset;
    M20_Cmd = (M20_Start || M20_Cmd) && !M20_Stop && M20_Perm && M20_Ilk && !M20_Fault;
    M20_Run = M20_Cmd && (DI[3] || DI[46]);
    M20_Warn = (M20_Cmd && !M20_Run) || (DI[54] && M20_Ovl);
    M20_Lamp = M20_Run || (M20_Fault && Sys_Flash);

    /* motor 21 */
    M21_Start = (Sys_Auto && Sys_Run && DI[36]) || (Sys_Man && DI[14]);
    M21_Stop = (!DI[6] && Sys_Man) || (DI[14] && Sys_Auto);
    M21_Ovl = !DI[45];
    M21_Perm = !Sys_EStop && (DI[26] || !DI[20]);
    M21_Ilk = (M20_Run && DI[43]) || (Sys_Man && DI[47]);
    M21_Fault = (M21_Ovl || (M21_Cmd && !DI[15] && !DI[42]) || M21_Fault) && !Sys_Reset;
    M21_Cmd = (M21_Start || M21_Cmd) && !M21_Stop && M21_Perm && M21_Ilk && !M21_Fault;
    M21_Run = M21_Cmd && !DI[52];
    M21_Warn = (M21_Cmd && !M21_Run) || (DI[47] && M21_Ovl);
    M21_Lamp = M21_Run || (M21_Fault && Sys_Flash);

    /* motor 22 */
    M22_Start = (Sys_Auto && Sys_Run && DI[4]) || (Sys_Man && DI[51]);
    M22_Stop = (DI[35] && DI[61]) || Sys_EStop;
    M22_Ovl = DI[24];
    M22_Perm = (DI[2] || DI[44]) && !Sys_EStop;
    M22_Ilk = DI[53] || Sys_Man;
    M22_Fault = (M22_Ovl || (M22_Cmd && !DI[61] && !DI[26]) || M22_Fault) && !Sys_Reset;
    M22_Cmd = (M22_Start || M22_Cmd) && !M22_Stop && M22_Perm && M22_Ilk && !M22_Fault;
    M22_Run = M22_Cmd && (DI[38] || DI[15]);
    M22_Warn = (M22_Cmd && !M22_Run) || (DI[6] && M22_Ovl);
    M22_Lamp = M22_Run || (M22_Fault && Sys_Flash);

    /* motor 23 */
    M23_Start = (Sys_Auto && Sys_Run && DI[26]) || (Sys_Man && DI[4]);
    M23_Stop = (DI[18] && DI[46]) || Sys_EStop;
    M23_Ovl = !DI[31];
    M23_Perm = (DI[46] || DI[11]) && !Sys_EStop;
    M23_Ilk = DI[60] || Sys_Man;
    M23_Fault = (M23_Ovl || (M23_Cmd && !DI[14] && !DI[41]) || M23_Fault) && !Sys_Reset;
    M23_Cmd = (M23_Start || M23_Cmd) && !M23_Stop && M23_Perm && M23_Ilk && !M23_Fault;
    M23_Run = M23_Cmd && (DI[62] || DI[33]);
    M23_Warn = (M23_Cmd && !M23_Run) || (DI[39] && M23_Ovl);
    M23_Lamp = M23_Run || (M23_Fault && Sys_Flash);

    /* motor 24 */
    M24_Start = (Sys_Auto && Sys_Run && DI[41]) || (Sys_Man && DI[63]);
    M24_Stop = (!DI[30] && Sys_Man) || (DI[29] && Sys_Auto);
    M24_Ovl = DI[57];
    M24_Perm = !Sys_EStop && (DI[2] || !DI[39]);
    M24_Ilk = (M23_Run && DI[43]) || (Sys_Man && DI[16]);
    M24_Fault = (M24_Ovl || (M24_Cmd && !DI[18] && !DI[36]) || M24_Fault) && !Sys_Reset;
    M24_Cmd = (M24_Start || M24_Cmd) && !M24_Stop && M24_Perm && M24_Ilk && !M24_Fault;
    M24_Run = M24_Cmd && (DI[57] || DI[1]);
    M24_Warn = (M24_Cmd && !M24_Run) || (DI[52] && M24_Ovl);
    M24_Lamp = M24_Run || (M24_Fault && Sys_Flash);

    /* motor 25 */
    M25_Start = (Sys_Auto && Sys_Run && DI[40]) || (Sys_Man && DI[60]);
    M25_Stop = (DI[59] && DI[43]) || Sys_EStop;
    M25_Ovl = DI[33];
    M25_Perm = (DI[54] || DI[50]) && !Sys_EStop;
    M25_Ilk = (M24_Run && DI[15]) || (Sys_Man && DI[62]);
    M25_Fault = (M25_Ovl || (M25_Cmd && !DI[15] && !DI[19]) || M25_Fault) && !Sys_Reset;
    M25_Cmd = (M25_Start || M25_Cmd) && !M25_Stop && M25_Perm && M25_Ilk && !M25_Fault;
    M25_Run = M25_Cmd && !DI[25];
    M25_Warn = (M25_Cmd && !M25_Run) || (DI[37] && M25_Ovl);
    M25_Lamp = M25_Run || (M25_Fault && Sys_Flash);

    /* motor 26 */
    M26_Start = (Sys_Auto && Sys_Run && DI[35]) || (Sys_Man && DI[16]);
    M26_Stop = DI[55] || !DI[6] || Sys_EStop;
    M26_Ovl = DI[29];
    M26_Perm = (DI[15] && !DI[42]) || Sys_Man;
    M26_Ilk = (M25_Run && DI[0]) || (Sys_Man && DI[23]);
    M26_Fault = (M26_Ovl || (M26_Cmd && !DI[30] && !DI[39]) || M26_Fault) && !Sys_Reset;
    M26_Cmd = (M26_Start || M26_Cmd) && !M26_Stop && M26_Perm && M26_Ilk && !M26_Fault;
    M26_Run = M26_Cmd && !DI[62];
    M26_Warn = (M26_Cmd && !M26_Run) || (DI[9] && M26_Ovl);
    M26_Lamp = M26_Run || (M26_Fault && Sys_Flash);

    /* motor 27 */
    M27_Start = (Sys_Auto && Sys_Run && DI[43]) || (Sys_Man && DI[10]);
    M27_Stop = (!DI[47] && Sys_Man) || (DI[59] && Sys_Auto);
    M27_Ovl = DI[10];
    M27_Perm = !Sys_EStop && (DI[29] || !DI[43]);
    M27_Ilk = (M26_Run && DI[20]) || (Sys_Man && DI[34]);
    M27_Fault = (M27_Ovl || (M27_Cmd && !DI[17] && !DI[54]) || M27_Fault) && !Sys_Reset;
    M27_Cmd = (M27_Start || M27_Cmd) && !M27_Stop && M27_Perm && M27_Ilk && !M27_Fault;
    M27_Run = M27_Cmd && !DI[9];
    M27_Warn = (M27_Cmd && !M27_Run) || (DI[18] && M27_Ovl);
    M27_Lamp = M27_Run || (M27_Fault && Sys_Flash);

    /* motor 28 */
    M28_Start = (Sys_Auto && Sys_Run && DI[62]) || (Sys_Man && DI[40]);
    M28_Stop = (DI[36] && DI[29]) || Sys_EStop;
    M28_Ovl = !DI[13];
    M28_Perm = (DI[7] && !DI[63]) || Sys_Man;
    M28_Ilk = DI[17] || Sys_Man;
    M28_Fault = (M28_Ovl || (M28_Cmd && !DI[6] && !DI[8]) || M28_Fault) && !Sys_Reset;
    M28_Cmd = (M28_Start || M28_Cmd) && !M28_Stop && M28_Perm && M28_Ilk && !M28_Fault;
    M28_Run = M28_Cmd && !DI[40];
    M28_Warn = (M28_Cmd && !M28_Run) || (DI[63] && M28_Ovl);
    M28_Lamp = M28_Run || (M28_Fault && Sys_Flash);

    /* valve 1 */
    V01_Req = ((M10_Run || M16_Run) && Sys_Auto) || (DI[43] && Sys_Man);
    V01_IsOpen = DI[19] && !DI[11];
    V01_IsClosed = DI[13] && !V01_IsOpen;
    V01_OpenCmd = V01_Req && !V01_IsOpen && !V01_Fault && !Sys_EStop;
    V01_CloseCmd = (!V01_Req || Sys_EStop) && !V01_IsClosed && !V01_OpenCmd;
    V01_Fault = ((V01_IsOpen && V01_CloseCmd && DI[13]) || (V01_IsClosed && V01_OpenCmd && DI[20]) || V01_Fault) && !Sys_Reset;

    /* valve 2 */
    V02_Req = ((M01_Run || M12_Run) && Sys_Auto) || (DI[10] && Sys_Man);
    V02_IsOpen = DI[15] && !DI[12];
    V02_IsClosed = DI[36] && !V02_IsOpen;
    V02_OpenCmd = V02_Req && !V02_IsOpen && !V02_Fault && !Sys_EStop;
    V02_CloseCmd = (!V02_Req || Sys_EStop) && !V02_IsClosed && !V02_OpenCmd;
    V02_Fault = ((V02_IsOpen && V02_CloseCmd && DI[14]) || (V02_IsClosed && V02_OpenCmd && DI[6]) || V02_Fault) && !Sys_Reset;

    /* valve 3 */
    V03_Req = ((M20_Run || M25_Run) && Sys_Auto) || (DI[52] && Sys_Man);
    V03_IsOpen = DI[42] && !DI[22];
    V03_IsClosed = DI[15] && !V03_IsOpen;
    V03_OpenCmd = V03_Req && !V03_IsOpen && !V03_Fault && !Sys_EStop;
    V03_CloseCmd = (!V03_Req || Sys_EStop) && !V03_IsClosed && !V03_OpenCmd;
    V03_Fault = ((V03_IsOpen && V03_CloseCmd && DI[63]) || (V03_IsClosed && V03_OpenCmd && DI[21]) || V03_Fault) && !Sys_Reset;

    /* valve 4 */
    V04_Req = ((M01_Run || M11_Run) && Sys_Auto) || (DI[2] && Sys_Man);
    V04_IsOpen = DI[45] && !DI[59];
    V04_IsClosed = DI[23] && !V04_IsOpen;
    V04_OpenCmd = V04_Req && !V04_IsOpen && !V04_Fault && !Sys_EStop;
    V04_CloseCmd = (!V04_Req || Sys_EStop) && !V04_IsClosed && !V04_OpenCmd;
    V04_Fault = ((V04_IsOpen && V04_CloseCmd && DI[11]) || (V04_IsClosed && V04_OpenCmd && DI[54]) || V04_Fault) && !Sys_Reset;

    /* valve 5 */
    V05_Req = ((M19_Run || M21_Run) && Sys_Auto) || (DI[2] && Sys_Man);
    V05_IsOpen = DI[22] && !DI[28];
    V05_IsClosed = DI[58] && !V05_IsOpen;
    V05_OpenCmd = V05_Req && !V05_IsOpen && !V05_Fault && !Sys_EStop;
    V05_CloseCmd = (!V05_Req || Sys_EStop) && !V05_IsClosed && !V05_OpenCmd;
    V05_Fault = ((V05_IsOpen && V05_CloseCmd && DI[3]) || (V05_IsClosed && V05_OpenCmd && DI[45]) || V05_Fault) && !Sys_Reset;

    /* valve 6 */
    V06_Req = ((M14_Run || M20_Run) && Sys_Auto) || (DI[2] && Sys_Man);
    V06_IsOpen = DI[19] && !DI[41];
    V06_IsClosed = DI[47] && !V06_IsOpen;
    V06_OpenCmd = V06_Req && !V06_IsOpen && !V06_Fault && !Sys_EStop;
    V06_CloseCmd = (!V06_Req || Sys_EStop) && !V06_IsClosed && !V06_OpenCmd;
    V06_Fault = ((V06_IsOpen && V06_CloseCmd && DI[13]) || (V06_IsClosed && V06_OpenCmd && DI[0]) || V06_Fault) && !Sys_Reset;

    /* valve 7 */
    V07_Req = ((M01_Run || M18_Run) && Sys_Auto) || (DI[22] && Sys_Man);
    V07_IsOpen = DI[16] && !DI[17];
    V07_IsClosed = DI[2] && !V07_IsOpen;
    V07_OpenCmd = V07_Req && !V07_IsOpen && !V07_Fault && !Sys_EStop;
    V07_CloseCmd = (!V07_Req || Sys_EStop) && !V07_IsClosed && !V07_OpenCmd;
    V07_Fault = ((V07_IsOpen && V07_CloseCmd && DI[25]) || (V07_IsClosed && V07_OpenCmd && DI[37]) || V07_Fault) && !Sys_Reset;

    /* valve 8 */
    V08_Req = ((M24_Run || M09_Run) && Sys_Auto) || (DI[48] && Sys_Man);
    V08_IsOpen = DI[34] && !DI[12];
    V08_IsClosed = DI[36] && !V08_IsOpen;
    V08_OpenCmd = V08_Req && !V08_IsOpen && !V08_Fault && !Sys_EStop;
    V08_CloseCmd = (!V08_Req || Sys_EStop) && !V08_IsClosed && !V08_OpenCmd;
    V08_Fault = ((V08_IsOpen && V08_CloseCmd && DI[38]) || (V08_IsClosed && V08_OpenCmd && DI[32]) || V08_Fault) && !Sys_Reset;

    /* valve 9 */
    V09_Req = ((M15_Run || M02_Run) && Sys_Auto) || (DI[30] && Sys_Man);
    V09_IsOpen = DI[1] && !DI[20];
    V09_IsClosed = DI[46] && !V09_IsOpen;
    V09_OpenCmd = V09_Req && !V09_IsOpen && !V09_Fault && !Sys_EStop;
    V09_CloseCmd = (!V09_Req || Sys_EStop) && !V09_IsClosed && !V09_OpenCmd;
    V09_Fault = ((V09_IsOpen && V09_CloseCmd && DI[47]) || (V09_IsClosed && V09_OpenCmd && DI[29]) || V09_Fault) && !Sys_Reset;

    /* valve 10 */
    V10_Req = ((M28_Run || M17_Run) && Sys_Auto) || (DI[41] && Sys_Man);
    V10_IsOpen = DI[29] && !DI[43];
    V10_IsClosed = DI[63] && !V10_IsOpen;
    V10_OpenCmd = V10_Req && !V10_IsOpen && !V10_Fault && !Sys_EStop;
    V10_CloseCmd = (!V10_Req || Sys_EStop) && !V10_IsClosed && !V10_OpenCmd;
    V10_Fault = ((V10_IsOpen && V10_CloseCmd && DI[12]) || (V10_IsClosed && V10_OpenCmd && DI[52]) || V10_Fault) && !Sys_Reset;

    /* valve 11 */
    V11_Req = ((M03_Run || M15_Run) && Sys_Auto) || (DI[8] && Sys_Man);
    V11_IsOpen = DI[16] && !DI[10];
    V11_IsClosed = DI[22] && !V11_IsOpen;
    V11_OpenCmd = V11_Req && !V11_IsOpen && !V11_Fault && !Sys_EStop;
    V11_CloseCmd = (!V11_Req || Sys_EStop) && !V11_IsClosed && !V11_OpenCmd;
    V11_Fault = ((V11_IsOpen && V11_CloseCmd && DI[46]) || (V11_IsClosed && V11_OpenCmd && DI[40]) || V11_Fault) && !Sys_Reset;

    /* valve 12 */
    V12_Req = ((M10_Run || M07_Run) && Sys_Auto) || (DI[34] && Sys_Man);
    V12_IsOpen = DI[8] && !DI[5];
    V12_IsClosed = DI[30] && !V12_IsOpen;
    V12_OpenCmd = V12_Req && !V12_IsOpen && !V12_Fault && !Sys_EStop;
    V12_CloseCmd = (!V12_Req || Sys_EStop) && !V12_IsClosed && !V12_OpenCmd;
    V12_Fault = ((V12_IsOpen && V12_CloseCmd && DI[2]) || (V12_IsClosed && V12_OpenCmd && DI[37]) || V12_Fault) && !Sys_Reset;

    /* valve 13 */
    V13_Req = ((M20_Run || M01_Run) && Sys_Auto) || (DI[21] && Sys_Man);
    V13_IsOpen = DI[62] && !DI[16];
    V13_IsClosed = DI[57] && !V13_IsOpen;
    V13_OpenCmd = V13_Req && !V13_IsOpen && !V13_Fault && !Sys_EStop;
    V13_CloseCmd = (!V13_Req || Sys_EStop) && !V13_IsClosed && !V13_OpenCmd;
    V13_Fault = ((V13_IsOpen && V13_CloseCmd && DI[51]) || (V13_IsClosed && V13_OpenCmd && DI[21]) || V13_Fault) && !Sys_Reset;

    /* valve 14 */
    V14_Req = ((M11_Run || M04_Run) && Sys_Auto) || (DI[37] && Sys_Man);
    V14_IsOpen = DI[37] && !DI[60];
    V14_IsClosed = DI[51] && !V14_IsOpen;
    V14_OpenCmd = V14_Req && !V14_IsOpen && !V14_Fault && !Sys_EStop;
    V14_CloseCmd = (!V14_Req || Sys_EStop) && !V14_IsClosed && !V14_OpenCmd;
    V14_Fault = ((V14_IsOpen && V14_CloseCmd && DI[17]) || (V14_IsClosed && V14_OpenCmd && DI[31]) || V14_Fault) && !Sys_Reset;

    /* valve 15 */
    V15_Req = ((M26_Run || M20_Run) && Sys_Auto) || (DI[60] && Sys_Man);
    V15_IsOpen = DI[22] && !DI[57];
    V15_IsClosed = DI[52] && !V15_IsOpen;
    V15_OpenCmd = V15_Req && !V15_IsOpen && !V15_Fault && !Sys_EStop;
    V15_CloseCmd = (!V15_Req || Sys_EStop) && !V15_IsClosed && !V15_OpenCmd;
    V15_Fault = ((V15_IsOpen && V15_CloseCmd && DI[44]) || (V15_IsClosed && V15_OpenCmd && DI[43]) || V15_Fault) && !Sys_Reset;

    /* valve 16 */
    V16_Req = ((M28_Run || M14_Run) && Sys_Auto) || (DI[42] && Sys_Man);
    V16_IsOpen = DI[20] && !DI[6];
    V16_IsClosed = DI[18] && !V16_IsOpen;
    V16_OpenCmd = V16_Req && !V16_IsOpen && !V16_Fault && !Sys_EStop;
    V16_CloseCmd = (!V16_Req || Sys_EStop) && !V16_IsClosed && !V16_OpenCmd;
    V16_Fault = ((V16_IsOpen && V16_CloseCmd && DI[56]) || (V16_IsClosed && V16_OpenCmd && DI[11]) || V16_Fault) && !Sys_Reset;

    /* step chain */
    S00 = (S00 || (S11 && DI[34]) || !(S01 || S02 || S03 || S04 || S05 || S06 || S07 || S08 || S09 || S10 || S11)) && !S01;
    S01 = ((S00 && DI[31] && M08_Run) || S01) && !S02 && !Sys_EStop;
    S02 = ((S01 && DI[43] && V02_IsOpen) || S02) && !S03 && !Sys_EStop;
    S03 = ((S02 && DI[23] && V10_IsOpen) || S03) && !S04 && !Sys_EStop;
    S04 = ((S03 && DI[29] && V13_IsOpen) || S04) && !S05 && !Sys_EStop;
    S05 = ((S04 && DI[36] && M08_Run) || S05) && !S06 && !Sys_EStop;
    S06 = ((S05 && DI[40] && V10_IsOpen) || S06) && !S07 && !Sys_EStop;
    S07 = ((S06 && DI[5] && M10_Run) || S07) && !S08 && !Sys_EStop;
    S08 = ((S07 && DI[46] && M07_Run) || S08) && !S09 && !Sys_EStop;
    S09 = ((S08 && DI[16] && V09_IsOpen) || S09) && !S10 && !Sys_EStop;
    S10 = ((S09 && DI[60] && M22_Run) || S10) && !S11 && !Sys_EStop;
    S11 = ((S10 && DI[0] && V16_IsOpen) || S11) && !S00 && !Sys_EStop;

    /* two out of three and alarms */
    A01_Trip = (DI[21] && DI[13]) || (DI[13] && DI[36]) || (DI[21] && DI[36]);
    A01_New = A01_Trip && !A01_Act;
    A01_Act = A01_Trip || (A01_Act && !A01_Ack);
    A01_Ack = ((A01_Ack || Sys_Reset) && A01_Act) != (DI[1] && A01_New);
    A02_Trip = (DI[13] && DI[33]) || (DI[33] && DI[31]) || (DI[13] && DI[31]);
    A02_New = A02_Trip && !A02_Act;
    A02_Act = A02_Trip || (A02_Act && !A02_Ack);
    A02_Ack = ((A02_Ack || Sys_Reset) && A02_Act) != (DI[1] && A02_New);
    A03_Trip = (DI[29] && DI[5]) || (DI[5] && DI[9]) || (DI[29] && DI[9]);
    A03_New = A03_Trip && !A03_Act;
    A03_Act = A03_Trip || (A03_Act && !A03_Ack);
    A03_Ack = ((A03_Ack || Sys_Reset) && A03_Act) != (DI[55] && A03_New);
    A04_Trip = (DI[20] && DI[62]) || (DI[62] && DI[24]) || (DI[20] && DI[24]);
    A04_New = A04_Trip && !A04_Act;
    A04_Act = A04_Trip || (A04_Act && !A04_Ack);
    A04_Ack = ((A04_Ack || Sys_Reset) && A04_Act) != (DI[15] && A04_New);
    A05_Trip = (DI[40] && DI[52]) || (DI[52] && DI[61]) || (DI[40] && DI[61]);
    A05_New = A05_Trip && !A05_Act;
    A05_Act = A05_Trip || (A05_Act && !A05_Ack);
    A05_Ack = ((A05_Ack || Sys_Reset) && A05_Act) != (DI[43] && A05_New);
    A06_Trip = (DI[13] && DI[36]) || (DI[36] && DI[22]) || (DI[13] && DI[22]);
    A06_New = A06_Trip && !A06_Act;
    A06_Act = A06_Trip || (A06_Act && !A06_Ack);
    A06_Ack = ((A06_Ack || Sys_Reset) && A06_Act) != (DI[53] && A06_New);
    A07_Trip = (DI[25] && DI[48]) || (DI[48] && DI[61]) || (DI[25] && DI[61]);
    A07_New = A07_Trip && !A07_Act;
    A07_Act = A07_Trip || (A07_Act && !A07_Ack);
    A07_Ack = ((A07_Ack || Sys_Reset) && A07_Act) != (DI[63] && A07_New);
    A08_Trip = (DI[14] && DI[7]) || (DI[7] && DI[41]) || (DI[14] && DI[41]);
    A08_New = A08_Trip && !A08_Act;
    A08_Act = A08_Trip || (A08_Act && !A08_Ack);
    A08_Ack = ((A08_Ack || Sys_Reset) && A08_Act) != (DI[56] && A08_New);
    A09_Trip = (DI[58] && DI[41]) || (DI[41] && DI[1]) || (DI[58] && DI[1]);
    A09_New = A09_Trip && !A09_Act;
    A09_Act = A09_Trip || (A09_Act && !A09_Ack);
    A09_Ack = ((A09_Ack || Sys_Reset) && A09_Act) != (DI[12] && A09_New);
    A10_Trip = (DI[45] && DI[53]) || (DI[53] && DI[45]) || (DI[45] && DI[45]);
    A10_New = A10_Trip && !A10_Act;
    A10_Act = A10_Trip || (A10_Act && !A10_Ack);
    A10_Ack = ((A10_Ack || Sys_Reset) && A10_Act) != (DI[40] && A10_New);
    A11_Trip = (DI[10] && DI[25]) || (DI[25] && DI[5]) || (DI[10] && DI[5]);
    A11_New = A11_Trip && !A11_Act;
    A11_Act = A11_Trip || (A11_Act && !A11_Ack);
    A11_Ack = ((A11_Ack || Sys_Reset) && A11_Act) != (DI[43] && A11_New);
    A12_Trip = (DI[53] && DI[22]) || (DI[22] && DI[36]) || (DI[53] && DI[36]);
    A12_New = A12_Trip && !A12_Act;
    A12_Act = A12_Trip || (A12_Act && !A12_Ack);
    A12_Ack = ((A12_Ack || Sys_Reset) && A12_Act) != (DI[1] && A12_New);

    /* groups */
    Grp0 = M01_Fault || M02_Fault || M03_Fault || M04_Fault || M05_Fault || M06_Fault || M07_Fault || M08_Fault;
    Grp1 = M09_Fault || M10_Fault || M11_Fault || M12_Fault || M13_Fault || M14_Fault || M15_Fault || M16_Fault;
    Grp2 = M17_Fault || M18_Fault || M19_Fault || M20_Fault || M21_Fault || M22_Fault || M23_Fault || M24_Fault;
    Grp3 = M25_Fault || M26_Fault || M27_Fault || M28_Fault || V01_Fault || V02_Fault || V03_Fault || V04_Fault;
    Grp4 = V05_Fault || V06_Fault || V07_Fault || V08_Fault || V09_Fault || V10_Fault || V11_Fault || V12_Fault;
    Grp5 = V13_Fault || V14_Fault || V15_Fault || V16_Fault || A01_Act || A02_Act || A03_Act || A04_Act;
    Grp6 = A05_Act || A06_Act || A07_Act || A08_Act || A09_Act || A10_Act || A11_Act || A12_Act;
    Sys_AnyFault = (Grp0 && Grp1 && Grp2) || (Sys_EStop && Grp3);
    Sys_Horn = A01_New || A02_New || A03_New || A04_New || A05_New || A06_New || A07_New || A08_New || A09_New || A10_New || A11_New || A12_New;

    n = 0;
    if (Sys_Auto) n += 1;
    if (Sys_Man) n += 38;
    if (Sys_EStop) n += 75;
    if (Sys_Reset) n += 11;
    if (Sys_Run) n += 48;
    if (Sys_Flash) n += 85;
    if (Sys_Horn) n += 21;
    if (Sys_AnyFault) n += 58;
    if (M01_Cmd) n += 95;
    if (M01_Warn) n += 31;
    if (M01_Lamp) n += 68;
    if (M02_Cmd) n += 4;
    if (M02_Warn) n += 41;
    if (M02_Lamp) n += 78;
    if (M03_Cmd) n += 14;
    if (M03_Warn) n += 51;
    if (M03_Lamp) n += 88;
    if (M04_Cmd) n += 24;
    if (M04_Warn) n += 61;
    if (M04_Lamp) n += 98;
    if (M05_Cmd) n += 34;
    if (M05_Warn) n += 71;
    if (M05_Lamp) n += 7;
    if (M06_Cmd) n += 44;
    if (M06_Warn) n += 81;
    if (M06_Lamp) n += 17;
    if (M07_Cmd) n += 54;
    if (M07_Warn) n += 91;
    if (M07_Lamp) n += 27;
    if (M08_Cmd) n += 64;
    if (M08_Warn) n += 101;
    if (M08_Lamp) n += 37;
    if (M09_Cmd) n += 74;
    if (M09_Warn) n += 10;
    if (M09_Lamp) n += 47;
    if (M10_Cmd) n += 84;
    if (M10_Warn) n += 20;
    if (M10_Lamp) n += 57;
    if (M11_Cmd) n += 94;
    if (M11_Warn) n += 30;
    if (M11_Lamp) n += 67;
    if (M12_Cmd) n += 3;
    if (M12_Warn) n += 40;
    if (M12_Lamp) n += 77;
    if (M13_Cmd) n += 13;
    if (M13_Warn) n += 50;
    if (M13_Lamp) n += 87;
    if (M14_Cmd) n += 23;
    if (M14_Warn) n += 60;
    if (M14_Lamp) n += 97;
    if (M15_Cmd) n += 33;
    if (M15_Warn) n += 70;
    if (M15_Lamp) n += 6;
    if (M16_Cmd) n += 43;
    if (M16_Warn) n += 80;
    if (M16_Lamp) n += 16;
    if (M17_Cmd) n += 53;
    if (M17_Warn) n += 90;
    if (M17_Lamp) n += 26;
    if (M18_Cmd) n += 63;
    if (M18_Warn) n += 100;
    if (M18_Lamp) n += 36;
    if (M19_Cmd) n += 73;
    if (M19_Warn) n += 9;
    if (M19_Lamp) n += 46;
    if (M20_Cmd) n += 83;
    if (M20_Warn) n += 19;
    if (M20_Lamp) n += 56;
    if (M21_Cmd) n += 93;
    if (M21_Warn) n += 29;
    if (M21_Lamp) n += 66;
    if (M22_Cmd) n += 2;
    if (M22_Warn) n += 39;
    if (M22_Lamp) n += 76;
    if (M23_Cmd) n += 12;
    if (M23_Warn) n += 49;
    if (M23_Lamp) n += 86;
    if (M24_Cmd) n += 22;
    if (M24_Warn) n += 59;
    if (M24_Lamp) n += 96;
    if (M25_Cmd) n += 32;
    if (M25_Warn) n += 69;
    if (M25_Lamp) n += 5;
    if (M26_Cmd) n += 42;
    if (M26_Warn) n += 79;
    if (M26_Lamp) n += 15;
    if (M27_Cmd) n += 52;
    if (M27_Warn) n += 89;
    if (M27_Lamp) n += 25;
    if (M28_Cmd) n += 62;
    if (M28_Warn) n += 99;
    if (M28_Lamp) n += 35;
    if (V01_OpenCmd) n += 72;
    if (V01_CloseCmd) n += 8;
    if (V02_OpenCmd) n += 45;
    if (V02_CloseCmd) n += 82;
    if (V03_OpenCmd) n += 18;
    if (V03_CloseCmd) n += 55;
    if (V04_OpenCmd) n += 92;
    if (V04_CloseCmd) n += 28;
    if (V05_OpenCmd) n += 65;
    if (V05_CloseCmd) n += 1;
    if (V06_OpenCmd) n += 38;
    if (V06_CloseCmd) n += 75;
    if (V07_OpenCmd) n += 11;
    if (V07_CloseCmd) n += 48;
    if (V08_OpenCmd) n += 85;
    if (V08_CloseCmd) n += 21;
    if (V09_OpenCmd) n += 58;
    if (V09_CloseCmd) n += 95;
    if (V10_OpenCmd) n += 31;
    if (V10_CloseCmd) n += 68;
    if (V11_OpenCmd) n += 4;
    if (V11_CloseCmd) n += 41;
    if (V12_OpenCmd) n += 78;
    if (V12_CloseCmd) n += 14;
    if (V13_OpenCmd) n += 51;
    if (V13_CloseCmd) n += 88;
    if (V14_OpenCmd) n += 24;
    if (V14_CloseCmd) n += 61;
    if (V15_OpenCmd) n += 98;
    if (V15_CloseCmd) n += 34;
    if (V16_OpenCmd) n += 71;
    if (V16_CloseCmd) n += 7;
    if (S00) n += 44;
    if (S01) n += 81;
    if (S02) n += 17;
    if (S03) n += 54;
    if (S04) n += 91;
    if (S05) n += 27;
    if (S06) n += 64;
    if (S07) n += 101;
    if (S08) n += 37;
    if (S09) n += 74;
    if (S10) n += 10;
    if (S11) n += 47;
    if (A01_Ack) n += 84;
    if (A02_Ack) n += 20;
    if (A03_Ack) n += 57;
    if (A04_Ack) n += 94;
    if (A05_Ack) n += 30;
    if (A06_Ack) n += 67;
    if (A07_Ack) n += 3;
    if (A08_Ack) n += 40;
    if (A09_Ack) n += 77;
    if (A10_Ack) n += 13;
    if (A11_Ack) n += 50;
    if (A12_Ack) n += 87;
    if (Grp0) n += 23;
    if (Grp1) n += 60;
    if (Grp2) n += 97;
    if (Grp3) n += 33;
    if (Grp4) n += 70;
    if (Grp5) n += 6;
    if (Grp6) n += 43;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
