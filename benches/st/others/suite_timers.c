/* 50 stations of ten timers, counters and edge detectors each. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool run, q; uint32_t start, et; } ton_t;
typedef struct { bool run, q; uint32_t start, et; } tof_t;
typedef struct { uint8_t state; bool q; uint32_t start, et; } tp_t;
typedef struct { bool m, q; } trig_t;
typedef struct { bool m, q; int16_t cv; } ct_t;
typedef struct { bool mu, md, qu, qd; int16_t cv; } ctud_t;

static uint32_t now;    /* ms */

static void ton(ton_t *t, bool in, uint32_t pt)
{
    if (!in) {
        t->run = t->q = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    if (t->q)
        return;
    t->et = now - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = true;
    }
}

static void tof(tof_t *t, bool in, uint32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
        return;
    }
    if (!t->q)
        return;
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    t->et = now - t->start;
    if (t->et >= pt) {
        t->et = pt;
        t->q = false;
    }
}

static void tp(tp_t *t, bool in, uint32_t pt)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now;
        t->q = true;
    }
    if (t->state == 1) {
        t->et = now - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->state = 2;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
}

static void r_trig(trig_t *t, bool clk)
{
    t->q = clk && !t->m;
    t->m = clk;
}

static void f_trig(trig_t *t, bool clk)
{
    t->q = !clk && !t->m;
    t->m = !clk;
}

static void ctu(ct_t *c, bool cu, bool r, int16_t pv)
{
    bool edge = cu && !c->m;

    c->m = cu;
    if (r)
        c->cv = 0;
    else if (edge && c->cv < INT16_MAX)
        c->cv++;
    c->q = c->cv >= pv;
}

static void ctd(ct_t *c, bool cd, bool ld, int16_t pv)
{
    bool edge = cd && !c->m;

    c->m = cd;
    if (ld)
        c->cv = pv;
    else if (edge && c->cv > INT16_MIN)
        c->cv--;
    c->q = c->cv <= 0;
}

static void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->mu, down = cd && !c->md;

    c->mu = cu;
    c->md = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down && c->cv < INT16_MAX)
        c->cv++;
    else if (down && !up && c->cv > INT16_MIN)
        c->cv--;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static ton_t TONA01, TONA02, TONA03, TONA04, TONA05, TONA06, TONA07, TONA08, TONA09, TONA10;
static ton_t TONA11, TONA12, TONA13, TONA14, TONA15, TONA16, TONA17, TONA18, TONA19, TONA20;
static ton_t TONA21, TONA22, TONA23, TONA24, TONA25, TONA26, TONA27, TONA28, TONA29, TONA30;
static ton_t TONA31, TONA32, TONA33, TONA34, TONA35, TONA36, TONA37, TONA38, TONA39, TONA40;
static ton_t TONA41, TONA42, TONA43, TONA44, TONA45, TONA46, TONA47, TONA48, TONA49, TONA50;
static ton_t TONB01, TONB02, TONB03, TONB04, TONB05, TONB06, TONB07, TONB08, TONB09, TONB10;
static ton_t TONB11, TONB12, TONB13, TONB14, TONB15, TONB16, TONB17, TONB18, TONB19, TONB20;
static ton_t TONB21, TONB22, TONB23, TONB24, TONB25, TONB26, TONB27, TONB28, TONB29, TONB30;
static ton_t TONB31, TONB32, TONB33, TONB34, TONB35, TONB36, TONB37, TONB38, TONB39, TONB40;
static ton_t TONB41, TONB42, TONB43, TONB44, TONB45, TONB46, TONB47, TONB48, TONB49, TONB50;
static tof_t TOFA01, TOFA02, TOFA03, TOFA04, TOFA05, TOFA06, TOFA07, TOFA08, TOFA09, TOFA10;
static tof_t TOFA11, TOFA12, TOFA13, TOFA14, TOFA15, TOFA16, TOFA17, TOFA18, TOFA19, TOFA20;
static tof_t TOFA21, TOFA22, TOFA23, TOFA24, TOFA25, TOFA26, TOFA27, TOFA28, TOFA29, TOFA30;
static tof_t TOFA31, TOFA32, TOFA33, TOFA34, TOFA35, TOFA36, TOFA37, TOFA38, TOFA39, TOFA40;
static tof_t TOFA41, TOFA42, TOFA43, TOFA44, TOFA45, TOFA46, TOFA47, TOFA48, TOFA49, TOFA50;
static tof_t TOFB01, TOFB02, TOFB03, TOFB04, TOFB05, TOFB06, TOFB07, TOFB08, TOFB09, TOFB10;
static tof_t TOFB11, TOFB12, TOFB13, TOFB14, TOFB15, TOFB16, TOFB17, TOFB18, TOFB19, TOFB20;
static tof_t TOFB21, TOFB22, TOFB23, TOFB24, TOFB25, TOFB26, TOFB27, TOFB28, TOFB29, TOFB30;
static tof_t TOFB31, TOFB32, TOFB33, TOFB34, TOFB35, TOFB36, TOFB37, TOFB38, TOFB39, TOFB40;
static tof_t TOFB41, TOFB42, TOFB43, TOFB44, TOFB45, TOFB46, TOFB47, TOFB48, TOFB49, TOFB50;
static tp_t PULSE01, PULSE02, PULSE03, PULSE04, PULSE05, PULSE06, PULSE07, PULSE08, PULSE09, PULSE10;
static tp_t PULSE11, PULSE12, PULSE13, PULSE14, PULSE15, PULSE16, PULSE17, PULSE18, PULSE19, PULSE20;
static tp_t PULSE21, PULSE22, PULSE23, PULSE24, PULSE25, PULSE26, PULSE27, PULSE28, PULSE29, PULSE30;
static tp_t PULSE31, PULSE32, PULSE33, PULSE34, PULSE35, PULSE36, PULSE37, PULSE38, PULSE39, PULSE40;
static tp_t PULSE41, PULSE42, PULSE43, PULSE44, PULSE45, PULSE46, PULSE47, PULSE48, PULSE49, PULSE50;
static trig_t RISE01, RISE02, RISE03, RISE04, RISE05, RISE06, RISE07, RISE08, RISE09, RISE10;
static trig_t RISE11, RISE12, RISE13, RISE14, RISE15, RISE16, RISE17, RISE18, RISE19, RISE20;
static trig_t RISE21, RISE22, RISE23, RISE24, RISE25, RISE26, RISE27, RISE28, RISE29, RISE30;
static trig_t RISE31, RISE32, RISE33, RISE34, RISE35, RISE36, RISE37, RISE38, RISE39, RISE40;
static trig_t RISE41, RISE42, RISE43, RISE44, RISE45, RISE46, RISE47, RISE48, RISE49, RISE50;
static trig_t FALL01, FALL02, FALL03, FALL04, FALL05, FALL06, FALL07, FALL08, FALL09, FALL10;
static trig_t FALL11, FALL12, FALL13, FALL14, FALL15, FALL16, FALL17, FALL18, FALL19, FALL20;
static trig_t FALL21, FALL22, FALL23, FALL24, FALL25, FALL26, FALL27, FALL28, FALL29, FALL30;
static trig_t FALL31, FALL32, FALL33, FALL34, FALL35, FALL36, FALL37, FALL38, FALL39, FALL40;
static trig_t FALL41, FALL42, FALL43, FALL44, FALL45, FALL46, FALL47, FALL48, FALL49, FALL50;
static ct_t CUP01, CUP02, CUP03, CUP04, CUP05, CUP06, CUP07, CUP08, CUP09, CUP10;
static ct_t CUP11, CUP12, CUP13, CUP14, CUP15, CUP16, CUP17, CUP18, CUP19, CUP20;
static ct_t CUP21, CUP22, CUP23, CUP24, CUP25, CUP26, CUP27, CUP28, CUP29, CUP30;
static ct_t CUP31, CUP32, CUP33, CUP34, CUP35, CUP36, CUP37, CUP38, CUP39, CUP40;
static ct_t CUP41, CUP42, CUP43, CUP44, CUP45, CUP46, CUP47, CUP48, CUP49, CUP50;
static ct_t CDOWN01, CDOWN02, CDOWN03, CDOWN04, CDOWN05, CDOWN06, CDOWN07, CDOWN08, CDOWN09, CDOWN10;
static ct_t CDOWN11, CDOWN12, CDOWN13, CDOWN14, CDOWN15, CDOWN16, CDOWN17, CDOWN18, CDOWN19, CDOWN20;
static ct_t CDOWN21, CDOWN22, CDOWN23, CDOWN24, CDOWN25, CDOWN26, CDOWN27, CDOWN28, CDOWN29, CDOWN30;
static ct_t CDOWN31, CDOWN32, CDOWN33, CDOWN34, CDOWN35, CDOWN36, CDOWN37, CDOWN38, CDOWN39, CDOWN40;
static ct_t CDOWN41, CDOWN42, CDOWN43, CDOWN44, CDOWN45, CDOWN46, CDOWN47, CDOWN48, CDOWN49, CDOWN50;
static ctud_t CBOTH01, CBOTH02, CBOTH03, CBOTH04, CBOTH05, CBOTH06, CBOTH07, CBOTH08, CBOTH09, CBOTH10;
static ctud_t CBOTH11, CBOTH12, CBOTH13, CBOTH14, CBOTH15, CBOTH16, CBOTH17, CBOTH18, CBOTH19, CBOTH20;
static ctud_t CBOTH21, CBOTH22, CBOTH23, CBOTH24, CBOTH25, CBOTH26, CBOTH27, CBOTH28, CBOTH29, CBOTH30;
static ctud_t CBOTH31, CBOTH32, CBOTH33, CBOTH34, CBOTH35, CBOTH36, CBOTH37, CBOTH38, CBOTH39, CBOTH40;
static ctud_t CBOTH41, CBOTH42, CBOTH43, CBOTH44, CBOTH45, CBOTH46, CBOTH47, CBOTH48, CBOTH49, CBOTH50;
static int32_t tick;

void scan(void)
{
    int32_t sum = 0;
    bool X01, X02, X03, X04, X05, X06, X07, X08, X09, X10, X11, X12, X13, X14, X15, X16;

    now = (uint32_t)(now_us / 1000);
    tick++;
    X01 = tick / 2 % 2 == 1;
    X02 = tick / 3 % 2 == 1;
    X03 = tick / 4 % 2 == 1;
    X04 = tick / 5 % 2 == 1;
    X05 = tick / 7 % 2 == 1;
    X06 = tick / 9 % 2 == 1;
    X07 = tick / 11 % 2 == 1;
    X08 = tick / 13 % 2 == 1;
    X09 = tick / 16 % 2 == 1;
    X10 = tick / 19 % 2 == 1;
    X11 = tick / 23 % 2 == 1;
    X12 = tick / 29 % 2 == 1;
    X13 = tick / 37 % 2 == 1;
    X14 = tick / 47 % 2 == 1;
    X15 = tick / 61 % 2 == 1;
    X16 = tick / 83 % 2 == 1;

    /* station 01 */
    r_trig(&RISE01, X11);
    ton(&TONA01, X10 || TOFB50.q, 200);
    tof(&TOFA01, X12 && TONA01.q, 210);
    tp(&PULSE01, X08, 90);
    ton(&TONB01, !TONB01.q, 310);
    tof(&TOFB01, X16 || PULSE01.q, 240);
    f_trig(&FALL01, TOFA01.q);
    ctu(&CUP01, TONB01.q, CUP01.q, 9);
    ctd(&CDOWN01, FALL01.q, CDOWN01.q, 8);
    ctud(&CBOTH01, RISE01.q, X15, CUP50.q && CDOWN01.q, FALL50.q && X08, 6);
    if (TONA01.q) sum += 1;
    if (TOFA01.q && TOFA01.et > 20) sum += 2;
    if (PULSE01.q) sum += 3;
    if (PULSE01.et >= 20) sum += 4;
    if (TOFB01.q && !CBOTH01.qu) sum += 5;
    if (CBOTH01.qd) sum += 6;
    sum += CUP01.cv + 2 * CDOWN01.cv + 3 * CBOTH01.cv;

    /* station 02 */
    r_trig(&RISE02, X07);
    ton(&TONA02, !X02, 220);
    tof(&TOFA02, X15 ^ X05, 250);
    tp(&PULSE02, RISE02.q || TONA02.q, 330);
    ton(&TONB02, !TONB02.q, 220);
    tof(&TOFB02, X05 || PULSE02.q, 90);
    f_trig(&FALL02, TOFA02.q);
    ctu(&CUP02, TONB02.q, CUP02.q, 3);
    ctd(&CDOWN02, FALL02.q, CDOWN02.q, 7);
    ctud(&CBOTH02, RISE02.q, X10, CUP01.q && CDOWN02.q, FALL01.q && X04, 2);
    if (TONA02.q) sum += 2;
    if (TOFA02.q && TOFA02.et > 60) sum += 2;
    if (PULSE02.q) sum += 3;
    if (PULSE02.et >= 60) sum += 4;
    if (TOFB02.q && !CBOTH02.qu) sum += 5;
    if (CBOTH02.qd) sum += 6;
    sum += CUP02.cv + 2 * CDOWN02.cv + 3 * CBOTH02.cv;

    /* station 03 */
    r_trig(&RISE03, X07);
    ton(&TONA03, X13 && !X12, 230);
    tof(&TOFA03, TONA03.q, 340);
    tp(&PULSE03, RISE03.q, 110);
    ton(&TONB03, !TONB03.q, 280);
    tof(&TOFB03, X06 || PULSE03.q, 100);
    f_trig(&FALL03, TOFA03.q);
    ctu(&CUP03, TONB03.q, CUP03.q, 9);
    ctd(&CDOWN03, FALL03.q, CDOWN03.q, 7);
    ctud(&CBOTH03, RISE03.q, X12, CUP02.q && CDOWN03.q, FALL02.q && X02, 5);
    if (TONA03.q) sum += 3;
    if (TOFA03.q && TOFA03.et > 10) sum += 2;
    if (PULSE03.q) sum += 3;
    if (PULSE03.et >= 10) sum += 4;
    if (TOFB03.q && !CBOTH03.qu) sum += 5;
    if (CBOTH03.qd) sum += 6;
    sum += CUP03.cv + 2 * CDOWN03.cv + 3 * CBOTH03.cv;

    /* station 04 */
    r_trig(&RISE04, X08);
    ton(&TONA04, X03 || TOFB03.q, 130);
    tof(&TOFA04, X12 && TONA04.q, 350);
    tp(&PULSE04, X01, 210);
    ton(&TONB04, !TONB04.q, 90);
    tof(&TOFB04, X14 || PULSE04.q, 170);
    f_trig(&FALL04, TOFA04.q);
    ctu(&CUP04, TONB04.q, CUP04.q, 4);
    ctd(&CDOWN04, FALL04.q, CDOWN04.q, 2);
    ctud(&CBOTH04, RISE04.q, X09, CUP03.q && CDOWN04.q, FALL03.q && X01, 4);
    if (TONA04.q) sum += 4;
    if (TOFA04.q && TOFA04.et > 20) sum += 2;
    if (PULSE04.q) sum += 3;
    if (PULSE04.et >= 20) sum += 4;
    if (TOFB04.q && !CBOTH04.qu) sum += 5;
    if (CBOTH04.qd) sum += 6;
    sum += CUP04.cv + 2 * CDOWN04.cv + 3 * CBOTH04.cv;

    /* station 05 */
    r_trig(&RISE05, X02);
    ton(&TONA05, !X13, 170);
    tof(&TOFA05, X12 ^ X06, 320);
    tp(&PULSE05, RISE05.q || TONA05.q, 160);
    ton(&TONB05, !TONB05.q, 50);
    tof(&TOFB05, X06 || PULSE05.q, 370);
    f_trig(&FALL05, TOFA05.q);
    ctu(&CUP05, TONB05.q, CUP05.q, 8);
    ctd(&CDOWN05, FALL05.q, CDOWN05.q, 2);
    ctud(&CBOTH05, RISE05.q, X08, CUP04.q && CDOWN05.q, FALL04.q && X01, 2);
    if (TONA05.q) sum += 5;
    if (TOFA05.q && TOFA05.et > 80) sum += 2;
    if (PULSE05.q) sum += 3;
    if (PULSE05.et >= 80) sum += 4;
    if (TOFB05.q && !CBOTH05.qu) sum += 5;
    if (CBOTH05.qd) sum += 6;
    sum += CUP05.cv + 2 * CDOWN05.cv + 3 * CBOTH05.cv;

    /* station 06 */
    r_trig(&RISE06, X03);
    ton(&TONA06, X02 && !X10, 40);
    tof(&TOFA06, TONA06.q, 20);
    tp(&PULSE06, RISE06.q, 270);
    ton(&TONB06, !TONB06.q, 400);
    tof(&TOFB06, X04 || PULSE06.q, 310);
    f_trig(&FALL06, TOFA06.q);
    ctu(&CUP06, TONB06.q, CUP06.q, 5);
    ctd(&CDOWN06, FALL06.q, CDOWN06.q, 9);
    ctud(&CBOTH06, RISE06.q, X10, CUP05.q && CDOWN06.q, FALL05.q && X11, 8);
    if (TONA06.q) sum += 6;
    if (TOFA06.q && TOFA06.et > 10) sum += 2;
    if (PULSE06.q) sum += 3;
    if (PULSE06.et >= 10) sum += 4;
    if (TOFB06.q && !CBOTH06.qu) sum += 5;
    if (CBOTH06.qd) sum += 6;
    sum += CUP06.cv + 2 * CDOWN06.cv + 3 * CBOTH06.cv;

    /* station 07 */
    r_trig(&RISE07, X01);
    ton(&TONA07, X02 || TOFB06.q, 380);
    tof(&TOFA07, X10 && TONA07.q, 290);
    tp(&PULSE07, X06, 190);
    ton(&TONB07, !TONB07.q, 280);
    tof(&TOFB07, X08 || PULSE07.q, 190);
    f_trig(&FALL07, TOFA07.q);
    ctu(&CUP07, TONB07.q, CUP07.q, 4);
    ctd(&CDOWN07, FALL07.q, CDOWN07.q, 7);
    ctud(&CBOTH07, RISE07.q, X04, CUP06.q && CDOWN07.q, FALL06.q && X06, 5);
    if (TONA07.q) sum += 7;
    if (TOFA07.q && TOFA07.et > 70) sum += 2;
    if (PULSE07.q) sum += 3;
    if (PULSE07.et >= 70) sum += 4;
    if (TOFB07.q && !CBOTH07.qu) sum += 5;
    if (CBOTH07.qd) sum += 6;
    sum += CUP07.cv + 2 * CDOWN07.cv + 3 * CBOTH07.cv;

    /* station 08 */
    r_trig(&RISE08, X07);
    ton(&TONA08, !X04, 330);
    tof(&TOFA08, X09 ^ X06, 300);
    tp(&PULSE08, RISE08.q || TONA08.q, 300);
    ton(&TONB08, !TONB08.q, 110);
    tof(&TOFB08, X06 || PULSE08.q, 300);
    f_trig(&FALL08, TOFA08.q);
    ctu(&CUP08, TONB08.q, CUP08.q, 7);
    ctd(&CDOWN08, FALL08.q, CDOWN08.q, 9);
    ctud(&CBOTH08, RISE08.q, X03, CUP07.q && CDOWN08.q, FALL07.q && X08, 5);
    if (TONA08.q) sum += 8;
    if (TOFA08.q && TOFA08.et > 40) sum += 2;
    if (PULSE08.q) sum += 3;
    if (PULSE08.et >= 40) sum += 4;
    if (TOFB08.q && !CBOTH08.qu) sum += 5;
    if (CBOTH08.qd) sum += 6;
    sum += CUP08.cv + 2 * CDOWN08.cv + 3 * CBOTH08.cv;

    /* station 09 */
    r_trig(&RISE09, X14);
    ton(&TONA09, X08 && !X06, 390);
    tof(&TOFA09, TONA09.q, 270);
    tp(&PULSE09, RISE09.q, 170);
    ton(&TONB09, !TONB09.q, 70);
    tof(&TOFB09, X02 || PULSE09.q, 390);
    f_trig(&FALL09, TOFA09.q);
    ctu(&CUP09, TONB09.q, CUP09.q, 6);
    ctd(&CDOWN09, FALL09.q, CDOWN09.q, 3);
    ctud(&CBOTH09, RISE09.q, X06, CUP08.q && CDOWN09.q, FALL08.q && X13, 3);
    if (TONA09.q) sum += 9;
    if (TOFA09.q && TOFA09.et > 20) sum += 2;
    if (PULSE09.q) sum += 3;
    if (PULSE09.et >= 20) sum += 4;
    if (TOFB09.q && !CBOTH09.qu) sum += 5;
    if (CBOTH09.qd) sum += 6;
    sum += CUP09.cv + 2 * CDOWN09.cv + 3 * CBOTH09.cv;

    /* station 10 */
    r_trig(&RISE10, X09);
    ton(&TONA10, X16 || TOFB09.q, 130);
    tof(&TOFA10, X14 && TONA10.q, 20);
    tp(&PULSE10, X08, 320);
    ton(&TONB10, !TONB10.q, 250);
    tof(&TOFB10, X10 || PULSE10.q, 50);
    f_trig(&FALL10, TOFA10.q);
    ctu(&CUP10, TONB10.q, CUP10.q, 8);
    ctd(&CDOWN10, FALL10.q, CDOWN10.q, 7);
    ctud(&CBOTH10, RISE10.q, X05, CUP09.q && CDOWN10.q, FALL09.q && X08, 8);
    if (TONA10.q) sum += 10;
    if (TOFA10.q && TOFA10.et > 30) sum += 2;
    if (PULSE10.q) sum += 3;
    if (PULSE10.et >= 30) sum += 4;
    if (TOFB10.q && !CBOTH10.qu) sum += 5;
    if (CBOTH10.qd) sum += 6;
    sum += CUP10.cv + 2 * CDOWN10.cv + 3 * CBOTH10.cv;

    /* station 11 */
    r_trig(&RISE11, X07);
    ton(&TONA11, !X11, 80);
    tof(&TOFA11, X15 ^ X02, 240);
    tp(&PULSE11, RISE11.q || TONA11.q, 350);
    ton(&TONB11, !TONB11.q, 130);
    tof(&TOFB11, X02 || PULSE11.q, 140);
    f_trig(&FALL11, TOFA11.q);
    ctu(&CUP11, TONB11.q, CUP11.q, 5);
    ctd(&CDOWN11, FALL11.q, CDOWN11.q, 5);
    ctud(&CBOTH11, RISE11.q, X12, CUP10.q && CDOWN11.q, FALL10.q && X14, 8);
    if (TONA11.q) sum += 11;
    if (TOFA11.q && TOFA11.et > 10) sum += 2;
    if (PULSE11.q) sum += 3;
    if (PULSE11.et >= 10) sum += 4;
    if (TOFB11.q && !CBOTH11.qu) sum += 5;
    if (CBOTH11.qd) sum += 6;
    sum += CUP11.cv + 2 * CDOWN11.cv + 3 * CBOTH11.cv;

    /* station 12 */
    r_trig(&RISE12, X11);
    ton(&TONA12, X05 && !X12, 230);
    tof(&TOFA12, TONA12.q, 320);
    tp(&PULSE12, RISE12.q, 170);
    ton(&TONB12, !TONB12.q, 250);
    tof(&TOFB12, X04 || PULSE12.q, 270);
    f_trig(&FALL12, TOFA12.q);
    ctu(&CUP12, TONB12.q, CUP12.q, 9);
    ctd(&CDOWN12, FALL12.q, CDOWN12.q, 7);
    ctud(&CBOTH12, RISE12.q, X12, CUP11.q && CDOWN12.q, FALL11.q && X02, 2);
    if (TONA12.q) sum += 12;
    if (TOFA12.q && TOFA12.et > 70) sum += 2;
    if (PULSE12.q) sum += 3;
    if (PULSE12.et >= 70) sum += 4;
    if (TOFB12.q && !CBOTH12.qu) sum += 5;
    if (CBOTH12.qd) sum += 6;
    sum += CUP12.cv + 2 * CDOWN12.cv + 3 * CBOTH12.cv;

    /* station 13 */
    r_trig(&RISE13, X04);
    ton(&TONA13, X10 || TOFB12.q, 320);
    tof(&TOFA13, X02 && TONA13.q, 220);
    tp(&PULSE13, X08, 200);
    ton(&TONB13, !TONB13.q, 160);
    tof(&TOFB13, X11 || PULSE13.q, 80);
    f_trig(&FALL13, TOFA13.q);
    ctu(&CUP13, TONB13.q, CUP13.q, 3);
    ctd(&CDOWN13, FALL13.q, CDOWN13.q, 7);
    ctud(&CBOTH13, RISE13.q, X16, CUP12.q && CDOWN13.q, FALL12.q && X08, 7);
    if (TONA13.q) sum += 13;
    if (TOFA13.q && TOFA13.et > 80) sum += 2;
    if (PULSE13.q) sum += 3;
    if (PULSE13.et >= 80) sum += 4;
    if (TOFB13.q && !CBOTH13.qu) sum += 5;
    if (CBOTH13.qd) sum += 6;
    sum += CUP13.cv + 2 * CDOWN13.cv + 3 * CBOTH13.cv;

    /* station 14 */
    r_trig(&RISE14, X08);
    ton(&TONA14, !X15, 60);
    tof(&TOFA14, X14 ^ X12, 340);
    tp(&PULSE14, RISE14.q || TONA14.q, 30);
    ton(&TONB14, !TONB14.q, 260);
    tof(&TOFB14, X12 || PULSE14.q, 390);
    f_trig(&FALL14, TOFA14.q);
    ctu(&CUP14, TONB14.q, CUP14.q, 4);
    ctd(&CDOWN14, FALL14.q, CDOWN14.q, 3);
    ctud(&CBOTH14, RISE14.q, X10, CUP13.q && CDOWN14.q, FALL13.q && X13, 4);
    if (TONA14.q) sum += 14;
    if (TOFA14.q && TOFA14.et > 80) sum += 2;
    if (PULSE14.q) sum += 3;
    if (PULSE14.et >= 80) sum += 4;
    if (TOFB14.q && !CBOTH14.qu) sum += 5;
    if (CBOTH14.qd) sum += 6;
    sum += CUP14.cv + 2 * CDOWN14.cv + 3 * CBOTH14.cv;

    /* station 15 */
    r_trig(&RISE15, X01);
    ton(&TONA15, X11 && !X07, 280);
    tof(&TOFA15, TONA15.q, 220);
    tp(&PULSE15, RISE15.q, 70);
    ton(&TONB15, !TONB15.q, 130);
    tof(&TOFB15, X06 || PULSE15.q, 40);
    f_trig(&FALL15, TOFA15.q);
    ctu(&CUP15, TONB15.q, CUP15.q, 7);
    ctd(&CDOWN15, FALL15.q, CDOWN15.q, 7);
    ctud(&CBOTH15, RISE15.q, X07, CUP14.q && CDOWN15.q, FALL14.q && X15, 6);
    if (TONA15.q) sum += 15;
    if (TOFA15.q && TOFA15.et > 50) sum += 2;
    if (PULSE15.q) sum += 3;
    if (PULSE15.et >= 50) sum += 4;
    if (TOFB15.q && !CBOTH15.qu) sum += 5;
    if (CBOTH15.qd) sum += 6;
    sum += CUP15.cv + 2 * CDOWN15.cv + 3 * CBOTH15.cv;

    /* station 16 */
    r_trig(&RISE16, X08);
    ton(&TONA16, X13 || TOFB15.q, 120);
    tof(&TOFA16, X09 && TONA16.q, 370);
    tp(&PULSE16, X15, 120);
    ton(&TONB16, !TONB16.q, 370);
    tof(&TOFB16, X06 || PULSE16.q, 120);
    f_trig(&FALL16, TOFA16.q);
    ctu(&CUP16, TONB16.q, CUP16.q, 4);
    ctd(&CDOWN16, FALL16.q, CDOWN16.q, 4);
    ctud(&CBOTH16, RISE16.q, X02, CUP15.q && CDOWN16.q, FALL15.q && X15, 3);
    if (TONA16.q) sum += 16;
    if (TOFA16.q && TOFA16.et > 50) sum += 2;
    if (PULSE16.q) sum += 3;
    if (PULSE16.et >= 50) sum += 4;
    if (TOFB16.q && !CBOTH16.qu) sum += 5;
    if (CBOTH16.qd) sum += 6;
    sum += CUP16.cv + 2 * CDOWN16.cv + 3 * CBOTH16.cv;

    /* station 17 */
    r_trig(&RISE17, X06);
    ton(&TONA17, !X04, 290);
    tof(&TOFA17, X16 ^ X14, 280);
    tp(&PULSE17, RISE17.q || TONA17.q, 310);
    ton(&TONB17, !TONB17.q, 100);
    tof(&TOFB17, X14 || PULSE17.q, 90);
    f_trig(&FALL17, TOFA17.q);
    ctu(&CUP17, TONB17.q, CUP17.q, 3);
    ctd(&CDOWN17, FALL17.q, CDOWN17.q, 2);
    ctud(&CBOTH17, RISE17.q, X02, CUP16.q && CDOWN17.q, FALL16.q && X15, 2);
    if (TONA17.q) sum += 17;
    if (TOFA17.q && TOFA17.et > 80) sum += 2;
    if (PULSE17.q) sum += 3;
    if (PULSE17.et >= 80) sum += 4;
    if (TOFB17.q && !CBOTH17.qu) sum += 5;
    if (CBOTH17.qd) sum += 6;
    sum += CUP17.cv + 2 * CDOWN17.cv + 3 * CBOTH17.cv;

    /* station 18 */
    r_trig(&RISE18, X10);
    ton(&TONA18, X08 && !X16, 230);
    tof(&TOFA18, TONA18.q, 300);
    tp(&PULSE18, RISE18.q, 120);
    ton(&TONB18, !TONB18.q, 360);
    tof(&TOFB18, X14 || PULSE18.q, 60);
    f_trig(&FALL18, TOFA18.q);
    ctu(&CUP18, TONB18.q, CUP18.q, 9);
    ctd(&CDOWN18, FALL18.q, CDOWN18.q, 6);
    ctud(&CBOTH18, RISE18.q, X16, CUP17.q && CDOWN18.q, FALL17.q && X12, 4);
    if (TONA18.q) sum += 18;
    if (TOFA18.q && TOFA18.et > 30) sum += 2;
    if (PULSE18.q) sum += 3;
    if (PULSE18.et >= 30) sum += 4;
    if (TOFB18.q && !CBOTH18.qu) sum += 5;
    if (CBOTH18.qd) sum += 6;
    sum += CUP18.cv + 2 * CDOWN18.cv + 3 * CBOTH18.cv;

    /* station 19 */
    r_trig(&RISE19, X10);
    ton(&TONA19, X15 || TOFB18.q, 360);
    tof(&TOFA19, X14 && TONA19.q, 230);
    tp(&PULSE19, X12, 330);
    ton(&TONB19, !TONB19.q, 200);
    tof(&TOFB19, X13 || PULSE19.q, 210);
    f_trig(&FALL19, TOFA19.q);
    ctu(&CUP19, TONB19.q, CUP19.q, 9);
    ctd(&CDOWN19, FALL19.q, CDOWN19.q, 5);
    ctud(&CBOTH19, RISE19.q, X06, CUP18.q && CDOWN19.q, FALL18.q && X12, 8);
    if (TONA19.q) sum += 19;
    if (TOFA19.q && TOFA19.et > 30) sum += 2;
    if (PULSE19.q) sum += 3;
    if (PULSE19.et >= 30) sum += 4;
    if (TOFB19.q && !CBOTH19.qu) sum += 5;
    if (CBOTH19.qd) sum += 6;
    sum += CUP19.cv + 2 * CDOWN19.cv + 3 * CBOTH19.cv;

    /* station 20 */
    r_trig(&RISE20, X09);
    ton(&TONA20, !X14, 50);
    tof(&TOFA20, X10 ^ X03, 80);
    tp(&PULSE20, RISE20.q || TONA20.q, 310);
    ton(&TONB20, !TONB20.q, 400);
    tof(&TOFB20, X03 || PULSE20.q, 130);
    f_trig(&FALL20, TOFA20.q);
    ctu(&CUP20, TONB20.q, CUP20.q, 3);
    ctd(&CDOWN20, FALL20.q, CDOWN20.q, 4);
    ctud(&CBOTH20, RISE20.q, X02, CUP19.q && CDOWN20.q, FALL19.q && X01, 4);
    if (TONA20.q) sum += 20;
    if (TOFA20.q && TOFA20.et > 20) sum += 2;
    if (PULSE20.q) sum += 3;
    if (PULSE20.et >= 20) sum += 4;
    if (TOFB20.q && !CBOTH20.qu) sum += 5;
    if (CBOTH20.qd) sum += 6;
    sum += CUP20.cv + 2 * CDOWN20.cv + 3 * CBOTH20.cv;

    /* station 21 */
    r_trig(&RISE21, X01);
    ton(&TONA21, X03 && !X04, 270);
    tof(&TOFA21, TONA21.q, 270);
    tp(&PULSE21, RISE21.q, 60);
    ton(&TONB21, !TONB21.q, 370);
    tof(&TOFB21, X12 || PULSE21.q, 100);
    f_trig(&FALL21, TOFA21.q);
    ctu(&CUP21, TONB21.q, CUP21.q, 5);
    ctd(&CDOWN21, FALL21.q, CDOWN21.q, 8);
    ctud(&CBOTH21, RISE21.q, X04, CUP20.q && CDOWN21.q, FALL20.q && X02, 9);
    if (TONA21.q) sum += 21;
    if (TOFA21.q && TOFA21.et > 70) sum += 2;
    if (PULSE21.q) sum += 3;
    if (PULSE21.et >= 70) sum += 4;
    if (TOFB21.q && !CBOTH21.qu) sum += 5;
    if (CBOTH21.qd) sum += 6;
    sum += CUP21.cv + 2 * CDOWN21.cv + 3 * CBOTH21.cv;

    /* station 22 */
    r_trig(&RISE22, X09);
    ton(&TONA22, X14 || TOFB21.q, 60);
    tof(&TOFA22, X04 && TONA22.q, 400);
    tp(&PULSE22, X10, 250);
    ton(&TONB22, !TONB22.q, 280);
    tof(&TOFB22, X02 || PULSE22.q, 200);
    f_trig(&FALL22, TOFA22.q);
    ctu(&CUP22, TONB22.q, CUP22.q, 7);
    ctd(&CDOWN22, FALL22.q, CDOWN22.q, 4);
    ctud(&CBOTH22, RISE22.q, X13, CUP21.q && CDOWN22.q, FALL21.q && X10, 4);
    if (TONA22.q) sum += 22;
    if (TOFA22.q && TOFA22.et > 10) sum += 2;
    if (PULSE22.q) sum += 3;
    if (PULSE22.et >= 10) sum += 4;
    if (TOFB22.q && !CBOTH22.qu) sum += 5;
    if (CBOTH22.qd) sum += 6;
    sum += CUP22.cv + 2 * CDOWN22.cv + 3 * CBOTH22.cv;

    /* station 23 */
    r_trig(&RISE23, X16);
    ton(&TONA23, !X12, 330);
    tof(&TOFA23, X10 ^ X11, 310);
    tp(&PULSE23, RISE23.q || TONA23.q, 30);
    ton(&TONB23, !TONB23.q, 220);
    tof(&TOFB23, X11 || PULSE23.q, 50);
    f_trig(&FALL23, TOFA23.q);
    ctu(&CUP23, TONB23.q, CUP23.q, 7);
    ctd(&CDOWN23, FALL23.q, CDOWN23.q, 5);
    ctud(&CBOTH23, RISE23.q, X06, CUP22.q && CDOWN23.q, FALL22.q && X15, 9);
    if (TONA23.q) sum += 23;
    if (TOFA23.q && TOFA23.et > 80) sum += 2;
    if (PULSE23.q) sum += 3;
    if (PULSE23.et >= 80) sum += 4;
    if (TOFB23.q && !CBOTH23.qu) sum += 5;
    if (CBOTH23.qd) sum += 6;
    sum += CUP23.cv + 2 * CDOWN23.cv + 3 * CBOTH23.cv;

    /* station 24 */
    r_trig(&RISE24, X09);
    ton(&TONA24, X14 && !X05, 30);
    tof(&TOFA24, TONA24.q, 140);
    tp(&PULSE24, RISE24.q, 230);
    ton(&TONB24, !TONB24.q, 280);
    tof(&TOFB24, X12 || PULSE24.q, 90);
    f_trig(&FALL24, TOFA24.q);
    ctu(&CUP24, TONB24.q, CUP24.q, 3);
    ctd(&CDOWN24, FALL24.q, CDOWN24.q, 2);
    ctud(&CBOTH24, RISE24.q, X05, CUP23.q && CDOWN24.q, FALL23.q && X04, 3);
    if (TONA24.q) sum += 24;
    if (TOFA24.q && TOFA24.et > 60) sum += 2;
    if (PULSE24.q) sum += 3;
    if (PULSE24.et >= 60) sum += 4;
    if (TOFB24.q && !CBOTH24.qu) sum += 5;
    if (CBOTH24.qd) sum += 6;
    sum += CUP24.cv + 2 * CDOWN24.cv + 3 * CBOTH24.cv;

    /* station 25 */
    r_trig(&RISE25, X14);
    ton(&TONA25, X10 || TOFB24.q, 50);
    tof(&TOFA25, X11 && TONA25.q, 200);
    tp(&PULSE25, X12, 200);
    ton(&TONB25, !TONB25.q, 20);
    tof(&TOFB25, X05 || PULSE25.q, 400);
    f_trig(&FALL25, TOFA25.q);
    ctu(&CUP25, TONB25.q, CUP25.q, 7);
    ctd(&CDOWN25, FALL25.q, CDOWN25.q, 7);
    ctud(&CBOTH25, RISE25.q, X04, CUP24.q && CDOWN25.q, FALL24.q && X12, 9);
    if (TONA25.q) sum += 25;
    if (TOFA25.q && TOFA25.et > 40) sum += 2;
    if (PULSE25.q) sum += 3;
    if (PULSE25.et >= 40) sum += 4;
    if (TOFB25.q && !CBOTH25.qu) sum += 5;
    if (CBOTH25.qd) sum += 6;
    sum += CUP25.cv + 2 * CDOWN25.cv + 3 * CBOTH25.cv;

    /* station 26 */
    r_trig(&RISE26, X14);
    ton(&TONA26, !X03, 360);
    tof(&TOFA26, X08 ^ X15, 150);
    tp(&PULSE26, RISE26.q || TONA26.q, 330);
    ton(&TONB26, !TONB26.q, 70);
    tof(&TOFB26, X15 || PULSE26.q, 350);
    f_trig(&FALL26, TOFA26.q);
    ctu(&CUP26, TONB26.q, CUP26.q, 6);
    ctd(&CDOWN26, FALL26.q, CDOWN26.q, 8);
    ctud(&CBOTH26, RISE26.q, X09, CUP25.q && CDOWN26.q, FALL25.q && X11, 2);
    if (TONA26.q) sum += 26;
    if (TOFA26.q && TOFA26.et > 20) sum += 2;
    if (PULSE26.q) sum += 3;
    if (PULSE26.et >= 20) sum += 4;
    if (TOFB26.q && !CBOTH26.qu) sum += 5;
    if (CBOTH26.qd) sum += 6;
    sum += CUP26.cv + 2 * CDOWN26.cv + 3 * CBOTH26.cv;

    /* station 27 */
    r_trig(&RISE27, X08);
    ton(&TONA27, X10 && !X14, 290);
    tof(&TOFA27, TONA27.q, 80);
    tp(&PULSE27, RISE27.q, 130);
    ton(&TONB27, !TONB27.q, 220);
    tof(&TOFB27, X09 || PULSE27.q, 290);
    f_trig(&FALL27, TOFA27.q);
    ctu(&CUP27, TONB27.q, CUP27.q, 3);
    ctd(&CDOWN27, FALL27.q, CDOWN27.q, 7);
    ctud(&CBOTH27, RISE27.q, X14, CUP26.q && CDOWN27.q, FALL26.q && X03, 8);
    if (TONA27.q) sum += 27;
    if (TOFA27.q && TOFA27.et > 80) sum += 2;
    if (PULSE27.q) sum += 3;
    if (PULSE27.et >= 80) sum += 4;
    if (TOFB27.q && !CBOTH27.qu) sum += 5;
    if (CBOTH27.qd) sum += 6;
    sum += CUP27.cv + 2 * CDOWN27.cv + 3 * CBOTH27.cv;

    /* station 28 */
    r_trig(&RISE28, X07);
    ton(&TONA28, X04 || TOFB27.q, 400);
    tof(&TOFA28, X14 && TONA28.q, 340);
    tp(&PULSE28, X12, 60);
    ton(&TONB28, !TONB28.q, 70);
    tof(&TOFB28, X08 || PULSE28.q, 120);
    f_trig(&FALL28, TOFA28.q);
    ctu(&CUP28, TONB28.q, CUP28.q, 3);
    ctd(&CDOWN28, FALL28.q, CDOWN28.q, 3);
    ctud(&CBOTH28, RISE28.q, X11, CUP27.q && CDOWN28.q, FALL27.q && X12, 3);
    if (TONA28.q) sum += 28;
    if (TOFA28.q && TOFA28.et > 10) sum += 2;
    if (PULSE28.q) sum += 3;
    if (PULSE28.et >= 10) sum += 4;
    if (TOFB28.q && !CBOTH28.qu) sum += 5;
    if (CBOTH28.qd) sum += 6;
    sum += CUP28.cv + 2 * CDOWN28.cv + 3 * CBOTH28.cv;

    /* station 29 */
    r_trig(&RISE29, X01);
    ton(&TONA29, !X09, 190);
    tof(&TOFA29, X16 ^ X13, 130);
    tp(&PULSE29, RISE29.q || TONA29.q, 300);
    ton(&TONB29, !TONB29.q, 270);
    tof(&TOFB29, X13 || PULSE29.q, 320);
    f_trig(&FALL29, TOFA29.q);
    ctu(&CUP29, TONB29.q, CUP29.q, 3);
    ctd(&CDOWN29, FALL29.q, CDOWN29.q, 9);
    ctud(&CBOTH29, RISE29.q, X10, CUP28.q && CDOWN29.q, FALL28.q && X04, 8);
    if (TONA29.q) sum += 29;
    if (TOFA29.q && TOFA29.et > 10) sum += 2;
    if (PULSE29.q) sum += 3;
    if (PULSE29.et >= 10) sum += 4;
    if (TOFB29.q && !CBOTH29.qu) sum += 5;
    if (CBOTH29.qd) sum += 6;
    sum += CUP29.cv + 2 * CDOWN29.cv + 3 * CBOTH29.cv;

    /* station 30 */
    r_trig(&RISE30, X01);
    ton(&TONA30, X03 && !X04, 270);
    tof(&TOFA30, TONA30.q, 250);
    tp(&PULSE30, RISE30.q, 350);
    ton(&TONB30, !TONB30.q, 380);
    tof(&TOFB30, X08 || PULSE30.q, 250);
    f_trig(&FALL30, TOFA30.q);
    ctu(&CUP30, TONB30.q, CUP30.q, 5);
    ctd(&CDOWN30, FALL30.q, CDOWN30.q, 2);
    ctud(&CBOTH30, RISE30.q, X04, CUP29.q && CDOWN30.q, FALL29.q && X09, 5);
    if (TONA30.q) sum += 30;
    if (TOFA30.q && TOFA30.et > 80) sum += 2;
    if (PULSE30.q) sum += 3;
    if (PULSE30.et >= 80) sum += 4;
    if (TOFB30.q && !CBOTH30.qu) sum += 5;
    if (CBOTH30.qd) sum += 6;
    sum += CUP30.cv + 2 * CDOWN30.cv + 3 * CBOTH30.cv;

    /* station 31 */
    r_trig(&RISE31, X16);
    ton(&TONA31, X05 || TOFB30.q, 40);
    tof(&TOFA31, X07 && TONA31.q, 400);
    tp(&PULSE31, X06, 30);
    ton(&TONB31, !TONB31.q, 90);
    tof(&TOFB31, X11 || PULSE31.q, 300);
    f_trig(&FALL31, TOFA31.q);
    ctu(&CUP31, TONB31.q, CUP31.q, 2);
    ctd(&CDOWN31, FALL31.q, CDOWN31.q, 9);
    ctud(&CBOTH31, RISE31.q, X10, CUP30.q && CDOWN31.q, FALL30.q && X06, 7);
    if (TONA31.q) sum += 31;
    if (TOFA31.q && TOFA31.et > 60) sum += 2;
    if (PULSE31.q) sum += 3;
    if (PULSE31.et >= 60) sum += 4;
    if (TOFB31.q && !CBOTH31.qu) sum += 5;
    if (CBOTH31.qd) sum += 6;
    sum += CUP31.cv + 2 * CDOWN31.cv + 3 * CBOTH31.cv;

    /* station 32 */
    r_trig(&RISE32, X05);
    ton(&TONA32, !X13, 170);
    tof(&TOFA32, X15 ^ X09, 180);
    tp(&PULSE32, RISE32.q || TONA32.q, 390);
    ton(&TONB32, !TONB32.q, 240);
    tof(&TOFB32, X09 || PULSE32.q, 30);
    f_trig(&FALL32, TOFA32.q);
    ctu(&CUP32, TONB32.q, CUP32.q, 6);
    ctd(&CDOWN32, FALL32.q, CDOWN32.q, 8);
    ctud(&CBOTH32, RISE32.q, X11, CUP31.q && CDOWN32.q, FALL31.q && X10, 4);
    if (TONA32.q) sum += 32;
    if (TOFA32.q && TOFA32.et > 10) sum += 2;
    if (PULSE32.q) sum += 3;
    if (PULSE32.et >= 10) sum += 4;
    if (TOFB32.q && !CBOTH32.qu) sum += 5;
    if (CBOTH32.qd) sum += 6;
    sum += CUP32.cv + 2 * CDOWN32.cv + 3 * CBOTH32.cv;

    /* station 33 */
    r_trig(&RISE33, X13);
    ton(&TONA33, X05 && !X03, 270);
    tof(&TOFA33, TONA33.q, 170);
    tp(&PULSE33, RISE33.q, 180);
    ton(&TONB33, !TONB33.q, 210);
    tof(&TOFB33, X12 || PULSE33.q, 200);
    f_trig(&FALL33, TOFA33.q);
    ctu(&CUP33, TONB33.q, CUP33.q, 6);
    ctd(&CDOWN33, FALL33.q, CDOWN33.q, 3);
    ctud(&CBOTH33, RISE33.q, X03, CUP32.q && CDOWN33.q, FALL32.q && X16, 4);
    if (TONA33.q) sum += 33;
    if (TOFA33.q && TOFA33.et > 40) sum += 2;
    if (PULSE33.q) sum += 3;
    if (PULSE33.et >= 40) sum += 4;
    if (TOFB33.q && !CBOTH33.qu) sum += 5;
    if (CBOTH33.qd) sum += 6;
    sum += CUP33.cv + 2 * CDOWN33.cv + 3 * CBOTH33.cv;

    /* station 34 */
    r_trig(&RISE34, X01);
    ton(&TONA34, X16 || TOFB33.q, 270);
    tof(&TOFA34, X15 && TONA34.q, 80);
    tp(&PULSE34, X12, 330);
    ton(&TONB34, !TONB34.q, 310);
    tof(&TOFB34, X06 || PULSE34.q, 230);
    f_trig(&FALL34, TOFA34.q);
    ctu(&CUP34, TONB34.q, CUP34.q, 8);
    ctd(&CDOWN34, FALL34.q, CDOWN34.q, 9);
    ctud(&CBOTH34, RISE34.q, X07, CUP33.q && CDOWN34.q, FALL33.q && X12, 5);
    if (TONA34.q) sum += 34;
    if (TOFA34.q && TOFA34.et > 50) sum += 2;
    if (PULSE34.q) sum += 3;
    if (PULSE34.et >= 50) sum += 4;
    if (TOFB34.q && !CBOTH34.qu) sum += 5;
    if (CBOTH34.qd) sum += 6;
    sum += CUP34.cv + 2 * CDOWN34.cv + 3 * CBOTH34.cv;

    /* station 35 */
    r_trig(&RISE35, X01);
    ton(&TONA35, !X08, 380);
    tof(&TOFA35, X02 ^ X07, 20);
    tp(&PULSE35, RISE35.q || TONA35.q, 50);
    ton(&TONB35, !TONB35.q, 70);
    tof(&TOFB35, X07 || PULSE35.q, 60);
    f_trig(&FALL35, TOFA35.q);
    ctu(&CUP35, TONB35.q, CUP35.q, 6);
    ctd(&CDOWN35, FALL35.q, CDOWN35.q, 5);
    ctud(&CBOTH35, RISE35.q, X15, CUP34.q && CDOWN35.q, FALL34.q && X16, 8);
    if (TONA35.q) sum += 35;
    if (TOFA35.q && TOFA35.et > 30) sum += 2;
    if (PULSE35.q) sum += 3;
    if (PULSE35.et >= 30) sum += 4;
    if (TOFB35.q && !CBOTH35.qu) sum += 5;
    if (CBOTH35.qd) sum += 6;
    sum += CUP35.cv + 2 * CDOWN35.cv + 3 * CBOTH35.cv;

    /* station 36 */
    r_trig(&RISE36, X05);
    ton(&TONA36, X08 && !X11, 120);
    tof(&TOFA36, TONA36.q, 20);
    tp(&PULSE36, RISE36.q, 230);
    ton(&TONB36, !TONB36.q, 360);
    tof(&TOFB36, X06 || PULSE36.q, 360);
    f_trig(&FALL36, TOFA36.q);
    ctu(&CUP36, TONB36.q, CUP36.q, 7);
    ctd(&CDOWN36, FALL36.q, CDOWN36.q, 8);
    ctud(&CBOTH36, RISE36.q, X11, CUP35.q && CDOWN36.q, FALL35.q && X03, 9);
    if (TONA36.q) sum += 36;
    if (TOFA36.q && TOFA36.et > 50) sum += 2;
    if (PULSE36.q) sum += 3;
    if (PULSE36.et >= 50) sum += 4;
    if (TOFB36.q && !CBOTH36.qu) sum += 5;
    if (CBOTH36.qd) sum += 6;
    sum += CUP36.cv + 2 * CDOWN36.cv + 3 * CBOTH36.cv;

    /* station 37 */
    r_trig(&RISE37, X09);
    ton(&TONA37, X12 || TOFB36.q, 220);
    tof(&TOFA37, X03 && TONA37.q, 90);
    tp(&PULSE37, X04, 160);
    ton(&TONB37, !TONB37.q, 80);
    tof(&TOFB37, X06 || PULSE37.q, 60);
    f_trig(&FALL37, TOFA37.q);
    ctu(&CUP37, TONB37.q, CUP37.q, 3);
    ctd(&CDOWN37, FALL37.q, CDOWN37.q, 5);
    ctud(&CBOTH37, RISE37.q, X07, CUP36.q && CDOWN37.q, FALL36.q && X04, 4);
    if (TONA37.q) sum += 37;
    if (TOFA37.q && TOFA37.et > 30) sum += 2;
    if (PULSE37.q) sum += 3;
    if (PULSE37.et >= 30) sum += 4;
    if (TOFB37.q && !CBOTH37.qu) sum += 5;
    if (CBOTH37.qd) sum += 6;
    sum += CUP37.cv + 2 * CDOWN37.cv + 3 * CBOTH37.cv;

    /* station 38 */
    r_trig(&RISE38, X15);
    ton(&TONA38, !X11, 360);
    tof(&TOFA38, X03 ^ X10, 310);
    tp(&PULSE38, RISE38.q || TONA38.q, 380);
    ton(&TONB38, !TONB38.q, 60);
    tof(&TOFB38, X10 || PULSE38.q, 70);
    f_trig(&FALL38, TOFA38.q);
    ctu(&CUP38, TONB38.q, CUP38.q, 2);
    ctd(&CDOWN38, FALL38.q, CDOWN38.q, 4);
    ctud(&CBOTH38, RISE38.q, X06, CUP37.q && CDOWN38.q, FALL37.q && X16, 4);
    if (TONA38.q) sum += 38;
    if (TOFA38.q && TOFA38.et > 50) sum += 2;
    if (PULSE38.q) sum += 3;
    if (PULSE38.et >= 50) sum += 4;
    if (TOFB38.q && !CBOTH38.qu) sum += 5;
    if (CBOTH38.qd) sum += 6;
    sum += CUP38.cv + 2 * CDOWN38.cv + 3 * CBOTH38.cv;

    /* station 39 */
    r_trig(&RISE39, X06);
    ton(&TONA39, X01 && !X07, 80);
    tof(&TOFA39, TONA39.q, 290);
    tp(&PULSE39, RISE39.q, 50);
    ton(&TONB39, !TONB39.q, 360);
    tof(&TOFB39, X14 || PULSE39.q, 230);
    f_trig(&FALL39, TOFA39.q);
    ctu(&CUP39, TONB39.q, CUP39.q, 8);
    ctd(&CDOWN39, FALL39.q, CDOWN39.q, 2);
    ctud(&CBOTH39, RISE39.q, X07, CUP38.q && CDOWN39.q, FALL38.q && X15, 9);
    if (TONA39.q) sum += 39;
    if (TOFA39.q && TOFA39.et > 10) sum += 2;
    if (PULSE39.q) sum += 3;
    if (PULSE39.et >= 10) sum += 4;
    if (TOFB39.q && !CBOTH39.qu) sum += 5;
    if (CBOTH39.qd) sum += 6;
    sum += CUP39.cv + 2 * CDOWN39.cv + 3 * CBOTH39.cv;

    /* station 40 */
    r_trig(&RISE40, X08);
    ton(&TONA40, X07 || TOFB39.q, 160);
    tof(&TOFA40, X15 && TONA40.q, 140);
    tp(&PULSE40, X04, 220);
    ton(&TONB40, !TONB40.q, 370);
    tof(&TOFB40, X03 || PULSE40.q, 240);
    f_trig(&FALL40, TOFA40.q);
    ctu(&CUP40, TONB40.q, CUP40.q, 3);
    ctd(&CDOWN40, FALL40.q, CDOWN40.q, 4);
    ctud(&CBOTH40, RISE40.q, X06, CUP39.q && CDOWN40.q, FALL39.q && X04, 8);
    if (TONA40.q) sum += 40;
    if (TOFA40.q && TOFA40.et > 10) sum += 2;
    if (PULSE40.q) sum += 3;
    if (PULSE40.et >= 10) sum += 4;
    if (TOFB40.q && !CBOTH40.qu) sum += 5;
    if (CBOTH40.qd) sum += 6;
    sum += CUP40.cv + 2 * CDOWN40.cv + 3 * CBOTH40.cv;

    /* station 41 */
    r_trig(&RISE41, X02);
    ton(&TONA41, !X11, 150);
    tof(&TOFA41, X04 ^ X16, 400);
    tp(&PULSE41, RISE41.q || TONA41.q, 150);
    ton(&TONB41, !TONB41.q, 340);
    tof(&TOFB41, X16 || PULSE41.q, 190);
    f_trig(&FALL41, TOFA41.q);
    ctu(&CUP41, TONB41.q, CUP41.q, 3);
    ctd(&CDOWN41, FALL41.q, CDOWN41.q, 9);
    ctud(&CBOTH41, RISE41.q, X15, CUP40.q && CDOWN41.q, FALL40.q && X14, 5);
    if (TONA41.q) sum += 41;
    if (TOFA41.q && TOFA41.et > 20) sum += 2;
    if (PULSE41.q) sum += 3;
    if (PULSE41.et >= 20) sum += 4;
    if (TOFB41.q && !CBOTH41.qu) sum += 5;
    if (CBOTH41.qd) sum += 6;
    sum += CUP41.cv + 2 * CDOWN41.cv + 3 * CBOTH41.cv;

    /* station 42 */
    r_trig(&RISE42, X02);
    ton(&TONA42, X06 && !X08, 250);
    tof(&TOFA42, TONA42.q, 160);
    tp(&PULSE42, RISE42.q, 20);
    ton(&TONB42, !TONB42.q, 110);
    tof(&TOFB42, X11 || PULSE42.q, 80);
    f_trig(&FALL42, TOFA42.q);
    ctu(&CUP42, TONB42.q, CUP42.q, 9);
    ctd(&CDOWN42, FALL42.q, CDOWN42.q, 9);
    ctud(&CBOTH42, RISE42.q, X08, CUP41.q && CDOWN42.q, FALL41.q && X07, 4);
    if (TONA42.q) sum += 42;
    if (TOFA42.q && TOFA42.et > 80) sum += 2;
    if (PULSE42.q) sum += 3;
    if (PULSE42.et >= 80) sum += 4;
    if (TOFB42.q && !CBOTH42.qu) sum += 5;
    if (CBOTH42.qd) sum += 6;
    sum += CUP42.cv + 2 * CDOWN42.cv + 3 * CBOTH42.cv;

    /* station 43 */
    r_trig(&RISE43, X03);
    ton(&TONA43, X15 || TOFB42.q, 130);
    tof(&TOFA43, X14 && TONA43.q, 360);
    tp(&PULSE43, X02, 70);
    ton(&TONB43, !TONB43.q, 90);
    tof(&TOFB43, X13 || PULSE43.q, 250);
    f_trig(&FALL43, TOFA43.q);
    ctu(&CUP43, TONB43.q, CUP43.q, 5);
    ctd(&CDOWN43, FALL43.q, CDOWN43.q, 4);
    ctud(&CBOTH43, RISE43.q, X07, CUP42.q && CDOWN43.q, FALL42.q && X02, 6);
    if (TONA43.q) sum += 43;
    if (TOFA43.q && TOFA43.et > 80) sum += 2;
    if (PULSE43.q) sum += 3;
    if (PULSE43.et >= 80) sum += 4;
    if (TOFB43.q && !CBOTH43.qu) sum += 5;
    if (CBOTH43.qd) sum += 6;
    sum += CUP43.cv + 2 * CDOWN43.cv + 3 * CBOTH43.cv;

    /* station 44 */
    r_trig(&RISE44, X07);
    ton(&TONA44, !X01, 80);
    tof(&TOFA44, X11 ^ X12, 190);
    tp(&PULSE44, RISE44.q || TONA44.q, 120);
    ton(&TONB44, !TONB44.q, 360);
    tof(&TOFB44, X12 || PULSE44.q, 360);
    f_trig(&FALL44, TOFA44.q);
    ctu(&CUP44, TONB44.q, CUP44.q, 5);
    ctd(&CDOWN44, FALL44.q, CDOWN44.q, 7);
    ctud(&CBOTH44, RISE44.q, X14, CUP43.q && CDOWN44.q, FALL43.q && X10, 4);
    if (TONA44.q) sum += 44;
    if (TOFA44.q && TOFA44.et > 40) sum += 2;
    if (PULSE44.q) sum += 3;
    if (PULSE44.et >= 40) sum += 4;
    if (TOFB44.q && !CBOTH44.qu) sum += 5;
    if (CBOTH44.qd) sum += 6;
    sum += CUP44.cv + 2 * CDOWN44.cv + 3 * CBOTH44.cv;

    /* station 45 */
    r_trig(&RISE45, X09);
    ton(&TONA45, X03 && !X05, 380);
    tof(&TOFA45, TONA45.q, 310);
    tp(&PULSE45, RISE45.q, 160);
    ton(&TONB45, !TONB45.q, 70);
    tof(&TOFB45, X14 || PULSE45.q, 180);
    f_trig(&FALL45, TOFA45.q);
    ctu(&CUP45, TONB45.q, CUP45.q, 3);
    ctd(&CDOWN45, FALL45.q, CDOWN45.q, 9);
    ctud(&CBOTH45, RISE45.q, X05, CUP44.q && CDOWN45.q, FALL44.q && X02, 7);
    if (TONA45.q) sum += 45;
    if (TOFA45.q && TOFA45.et > 70) sum += 2;
    if (PULSE45.q) sum += 3;
    if (PULSE45.et >= 70) sum += 4;
    if (TOFB45.q && !CBOTH45.qu) sum += 5;
    if (CBOTH45.qd) sum += 6;
    sum += CUP45.cv + 2 * CDOWN45.cv + 3 * CBOTH45.cv;

    /* station 46 */
    r_trig(&RISE46, X16);
    ton(&TONA46, X09 || TOFB45.q, 270);
    tof(&TOFA46, X05 && TONA46.q, 80);
    tp(&PULSE46, X08, 240);
    ton(&TONB46, !TONB46.q, 180);
    tof(&TOFB46, X03 || PULSE46.q, 80);
    f_trig(&FALL46, TOFA46.q);
    ctu(&CUP46, TONB46.q, CUP46.q, 2);
    ctd(&CDOWN46, FALL46.q, CDOWN46.q, 7);
    ctud(&CBOTH46, RISE46.q, X15, CUP45.q && CDOWN46.q, FALL45.q && X08, 3);
    if (TONA46.q) sum += 46;
    if (TOFA46.q && TOFA46.et > 20) sum += 2;
    if (PULSE46.q) sum += 3;
    if (PULSE46.et >= 20) sum += 4;
    if (TOFB46.q && !CBOTH46.qu) sum += 5;
    if (CBOTH46.qd) sum += 6;
    sum += CUP46.cv + 2 * CDOWN46.cv + 3 * CBOTH46.cv;

    /* station 47 */
    r_trig(&RISE47, X08);
    ton(&TONA47, !X05, 380);
    tof(&TOFA47, X07 ^ X14, 140);
    tp(&PULSE47, RISE47.q || TONA47.q, 230);
    ton(&TONB47, !TONB47.q, 100);
    tof(&TOFB47, X14 || PULSE47.q, 240);
    f_trig(&FALL47, TOFA47.q);
    ctu(&CUP47, TONB47.q, CUP47.q, 6);
    ctd(&CDOWN47, FALL47.q, CDOWN47.q, 7);
    ctud(&CBOTH47, RISE47.q, X15, CUP46.q && CDOWN47.q, FALL46.q && X13, 2);
    if (TONA47.q) sum += 47;
    if (TOFA47.q && TOFA47.et > 40) sum += 2;
    if (PULSE47.q) sum += 3;
    if (PULSE47.et >= 40) sum += 4;
    if (TOFB47.q && !CBOTH47.qu) sum += 5;
    if (CBOTH47.qd) sum += 6;
    sum += CUP47.cv + 2 * CDOWN47.cv + 3 * CBOTH47.cv;

    /* station 48 */
    r_trig(&RISE48, X15);
    ton(&TONA48, X12 && !X11, 120);
    tof(&TOFA48, TONA48.q, 40);
    tp(&PULSE48, RISE48.q, 360);
    ton(&TONB48, !TONB48.q, 280);
    tof(&TOFB48, X10 || PULSE48.q, 210);
    f_trig(&FALL48, TOFA48.q);
    ctu(&CUP48, TONB48.q, CUP48.q, 7);
    ctd(&CDOWN48, FALL48.q, CDOWN48.q, 7);
    ctud(&CBOTH48, RISE48.q, X11, CUP47.q && CDOWN48.q, FALL47.q && X02, 9);
    if (TONA48.q) sum += 48;
    if (TOFA48.q && TOFA48.et > 50) sum += 2;
    if (PULSE48.q) sum += 3;
    if (PULSE48.et >= 50) sum += 4;
    if (TOFB48.q && !CBOTH48.qu) sum += 5;
    if (CBOTH48.qd) sum += 6;
    sum += CUP48.cv + 2 * CDOWN48.cv + 3 * CBOTH48.cv;

    /* station 49 */
    r_trig(&RISE49, X04);
    ton(&TONA49, X02 || TOFB48.q, 340);
    tof(&TOFA49, X09 && TONA49.q, 50);
    tp(&PULSE49, X15, 300);
    ton(&TONB49, !TONB49.q, 50);
    tof(&TOFB49, X10 || PULSE49.q, 270);
    f_trig(&FALL49, TOFA49.q);
    ctu(&CUP49, TONB49.q, CUP49.q, 5);
    ctd(&CDOWN49, FALL49.q, CDOWN49.q, 6);
    ctud(&CBOTH49, RISE49.q, X13, CUP48.q && CDOWN49.q, FALL48.q && X15, 3);
    if (TONA49.q) sum += 49;
    if (TOFA49.q && TOFA49.et > 50) sum += 2;
    if (PULSE49.q) sum += 3;
    if (PULSE49.et >= 50) sum += 4;
    if (TOFB49.q && !CBOTH49.qu) sum += 5;
    if (CBOTH49.qd) sum += 6;
    sum += CUP49.cv + 2 * CDOWN49.cv + 3 * CBOTH49.cv;

    /* station 50 */
    r_trig(&RISE50, X02);
    ton(&TONA50, !X07, 210);
    tof(&TOFA50, X03 ^ X04, 90);
    tp(&PULSE50, RISE50.q || TONA50.q, 100);
    ton(&TONB50, !TONB50.q, 50);
    tof(&TOFB50, X04 || PULSE50.q, 100);
    f_trig(&FALL50, TOFA50.q);
    ctu(&CUP50, TONB50.q, CUP50.q, 3);
    ctd(&CDOWN50, FALL50.q, CDOWN50.q, 5);
    ctud(&CBOTH50, RISE50.q, X13, CUP49.q && CDOWN50.q, FALL49.q && X05, 7);
    if (TONA50.q) sum += 50;
    if (TOFA50.q && TOFA50.et > 40) sum += 2;
    if (PULSE50.q) sum += 3;
    if (PULSE50.et >= 40) sum += 4;
    if (TOFB50.q && !CBOTH50.qu) sum += 5;
    if (CBOTH50.qd) sum += 6;
    sum += CUP50.cv + 2 * CDOWN50.cv + 3 * CBOTH50.cv;

    check = (check * 31 + sum) % 1000003;
}
