/* Boolean networks: 80 stations of five rungs (400 rungs) on 64 inputs; one input toggles per scan. */
#include "st.h"
#include <stdbool.h>

static int32_t seed = 1;
static int32_t scans;
static uint32_t w0, w1;
static bool
    I00, I01, I02, I03, I04, I05, I06, I07,
    I08, I09, I10, I11, I12, I13, I14, I15,
    I16, I17, I18, I19, I20, I21, I22, I23,
    I24, I25, I26, I27, I28, I29, I30, I31,
    I32, I33, I34, I35, I36, I37, I38, I39,
    I40, I41, I42, I43, I44, I45, I46, I47,
    I48, I49, I50, I51, I52, I53, I54, I55,
    I56, I57, I58, I59, I60, I61, I62, I63;
static bool
    Enable, Reset, Bypass, Auto, Flash;
static bool
    Run00, Jam00, Trip00, Ready00, Lamp00, Cmd01, Open01, Shut01,
    Disc01, Lamp01, Level02, Odd02, Dem02, Mot02, Lamp02, Edge03,
    Old03, Tog03, Safe03, Lamp03, Run04, Jam04, Trip04, Ready04,
    Lamp04, Cmd05, Open05, Shut05, Disc05, Lamp05, Level06, Odd06,
    Dem06, Mot06, Lamp06, Edge07, Old07, Tog07, Safe07, Lamp07,
    Run08, Jam08, Trip08, Ready08, Lamp08, Cmd09, Open09, Shut09,
    Disc09, Lamp09, Level10, Odd10, Dem10, Mot10, Lamp10, Edge11,
    Old11, Tog11, Safe11, Lamp11, Run12, Jam12, Trip12, Ready12,
    Lamp12, Cmd13, Open13, Shut13, Disc13, Lamp13, Level14, Odd14,
    Dem14, Mot14, Lamp14, Edge15, Old15, Tog15, Safe15, Lamp15,
    Run16, Jam16, Trip16, Ready16, Lamp16, Cmd17, Open17, Shut17,
    Disc17, Lamp17, Level18, Odd18, Dem18, Mot18, Lamp18, Edge19,
    Old19, Tog19, Safe19, Lamp19, Run20, Jam20, Trip20, Ready20,
    Lamp20, Cmd21, Open21, Shut21, Disc21, Lamp21, Level22, Odd22,
    Dem22, Mot22, Lamp22, Edge23, Old23, Tog23, Safe23, Lamp23,
    Run24, Jam24, Trip24, Ready24, Lamp24, Cmd25, Open25, Shut25,
    Disc25, Lamp25, Level26, Odd26, Dem26, Mot26, Lamp26, Edge27,
    Old27, Tog27, Safe27, Lamp27, Run28, Jam28, Trip28, Ready28,
    Lamp28, Cmd29, Open29, Shut29, Disc29, Lamp29, Level30, Odd30,
    Dem30, Mot30, Lamp30, Edge31, Old31, Tog31, Safe31, Lamp31,
    Run32, Jam32, Trip32, Ready32, Lamp32, Cmd33, Open33, Shut33,
    Disc33, Lamp33, Level34, Odd34, Dem34, Mot34, Lamp34, Edge35,
    Old35, Tog35, Safe35, Lamp35, Run36, Jam36, Trip36, Ready36,
    Lamp36, Cmd37, Open37, Shut37, Disc37, Lamp37, Level38, Odd38,
    Dem38, Mot38, Lamp38, Edge39, Old39, Tog39, Safe39, Lamp39,
    Run40, Jam40, Trip40, Ready40, Lamp40, Cmd41, Open41, Shut41,
    Disc41, Lamp41, Level42, Odd42, Dem42, Mot42, Lamp42, Edge43,
    Old43, Tog43, Safe43, Lamp43, Run44, Jam44, Trip44, Ready44,
    Lamp44, Cmd45, Open45, Shut45, Disc45, Lamp45, Level46, Odd46,
    Dem46, Mot46, Lamp46, Edge47, Old47, Tog47, Safe47, Lamp47,
    Run48, Jam48, Trip48, Ready48, Lamp48, Cmd49, Open49, Shut49,
    Disc49, Lamp49, Level50, Odd50, Dem50, Mot50, Lamp50, Edge51,
    Old51, Tog51, Safe51, Lamp51, Run52, Jam52, Trip52, Ready52,
    Lamp52, Cmd53, Open53, Shut53, Disc53, Lamp53, Level54, Odd54,
    Dem54, Mot54, Lamp54, Edge55, Old55, Tog55, Safe55, Lamp55,
    Run56, Jam56, Trip56, Ready56, Lamp56, Cmd57, Open57, Shut57,
    Disc57, Lamp57, Level58, Odd58, Dem58, Mot58, Lamp58, Edge59,
    Old59, Tog59, Safe59, Lamp59, Run60, Jam60, Trip60, Ready60,
    Lamp60, Cmd61, Open61, Shut61, Disc61, Lamp61, Level62, Odd62,
    Dem62, Mot62, Lamp62, Edge63, Old63, Tog63, Safe63, Lamp63,
    Run64, Jam64, Trip64, Ready64, Lamp64, Cmd65, Open65, Shut65,
    Disc65, Lamp65, Level66, Odd66, Dem66, Mot66, Lamp66, Edge67,
    Old67, Tog67, Safe67, Lamp67, Run68, Jam68, Trip68, Ready68,
    Lamp68, Cmd69, Open69, Shut69, Disc69, Lamp69, Level70, Odd70,
    Dem70, Mot70, Lamp70, Edge71, Old71, Tog71, Safe71, Lamp71,
    Run72, Jam72, Trip72, Ready72, Lamp72, Cmd73, Open73, Shut73,
    Disc73, Lamp73, Level74, Odd74, Dem74, Mot74, Lamp74, Edge75,
    Old75, Tog75, Safe75, Lamp75, Run76, Jam76, Trip76, Ready76,
    Lamp76, Cmd77, Open77, Shut77, Disc77, Lamp77, Level78, Odd78,
    Dem78, Mot78, Lamp78, Edge79, Old79, Tog79, Safe79, Lamp79;

void scan(void)
{
    int32_t lamps = 0, sum = 0;

    /* one input changes */
    seed = (seed * 75 + 74) % 65537;
    int32_t bit = seed % 64;
    if (bit < 32)
        w0 ^= 1u << bit;
    else
        w1 ^= 1u << (bit - 32);
    scans = (scans + 1) % 20;

    /* input image */
    I00 = (w0 >> 0) & 1;
    I01 = (w0 >> 1) & 1;
    I02 = (w0 >> 2) & 1;
    I03 = (w0 >> 3) & 1;
    I04 = (w0 >> 4) & 1;
    I05 = (w0 >> 5) & 1;
    I06 = (w0 >> 6) & 1;
    I07 = (w0 >> 7) & 1;
    I08 = (w0 >> 8) & 1;
    I09 = (w0 >> 9) & 1;
    I10 = (w0 >> 10) & 1;
    I11 = (w0 >> 11) & 1;
    I12 = (w0 >> 12) & 1;
    I13 = (w0 >> 13) & 1;
    I14 = (w0 >> 14) & 1;
    I15 = (w0 >> 15) & 1;
    I16 = (w0 >> 16) & 1;
    I17 = (w0 >> 17) & 1;
    I18 = (w0 >> 18) & 1;
    I19 = (w0 >> 19) & 1;
    I20 = (w0 >> 20) & 1;
    I21 = (w0 >> 21) & 1;
    I22 = (w0 >> 22) & 1;
    I23 = (w0 >> 23) & 1;
    I24 = (w0 >> 24) & 1;
    I25 = (w0 >> 25) & 1;
    I26 = (w0 >> 26) & 1;
    I27 = (w0 >> 27) & 1;
    I28 = (w0 >> 28) & 1;
    I29 = (w0 >> 29) & 1;
    I30 = (w0 >> 30) & 1;
    I31 = (w0 >> 31) & 1;
    I32 = (w1 >> 0) & 1;
    I33 = (w1 >> 1) & 1;
    I34 = (w1 >> 2) & 1;
    I35 = (w1 >> 3) & 1;
    I36 = (w1 >> 4) & 1;
    I37 = (w1 >> 5) & 1;
    I38 = (w1 >> 6) & 1;
    I39 = (w1 >> 7) & 1;
    I40 = (w1 >> 8) & 1;
    I41 = (w1 >> 9) & 1;
    I42 = (w1 >> 10) & 1;
    I43 = (w1 >> 11) & 1;
    I44 = (w1 >> 12) & 1;
    I45 = (w1 >> 13) & 1;
    I46 = (w1 >> 14) & 1;
    I47 = (w1 >> 15) & 1;
    I48 = (w1 >> 16) & 1;
    I49 = (w1 >> 17) & 1;
    I50 = (w1 >> 18) & 1;
    I51 = (w1 >> 19) & 1;
    I52 = (w1 >> 20) & 1;
    I53 = (w1 >> 21) & 1;
    I54 = (w1 >> 22) & 1;
    I55 = (w1 >> 23) & 1;
    I56 = (w1 >> 24) & 1;
    I57 = (w1 >> 25) & 1;
    I58 = (w1 >> 26) & 1;
    I59 = (w1 >> 27) & 1;
    I60 = (w1 >> 28) & 1;
    I61 = (w1 >> 29) & 1;
    I62 = (w1 >> 30) & 1;
    I63 = (w1 >> 31) & 1;

    Enable = I00 || !I01;
    Reset = I02 && I01;
    Bypass = I00 && I03;
    Auto = I03 || I02;
    Flash = scans < 10;

    /* station 00: Conv */
    Run00 = (I44 || Run00) && !I35 && !Trip00 && Enable;
    Jam00 = Run00 && I34 && !I25;
    Trip00 = (Trip00 || (Jam00 && I56)) && !Reset;
    Ready00 = (Run00 && !Jam00) || Bypass;
    Lamp00 = (Trip00 && Flash) || (Ready00 && !Flash);
    if (Lamp00) lamps++;
    if (Trip00) sum += 1;

    /* station 01: Valve */
    Cmd01 = (Auto && Ready00 && !I38) || (!Auto && (I05 || (Cmd01 && !I13)));
    Open01 = I49 && !I46;
    Shut01 = I46 && !I49;
    Disc01 = (Cmd01 && !Open01) || (!Cmd01 && !Shut01);
    Lamp01 = (Lamp01 || (Disc01 && !Bypass)) && !Reset;
    if (Lamp01) lamps++;
    if (Disc01) sum += 2;

    /* station 02: Pump */
    Level02 = (I46 && I54) || (I54 && I53) || (I46 && I53);
    Odd02 = (I46 != I54) || (I54 != I53);
    Dem02 = (Dem02 || Level02) && !I62;
    Mot02 = Dem02 && !I15 && !Lamp02 && Enable;
    Lamp02 = ((I15 && Dem02) || Lamp02 || (Odd02 && Flash)) && !Reset;
    if (Lamp02) lamps++;
    if (Mot02) sum += 3;

    /* station 03: Door */
    Edge03 = I15 && !Old03;
    Old03 = I15;
    Tog03 = Tog03 != Edge03;
    Safe03 = I13 && I29 && !Tog03;
    Lamp03 = (Safe03 && Ready00) || (I32 && Tog03);
    if (Lamp03) lamps++;
    if (Safe03) sum += 4;

    /* station 04: Conv */
    Run04 = (I53 || Run04) && !I38 && !Trip04 && Ready00;
    Jam04 = Run04 && I60 && !I62;
    Trip04 = (Trip04 || (Jam04 && I18)) && !Reset;
    Ready04 = (Run04 && !Jam04) || Bypass;
    Lamp04 = (Trip04 && Flash) || (Ready04 && !Flash);
    if (Lamp04) lamps++;
    if (Trip04) sum += 5;

    /* station 05: Valve */
    Cmd05 = (Auto && Ready04 && !I39) || (!Auto && (I62 || (Cmd05 && !I50)));
    Open05 = I41 && !I59;
    Shut05 = I59 && !I41;
    Disc05 = (Cmd05 && !Open05) || (!Cmd05 && !Shut05);
    Lamp05 = (Lamp05 || (Disc05 && !Bypass)) && !Reset;
    if (Lamp05) lamps++;
    if (Disc05) sum += 6;

    /* station 06: Pump */
    Level06 = (I59 && I20) || (I20 && I07) || (I59 && I07);
    Odd06 = (I59 != I20) || (I20 != I07);
    Dem06 = (Dem06 || Level06) && !I50;
    Mot06 = Dem06 && !I25 && !Lamp06 && Enable;
    Lamp06 = ((I25 && Dem06) || Lamp06 || (Odd06 && Flash)) && !Reset;
    if (Lamp06) lamps++;
    if (Mot06) sum += 7;

    /* station 07: Door */
    Edge07 = I19 && !Old07;
    Old07 = I19;
    Tog07 = Tog07 != Edge07;
    Safe07 = I62 && I59 && !Tog07;
    Lamp07 = (Safe07 && Ready04) || (I40 && Tog07);
    if (Lamp07) lamps++;
    if (Safe07) sum += 8;

    /* station 08: Conv */
    Run08 = (I34 || Run08) && !I23 && !Trip08 && Ready04;
    Jam08 = Run08 && I18 && !I40;
    Trip08 = (Trip08 || (Jam08 && I61)) && !Reset;
    Ready08 = (Run08 && !Jam08) || Bypass;
    Lamp08 = (Trip08 && Flash) || (Ready08 && !Flash);
    if (Lamp08) lamps++;
    if (Trip08) sum += 9;

    /* station 09: Valve */
    Cmd09 = (Auto && Ready08 && !I27) || (!Auto && (I13 || (Cmd09 && !I14)));
    Open09 = I57 && !I38;
    Shut09 = I38 && !I57;
    Disc09 = (Cmd09 && !Open09) || (!Cmd09 && !Shut09);
    Lamp09 = (Lamp09 || (Disc09 && !Bypass)) && !Reset;
    if (Lamp09) lamps++;
    if (Disc09) sum += 10;

    /* station 10: Pump */
    Level10 = (I41 && I33) || (I33 && I39) || (I41 && I39);
    Odd10 = (I41 != I33) || (I33 != I39);
    Dem10 = (Dem10 || Level10) && !I35;
    Mot10 = Dem10 && !I12 && !Lamp10 && Enable;
    Lamp10 = ((I12 && Dem10) || Lamp10 || (Odd10 && Flash)) && !Reset;
    if (Lamp10) lamps++;
    if (Mot10) sum += 11;

    /* station 11: Door */
    Edge11 = I18 && !Old11;
    Old11 = I18;
    Tog11 = Tog11 != Edge11;
    Safe11 = I37 && I46 && !Tog11;
    Lamp11 = (Safe11 && Ready08) || (I30 && Tog11);
    if (Lamp11) lamps++;
    if (Safe11) sum += 12;

    /* station 12: Conv */
    Run12 = (I57 || Run12) && !I60 && !Trip12 && Ready08;
    Jam12 = Run12 && I32 && !I55;
    Trip12 = (Trip12 || (Jam12 && I49)) && !Reset;
    Ready12 = (Run12 && !Jam12) || Bypass;
    Lamp12 = (Trip12 && Flash) || (Ready12 && !Flash);
    if (Lamp12) lamps++;
    if (Trip12) sum += 13;

    /* station 13: Valve */
    Cmd13 = (Auto && Ready12 && !I40) || (!Auto && (I07 || (Cmd13 && !I20)));
    Open13 = I61 && !I21;
    Shut13 = I21 && !I61;
    Disc13 = (Cmd13 && !Open13) || (!Cmd13 && !Shut13);
    Lamp13 = (Lamp13 || (Disc13 && !Bypass)) && !Reset;
    if (Lamp13) lamps++;
    if (Disc13) sum += 14;

    /* station 14: Pump */
    Level14 = (I26 && I09) || (I09 && I51) || (I26 && I51);
    Odd14 = (I26 != I09) || (I09 != I51);
    Dem14 = (Dem14 || Level14) && !I17;
    Mot14 = Dem14 && !I53 && !Lamp14 && Enable;
    Lamp14 = ((I53 && Dem14) || Lamp14 || (Odd14 && Flash)) && !Reset;
    if (Lamp14) lamps++;
    if (Mot14) sum += 15;

    /* station 15: Door */
    Edge15 = I06 && !Old15;
    Old15 = I06;
    Tog15 = Tog15 != Edge15;
    Safe15 = I36 && I23 && !Tog15;
    Lamp15 = (Safe15 && Ready12) || (I54 && Tog15);
    if (Lamp15) lamps++;
    if (Safe15) sum += 16;

    /* station 16: Conv */
    Run16 = (I22 || Run16) && !I53 && !Trip16 && Ready12;
    Jam16 = Run16 && I58 && !I41;
    Trip16 = (Trip16 || (Jam16 && I63)) && !Reset;
    Ready16 = (Run16 && !Jam16) || Bypass;
    Lamp16 = (Trip16 && Flash) || (Ready16 && !Flash);
    if (Lamp16) lamps++;
    if (Trip16) sum += 17;

    /* station 17: Valve */
    Cmd17 = (Auto && Ready16 && !I38) || (!Auto && (I07 || (Cmd17 && !I43)));
    Open17 = I51 && !I39;
    Shut17 = I39 && !I51;
    Disc17 = (Cmd17 && !Open17) || (!Cmd17 && !Shut17);
    Lamp17 = (Lamp17 || (Disc17 && !Bypass)) && !Reset;
    if (Lamp17) lamps++;
    if (Disc17) sum += 18;

    /* station 18: Pump */
    Level18 = (I24 && I22) || (I22 && I47) || (I24 && I47);
    Odd18 = (I24 != I22) || (I22 != I47);
    Dem18 = (Dem18 || Level18) && !I37;
    Mot18 = Dem18 && !I30 && !Lamp18 && Enable;
    Lamp18 = ((I30 && Dem18) || Lamp18 || (Odd18 && Flash)) && !Reset;
    if (Lamp18) lamps++;
    if (Mot18) sum += 19;

    /* station 19: Door */
    Edge19 = I44 && !Old19;
    Old19 = I44;
    Tog19 = Tog19 != Edge19;
    Safe19 = I23 && I13 && !Tog19;
    Lamp19 = (Safe19 && Ready16) || (I14 && Tog19);
    if (Lamp19) lamps++;
    if (Safe19) sum += 20;

    /* station 20: Conv */
    Run20 = (I08 || Run20) && !I42 && !Trip20 && Ready16;
    Jam20 = Run20 && I20 && !I32;
    Trip20 = (Trip20 || (Jam20 && I58)) && !Reset;
    Ready20 = (Run20 && !Jam20) || Bypass;
    Lamp20 = (Trip20 && Flash) || (Ready20 && !Flash);
    if (Lamp20) lamps++;
    if (Trip20) sum += 21;

    /* station 21: Valve */
    Cmd21 = (Auto && Ready20 && !I46) || (!Auto && (I41 || (Cmd21 && !I38)));
    Open21 = I59 && !I61;
    Shut21 = I61 && !I59;
    Disc21 = (Cmd21 && !Open21) || (!Cmd21 && !Shut21);
    Lamp21 = (Lamp21 || (Disc21 && !Bypass)) && !Reset;
    if (Lamp21) lamps++;
    if (Disc21) sum += 22;

    /* station 22: Pump */
    Level22 = (I42 && I38) || (I38 && I17) || (I42 && I17);
    Odd22 = (I42 != I38) || (I38 != I17);
    Dem22 = (Dem22 || Level22) && !I32;
    Mot22 = Dem22 && !I58 && !Lamp22 && Enable;
    Lamp22 = ((I58 && Dem22) || Lamp22 || (Odd22 && Flash)) && !Reset;
    if (Lamp22) lamps++;
    if (Mot22) sum += 23;

    /* station 23: Door */
    Edge23 = I48 && !Old23;
    Old23 = I48;
    Tog23 = Tog23 != Edge23;
    Safe23 = I19 && I42 && !Tog23;
    Lamp23 = (Safe23 && Ready20) || (I50 && Tog23);
    if (Lamp23) lamps++;
    if (Safe23) sum += 24;

    /* station 24: Conv */
    Run24 = (I26 || Run24) && !I29 && !Trip24 && Ready20;
    Jam24 = Run24 && I09 && !I25;
    Trip24 = (Trip24 || (Jam24 && I43)) && !Reset;
    Ready24 = (Run24 && !Jam24) || Bypass;
    Lamp24 = (Trip24 && Flash) || (Ready24 && !Flash);
    if (Lamp24) lamps++;
    if (Trip24) sum += 25;

    /* station 25: Valve */
    Cmd25 = (Auto && Ready24 && !I58) || (!Auto && (I61 || (Cmd25 && !I29)));
    Open25 = I38 && !I41;
    Shut25 = I41 && !I38;
    Disc25 = (Cmd25 && !Open25) || (!Cmd25 && !Shut25);
    Lamp25 = (Lamp25 || (Disc25 && !Bypass)) && !Reset;
    if (Lamp25) lamps++;
    if (Disc25) sum += 26;

    /* station 26: Pump */
    Level26 = (I19 && I60) || (I60 && I37) || (I19 && I37);
    Odd26 = (I19 != I60) || (I60 != I37);
    Dem26 = (Dem26 || Level26) && !I59;
    Mot26 = Dem26 && !I22 && !Lamp26 && Enable;
    Lamp26 = ((I22 && Dem26) || Lamp26 || (Odd26 && Flash)) && !Reset;
    if (Lamp26) lamps++;
    if (Mot26) sum += 27;

    /* station 27: Door */
    Edge27 = I36 && !Old27;
    Old27 = I36;
    Tog27 = Tog27 != Edge27;
    Safe27 = I63 && I44 && !Tog27;
    Lamp27 = (Safe27 && Ready24) || (I59 && Tog27);
    if (Lamp27) lamps++;
    if (Safe27) sum += 28;

    /* station 28: Conv */
    Run28 = (I31 || Run28) && !I38 && !Trip28 && Ready24;
    Jam28 = Run28 && I63 && !I27;
    Trip28 = (Trip28 || (Jam28 && I32)) && !Reset;
    Ready28 = (Run28 && !Jam28) || Bypass;
    Lamp28 = (Trip28 && Flash) || (Ready28 && !Flash);
    if (Lamp28) lamps++;
    if (Trip28) sum += 29;

    /* station 29: Valve */
    Cmd29 = (Auto && Ready28 && !I18) || (!Auto && (I26 || (Cmd29 && !I04)));
    Open29 = I51 && !I19;
    Shut29 = I19 && !I51;
    Disc29 = (Cmd29 && !Open29) || (!Cmd29 && !Shut29);
    Lamp29 = (Lamp29 || (Disc29 && !Bypass)) && !Reset;
    if (Lamp29) lamps++;
    if (Disc29) sum += 30;

    /* station 30: Pump */
    Level30 = (I11 && I36) || (I36 && I20) || (I11 && I20);
    Odd30 = (I11 != I36) || (I36 != I20);
    Dem30 = (Dem30 || Level30) && !I14;
    Mot30 = Dem30 && !I10 && !Lamp30 && Enable;
    Lamp30 = ((I10 && Dem30) || Lamp30 || (Odd30 && Flash)) && !Reset;
    if (Lamp30) lamps++;
    if (Mot30) sum += 31;

    /* station 31: Door */
    Edge31 = I23 && !Old31;
    Old31 = I23;
    Tog31 = Tog31 != Edge31;
    Safe31 = I28 && I51 && !Tog31;
    Lamp31 = (Safe31 && Ready28) || (I29 && Tog31);
    if (Lamp31) lamps++;
    if (Safe31) sum += 32;

    /* station 32: Conv */
    Run32 = (I54 || Run32) && !I44 && !Trip32 && Ready28;
    Jam32 = Run32 && I07 && !I10;
    Trip32 = (Trip32 || (Jam32 && I59)) && !Reset;
    Ready32 = (Run32 && !Jam32) || Bypass;
    Lamp32 = (Trip32 && Flash) || (Ready32 && !Flash);
    if (Lamp32) lamps++;
    if (Trip32) sum += 33;

    /* station 33: Valve */
    Cmd33 = (Auto && Ready32 && !I31) || (!Auto && (I36 || (Cmd33 && !I51)));
    Open33 = I59 && !I63;
    Shut33 = I63 && !I59;
    Disc33 = (Cmd33 && !Open33) || (!Cmd33 && !Shut33);
    Lamp33 = (Lamp33 || (Disc33 && !Bypass)) && !Reset;
    if (Lamp33) lamps++;
    if (Disc33) sum += 34;

    /* station 34: Pump */
    Level34 = (I62 && I40) || (I40 && I36) || (I62 && I36);
    Odd34 = (I62 != I40) || (I40 != I36);
    Dem34 = (Dem34 || Level34) && !I50;
    Mot34 = Dem34 && !I53 && !Lamp34 && Enable;
    Lamp34 = ((I53 && Dem34) || Lamp34 || (Odd34 && Flash)) && !Reset;
    if (Lamp34) lamps++;
    if (Mot34) sum += 35;

    /* station 35: Door */
    Edge35 = I28 && !Old35;
    Old35 = I28;
    Tog35 = Tog35 != Edge35;
    Safe35 = I35 && I58 && !Tog35;
    Lamp35 = (Safe35 && Ready32) || (I11 && Tog35);
    if (Lamp35) lamps++;
    if (Safe35) sum += 36;

    /* station 36: Conv */
    Run36 = (I41 || Run36) && !I26 && !Trip36 && Ready32;
    Jam36 = Run36 && I29 && !I42;
    Trip36 = (Trip36 || (Jam36 && I05)) && !Reset;
    Ready36 = (Run36 && !Jam36) || Bypass;
    Lamp36 = (Trip36 && Flash) || (Ready36 && !Flash);
    if (Lamp36) lamps++;
    if (Trip36) sum += 37;

    /* station 37: Valve */
    Cmd37 = (Auto && Ready36 && !I08) || (!Auto && (I12 || (Cmd37 && !I42)));
    Open37 = I39 && !I61;
    Shut37 = I61 && !I39;
    Disc37 = (Cmd37 && !Open37) || (!Cmd37 && !Shut37);
    Lamp37 = (Lamp37 || (Disc37 && !Bypass)) && !Reset;
    if (Lamp37) lamps++;
    if (Disc37) sum += 38;

    /* station 38: Pump */
    Level38 = (I25 && I47) || (I47 && I58) || (I25 && I58);
    Odd38 = (I25 != I47) || (I47 != I58);
    Dem38 = (Dem38 || Level38) && !I19;
    Mot38 = Dem38 && !I27 && !Lamp38 && Enable;
    Lamp38 = ((I27 && Dem38) || Lamp38 || (Odd38 && Flash)) && !Reset;
    if (Lamp38) lamps++;
    if (Mot38) sum += 39;

    /* station 39: Door */
    Edge39 = I27 && !Old39;
    Old39 = I27;
    Tog39 = Tog39 != Edge39;
    Safe39 = I17 && I15 && !Tog39;
    Lamp39 = (Safe39 && Ready36) || (I44 && Tog39);
    if (Lamp39) lamps++;
    if (Safe39) sum += 40;

    /* station 40: Conv */
    Run40 = (I50 || Run40) && !I04 && !Trip40 && Ready36;
    Jam40 = Run40 && I47 && !I41;
    Trip40 = (Trip40 || (Jam40 && I09)) && !Reset;
    Ready40 = (Run40 && !Jam40) || Bypass;
    Lamp40 = (Trip40 && Flash) || (Ready40 && !Flash);
    if (Lamp40) lamps++;
    if (Trip40) sum += 41;

    /* station 41: Valve */
    Cmd41 = (Auto && Ready40 && !I22) || (!Auto && (I56 || (Cmd41 && !I11)));
    Open41 = I15 && !I20;
    Shut41 = I20 && !I15;
    Disc41 = (Cmd41 && !Open41) || (!Cmd41 && !Shut41);
    Lamp41 = (Lamp41 || (Disc41 && !Bypass)) && !Reset;
    if (Lamp41) lamps++;
    if (Disc41) sum += 42;

    /* station 42: Pump */
    Level42 = (I23 && I49) || (I49 && I16) || (I23 && I16);
    Odd42 = (I23 != I49) || (I49 != I16);
    Dem42 = (Dem42 || Level42) && !I55;
    Mot42 = Dem42 && !I59 && !Lamp42 && Enable;
    Lamp42 = ((I59 && Dem42) || Lamp42 || (Odd42 && Flash)) && !Reset;
    if (Lamp42) lamps++;
    if (Mot42) sum += 43;

    /* station 43: Door */
    Edge43 = I58 && !Old43;
    Old43 = I58;
    Tog43 = Tog43 != Edge43;
    Safe43 = I35 && I45 && !Tog43;
    Lamp43 = (Safe43 && Ready40) || (I13 && Tog43);
    if (Lamp43) lamps++;
    if (Safe43) sum += 44;

    /* station 44: Conv */
    Run44 = (I24 || Run44) && !I07 && !Trip44 && Ready40;
    Jam44 = Run44 && I30 && !I54;
    Trip44 = (Trip44 || (Jam44 && I34)) && !Reset;
    Ready44 = (Run44 && !Jam44) || Bypass;
    Lamp44 = (Trip44 && Flash) || (Ready44 && !Flash);
    if (Lamp44) lamps++;
    if (Trip44) sum += 45;

    /* station 45: Valve */
    Cmd45 = (Auto && Ready44 && !I06) || (!Auto && (I30 || (Cmd45 && !I44)));
    Open45 = I63 && !I27;
    Shut45 = I27 && !I63;
    Disc45 = (Cmd45 && !Open45) || (!Cmd45 && !Shut45);
    Lamp45 = (Lamp45 || (Disc45 && !Bypass)) && !Reset;
    if (Lamp45) lamps++;
    if (Disc45) sum += 46;

    /* station 46: Pump */
    Level46 = (I17 && I61) || (I61 && I58) || (I17 && I58);
    Odd46 = (I17 != I61) || (I61 != I58);
    Dem46 = (Dem46 || Level46) && !I30;
    Mot46 = Dem46 && !I54 && !Lamp46 && Enable;
    Lamp46 = ((I54 && Dem46) || Lamp46 || (Odd46 && Flash)) && !Reset;
    if (Lamp46) lamps++;
    if (Mot46) sum += 47;

    /* station 47: Door */
    Edge47 = I27 && !Old47;
    Old47 = I27;
    Tog47 = Tog47 != Edge47;
    Safe47 = I38 && I36 && !Tog47;
    Lamp47 = (Safe47 && Ready44) || (I08 && Tog47);
    if (Lamp47) lamps++;
    if (Safe47) sum += 48;

    /* station 48: Conv */
    Run48 = (I58 || Run48) && !I51 && !Trip48 && Ready44;
    Jam48 = Run48 && I23 && !I36;
    Trip48 = (Trip48 || (Jam48 && I31)) && !Reset;
    Ready48 = (Run48 && !Jam48) || Bypass;
    Lamp48 = (Trip48 && Flash) || (Ready48 && !Flash);
    if (Lamp48) lamps++;
    if (Trip48) sum += 49;

    /* station 49: Valve */
    Cmd49 = (Auto && Ready48 && !I18) || (!Auto && (I29 || (Cmd49 && !I54)));
    Open49 = I08 && !I52;
    Shut49 = I52 && !I08;
    Disc49 = (Cmd49 && !Open49) || (!Cmd49 && !Shut49);
    Lamp49 = (Lamp49 || (Disc49 && !Bypass)) && !Reset;
    if (Lamp49) lamps++;
    if (Disc49) sum += 50;

    /* station 50: Pump */
    Level50 = (I63 && I52) || (I52 && I46) || (I63 && I46);
    Odd50 = (I63 != I52) || (I52 != I46);
    Dem50 = (Dem50 || Level50) && !I06;
    Mot50 = Dem50 && !I04 && !Lamp50 && Enable;
    Lamp50 = ((I04 && Dem50) || Lamp50 || (Odd50 && Flash)) && !Reset;
    if (Lamp50) lamps++;
    if (Mot50) sum += 51;

    /* station 51: Door */
    Edge51 = I17 && !Old51;
    Old51 = I17;
    Tog51 = Tog51 != Edge51;
    Safe51 = I12 && I25 && !Tog51;
    Lamp51 = (Safe51 && Ready48) || (I11 && Tog51);
    if (Lamp51) lamps++;
    if (Safe51) sum += 52;

    /* station 52: Conv */
    Run52 = (I12 || Run52) && !I07 && !Trip52 && Ready48;
    Jam52 = Run52 && I25 && !I16;
    Trip52 = (Trip52 || (Jam52 && I63)) && !Reset;
    Ready52 = (Run52 && !Jam52) || Bypass;
    Lamp52 = (Trip52 && Flash) || (Ready52 && !Flash);
    if (Lamp52) lamps++;
    if (Trip52) sum += 53;

    /* station 53: Valve */
    Cmd53 = (Auto && Ready52 && !I57) || (!Auto && (I30 || (Cmd53 && !I28)));
    Open53 = I14 && !I13;
    Shut53 = I13 && !I14;
    Disc53 = (Cmd53 && !Open53) || (!Cmd53 && !Shut53);
    Lamp53 = (Lamp53 || (Disc53 && !Bypass)) && !Reset;
    if (Lamp53) lamps++;
    if (Disc53) sum += 54;

    /* station 54: Pump */
    Level54 = (I52 && I59) || (I59 && I15) || (I52 && I15);
    Odd54 = (I52 != I59) || (I59 != I15);
    Dem54 = (Dem54 || Level54) && !I58;
    Mot54 = Dem54 && !I17 && !Lamp54 && Enable;
    Lamp54 = ((I17 && Dem54) || Lamp54 || (Odd54 && Flash)) && !Reset;
    if (Lamp54) lamps++;
    if (Mot54) sum += 55;

    /* station 55: Door */
    Edge55 = I43 && !Old55;
    Old55 = I43;
    Tog55 = Tog55 != Edge55;
    Safe55 = I34 && I41 && !Tog55;
    Lamp55 = (Safe55 && Ready52) || (I47 && Tog55);
    if (Lamp55) lamps++;
    if (Safe55) sum += 56;

    /* station 56: Conv */
    Run56 = (I16 || Run56) && !I11 && !Trip56 && Ready52;
    Jam56 = Run56 && I20 && !I50;
    Trip56 = (Trip56 || (Jam56 && I08)) && !Reset;
    Ready56 = (Run56 && !Jam56) || Bypass;
    Lamp56 = (Trip56 && Flash) || (Ready56 && !Flash);
    if (Lamp56) lamps++;
    if (Trip56) sum += 57;

    /* station 57: Valve */
    Cmd57 = (Auto && Ready56 && !I30) || (!Auto && (I42 || (Cmd57 && !I15)));
    Open57 = I32 && !I39;
    Shut57 = I39 && !I32;
    Disc57 = (Cmd57 && !Open57) || (!Cmd57 && !Shut57);
    Lamp57 = (Lamp57 || (Disc57 && !Bypass)) && !Reset;
    if (Lamp57) lamps++;
    if (Disc57) sum += 58;

    /* station 58: Pump */
    Level58 = (I60 && I20) || (I20 && I29) || (I60 && I29);
    Odd58 = (I60 != I20) || (I20 != I29);
    Dem58 = (Dem58 || Level58) && !I61;
    Mot58 = Dem58 && !I40 && !Lamp58 && Enable;
    Lamp58 = ((I40 && Dem58) || Lamp58 || (Odd58 && Flash)) && !Reset;
    if (Lamp58) lamps++;
    if (Mot58) sum += 59;

    /* station 59: Door */
    Edge59 = I34 && !Old59;
    Old59 = I34;
    Tog59 = Tog59 != Edge59;
    Safe59 = I55 && I41 && !Tog59;
    Lamp59 = (Safe59 && Ready56) || (I49 && Tog59);
    if (Lamp59) lamps++;
    if (Safe59) sum += 60;

    /* station 60: Conv */
    Run60 = (I12 || Run60) && !I27 && !Trip60 && Ready56;
    Jam60 = Run60 && I58 && !I11;
    Trip60 = (Trip60 || (Jam60 && I45)) && !Reset;
    Ready60 = (Run60 && !Jam60) || Bypass;
    Lamp60 = (Trip60 && Flash) || (Ready60 && !Flash);
    if (Lamp60) lamps++;
    if (Trip60) sum += 61;

    /* station 61: Valve */
    Cmd61 = (Auto && Ready60 && !I15) || (!Auto && (I20 || (Cmd61 && !I63)));
    Open61 = I57 && !I41;
    Shut61 = I41 && !I57;
    Disc61 = (Cmd61 && !Open61) || (!Cmd61 && !Shut61);
    Lamp61 = (Lamp61 || (Disc61 && !Bypass)) && !Reset;
    if (Lamp61) lamps++;
    if (Disc61) sum += 62;

    /* station 62: Pump */
    Level62 = (I21 && I15) || (I15 && I30) || (I21 && I30);
    Odd62 = (I21 != I15) || (I15 != I30);
    Dem62 = (Dem62 || Level62) && !I05;
    Mot62 = Dem62 && !I52 && !Lamp62 && Enable;
    Lamp62 = ((I52 && Dem62) || Lamp62 || (Odd62 && Flash)) && !Reset;
    if (Lamp62) lamps++;
    if (Mot62) sum += 63;

    /* station 63: Door */
    Edge63 = I50 && !Old63;
    Old63 = I50;
    Tog63 = Tog63 != Edge63;
    Safe63 = I14 && I13 && !Tog63;
    Lamp63 = (Safe63 && Ready60) || (I10 && Tog63);
    if (Lamp63) lamps++;
    if (Safe63) sum += 64;

    /* station 64: Conv */
    Run64 = (I16 || Run64) && !I12 && !Trip64 && Ready60;
    Jam64 = Run64 && I48 && !I44;
    Trip64 = (Trip64 || (Jam64 && I23)) && !Reset;
    Ready64 = (Run64 && !Jam64) || Bypass;
    Lamp64 = (Trip64 && Flash) || (Ready64 && !Flash);
    if (Lamp64) lamps++;
    if (Trip64) sum += 65;

    /* station 65: Valve */
    Cmd65 = (Auto && Ready64 && !I47) || (!Auto && (I37 || (Cmd65 && !I39)));
    Open65 = I27 && !I09;
    Shut65 = I09 && !I27;
    Disc65 = (Cmd65 && !Open65) || (!Cmd65 && !Shut65);
    Lamp65 = (Lamp65 || (Disc65 && !Bypass)) && !Reset;
    if (Lamp65) lamps++;
    if (Disc65) sum += 66;

    /* station 66: Pump */
    Level66 = (I33 && I17) || (I17 && I22) || (I33 && I22);
    Odd66 = (I33 != I17) || (I17 != I22);
    Dem66 = (Dem66 || Level66) && !I44;
    Mot66 = Dem66 && !I57 && !Lamp66 && Enable;
    Lamp66 = ((I57 && Dem66) || Lamp66 || (Odd66 && Flash)) && !Reset;
    if (Lamp66) lamps++;
    if (Mot66) sum += 67;

    /* station 67: Door */
    Edge67 = I38 && !Old67;
    Old67 = I38;
    Tog67 = Tog67 != Edge67;
    Safe67 = I22 && I36 && !Tog67;
    Lamp67 = (Safe67 && Ready64) || (I06 && Tog67);
    if (Lamp67) lamps++;
    if (Safe67) sum += 68;

    /* station 68: Conv */
    Run68 = (I37 || Run68) && !I09 && !Trip68 && Ready64;
    Jam68 = Run68 && I51 && !I11;
    Trip68 = (Trip68 || (Jam68 && I07)) && !Reset;
    Ready68 = (Run68 && !Jam68) || Bypass;
    Lamp68 = (Trip68 && Flash) || (Ready68 && !Flash);
    if (Lamp68) lamps++;
    if (Trip68) sum += 69;

    /* station 69: Valve */
    Cmd69 = (Auto && Ready68 && !I31) || (!Auto && (I48 || (Cmd69 && !I42)));
    Open69 = I47 && !I15;
    Shut69 = I15 && !I47;
    Disc69 = (Cmd69 && !Open69) || (!Cmd69 && !Shut69);
    Lamp69 = (Lamp69 || (Disc69 && !Bypass)) && !Reset;
    if (Lamp69) lamps++;
    if (Disc69) sum += 70;

    /* station 70: Pump */
    Level70 = (I19 && I49) || (I49 && I52) || (I19 && I52);
    Odd70 = (I19 != I49) || (I49 != I52);
    Dem70 = (Dem70 || Level70) && !I51;
    Mot70 = Dem70 && !I26 && !Lamp70 && Enable;
    Lamp70 = ((I26 && Dem70) || Lamp70 || (Odd70 && Flash)) && !Reset;
    if (Lamp70) lamps++;
    if (Mot70) sum += 71;

    /* station 71: Door */
    Edge71 = I38 && !Old71;
    Old71 = I38;
    Tog71 = Tog71 != Edge71;
    Safe71 = I27 && I49 && !Tog71;
    Lamp71 = (Safe71 && Ready68) || (I47 && Tog71);
    if (Lamp71) lamps++;
    if (Safe71) sum += 72;

    /* station 72: Conv */
    Run72 = (I21 || Run72) && !I05 && !Trip72 && Ready68;
    Jam72 = Run72 && I40 && !I24;
    Trip72 = (Trip72 || (Jam72 && I61)) && !Reset;
    Ready72 = (Run72 && !Jam72) || Bypass;
    Lamp72 = (Trip72 && Flash) || (Ready72 && !Flash);
    if (Lamp72) lamps++;
    if (Trip72) sum += 73;

    /* station 73: Valve */
    Cmd73 = (Auto && Ready72 && !I36) || (!Auto && (I62 || (Cmd73 && !I55)));
    Open73 = I27 && !I21;
    Shut73 = I21 && !I27;
    Disc73 = (Cmd73 && !Open73) || (!Cmd73 && !Shut73);
    Lamp73 = (Lamp73 || (Disc73 && !Bypass)) && !Reset;
    if (Lamp73) lamps++;
    if (Disc73) sum += 74;

    /* station 74: Pump */
    Level74 = (I48 && I44) || (I44 && I19) || (I48 && I19);
    Odd74 = (I48 != I44) || (I44 != I19);
    Dem74 = (Dem74 || Level74) && !I63;
    Mot74 = Dem74 && !I58 && !Lamp74 && Enable;
    Lamp74 = ((I58 && Dem74) || Lamp74 || (Odd74 && Flash)) && !Reset;
    if (Lamp74) lamps++;
    if (Mot74) sum += 75;

    /* station 75: Door */
    Edge75 = I21 && !Old75;
    Old75 = I21;
    Tog75 = Tog75 != Edge75;
    Safe75 = I24 && I46 && !Tog75;
    Lamp75 = (Safe75 && Ready72) || (I60 && Tog75);
    if (Lamp75) lamps++;
    if (Safe75) sum += 76;

    /* station 76: Conv */
    Run76 = (I24 || Run76) && !I26 && !Trip76 && Ready72;
    Jam76 = Run76 && I36 && !I52;
    Trip76 = (Trip76 || (Jam76 && I50)) && !Reset;
    Ready76 = (Run76 && !Jam76) || Bypass;
    Lamp76 = (Trip76 && Flash) || (Ready76 && !Flash);
    if (Lamp76) lamps++;
    if (Trip76) sum += 77;

    /* station 77: Valve */
    Cmd77 = (Auto && Ready76 && !I14) || (!Auto && (I59 || (Cmd77 && !I47)));
    Open77 = I25 && !I49;
    Shut77 = I49 && !I25;
    Disc77 = (Cmd77 && !Open77) || (!Cmd77 && !Shut77);
    Lamp77 = (Lamp77 || (Disc77 && !Bypass)) && !Reset;
    if (Lamp77) lamps++;
    if (Disc77) sum += 78;

    /* station 78: Pump */
    Level78 = (I11 && I07) || (I07 && I26) || (I11 && I26);
    Odd78 = (I11 != I07) || (I07 != I26);
    Dem78 = (Dem78 || Level78) && !I20;
    Mot78 = Dem78 && !I49 && !Lamp78 && Enable;
    Lamp78 = ((I49 && Dem78) || Lamp78 || (Odd78 && Flash)) && !Reset;
    if (Lamp78) lamps++;
    if (Mot78) sum += 79;

    /* station 79: Door */
    Edge79 = I49 && !Old79;
    Old79 = I49;
    Tog79 = Tog79 != Edge79;
    Safe79 = I55 && I08 && !Tog79;
    Lamp79 = (Safe79 && Ready76) || (I53 && Tog79);
    if (Lamp79) lamps++;
    if (Safe79) sum += 80;

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum * 100 + lamps));
}
