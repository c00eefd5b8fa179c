/* 500 timers, counters and edges: 25 drives with named instances, 50 sensor channels in arrays. */
#include <stdbool.h>
#include "st.h"

typedef struct { bool q, run; int32_t et; uint32_t start; } ton_t;
typedef struct { bool q, in; int32_t et; uint32_t start; } tof_t;
typedef struct { bool q, in, run; int32_t et; uint32_t start; } tp_t;
typedef struct { bool q, m; } rtrig_t;
typedef struct { bool q, m; } ftrig_t;
typedef struct { bool q, cu; int16_t cv; } ctu_t;
typedef struct { bool q, cd; int16_t cv; } ctd_t;
typedef struct { bool qu, qd, cu, cd; int16_t cv; } ctud_t;
typedef struct { bool raw, debounced; int16_t count; } channel_t;

static uint32_t now; /* ms */

static inline void ton(ton_t *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = t->run = false;
        t->et = 0;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    if (!t->q) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static inline void tof(tof_t *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in)
            t->start = now;
        if (t->q) {
            t->et = (int32_t)(now - t->start);
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->in = in;
}

static inline void tp(tp_t *t, bool in, int32_t pt)
{
    if (t->q) {
        t->et = (int32_t)(now - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->in) {
        t->q = true;
        t->et = 0;
        t->start = now;
    }
    if (!t->q && !in)
        t->et = 0;
    t->in = in;
}

static inline void rtrig(rtrig_t *t, bool clk)
{
    t->q = clk && !t->m;
    t->m = clk;
}

static inline void ftrig(ftrig_t *t, bool clk)
{
    t->q = !clk && !t->m;
    t->m = !clk;
}

static inline void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static inline void ctud(ctud_t *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;

    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up && !down) {
        if (c->cv < INT16_MAX)
            c->cv++;
    } else if (down && !up) {
        if (c->cv > INT16_MIN)
            c->cv--;
    }
    c->cu = cu;
    c->cd = cd;
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static bool DI[64];
static int16_t period[64], phase[64];
static channel_t Ch[50];
static ton_t ChOn[50];
static tof_t ChOff[50];
static rtrig_t ChRise[50];
static ctu_t ChCnt[50];
static tp_t ChStretch[50];
static bool started;
static ton_t D101_StartDly, D101_FbkMon;
static tof_t D101_OffDly, D101_RunOn;
static tp_t D101_Pulse;
static rtrig_t D101_StartEdge;
static ftrig_t D101_StopEdge;
static ctu_t D101_Starts;
static ctd_t D101_Service;
static ctud_t D101_Pieces;
static ton_t D102_StartDly, D102_FbkMon;
static tof_t D102_OffDly, D102_RunOn;
static tp_t D102_Pulse;
static rtrig_t D102_StartEdge;
static ftrig_t D102_StopEdge;
static ctu_t D102_Starts;
static ctd_t D102_Service;
static ctud_t D102_Pieces;
static ton_t D103_StartDly, D103_FbkMon;
static tof_t D103_OffDly, D103_RunOn;
static tp_t D103_Pulse;
static rtrig_t D103_StartEdge;
static ftrig_t D103_StopEdge;
static ctu_t D103_Starts;
static ctd_t D103_Service;
static ctud_t D103_Pieces;
static ton_t D104_StartDly, D104_FbkMon;
static tof_t D104_OffDly, D104_RunOn;
static tp_t D104_Pulse;
static rtrig_t D104_StartEdge;
static ftrig_t D104_StopEdge;
static ctu_t D104_Starts;
static ctd_t D104_Service;
static ctud_t D104_Pieces;
static ton_t D105_StartDly, D105_FbkMon;
static tof_t D105_OffDly, D105_RunOn;
static tp_t D105_Pulse;
static rtrig_t D105_StartEdge;
static ftrig_t D105_StopEdge;
static ctu_t D105_Starts;
static ctd_t D105_Service;
static ctud_t D105_Pieces;
static ton_t D106_StartDly, D106_FbkMon;
static tof_t D106_OffDly, D106_RunOn;
static tp_t D106_Pulse;
static rtrig_t D106_StartEdge;
static ftrig_t D106_StopEdge;
static ctu_t D106_Starts;
static ctd_t D106_Service;
static ctud_t D106_Pieces;
static ton_t D107_StartDly, D107_FbkMon;
static tof_t D107_OffDly, D107_RunOn;
static tp_t D107_Pulse;
static rtrig_t D107_StartEdge;
static ftrig_t D107_StopEdge;
static ctu_t D107_Starts;
static ctd_t D107_Service;
static ctud_t D107_Pieces;
static ton_t D108_StartDly, D108_FbkMon;
static tof_t D108_OffDly, D108_RunOn;
static tp_t D108_Pulse;
static rtrig_t D108_StartEdge;
static ftrig_t D108_StopEdge;
static ctu_t D108_Starts;
static ctd_t D108_Service;
static ctud_t D108_Pieces;
static ton_t D109_StartDly, D109_FbkMon;
static tof_t D109_OffDly, D109_RunOn;
static tp_t D109_Pulse;
static rtrig_t D109_StartEdge;
static ftrig_t D109_StopEdge;
static ctu_t D109_Starts;
static ctd_t D109_Service;
static ctud_t D109_Pieces;
static ton_t D110_StartDly, D110_FbkMon;
static tof_t D110_OffDly, D110_RunOn;
static tp_t D110_Pulse;
static rtrig_t D110_StartEdge;
static ftrig_t D110_StopEdge;
static ctu_t D110_Starts;
static ctd_t D110_Service;
static ctud_t D110_Pieces;
static ton_t D111_StartDly, D111_FbkMon;
static tof_t D111_OffDly, D111_RunOn;
static tp_t D111_Pulse;
static rtrig_t D111_StartEdge;
static ftrig_t D111_StopEdge;
static ctu_t D111_Starts;
static ctd_t D111_Service;
static ctud_t D111_Pieces;
static ton_t D112_StartDly, D112_FbkMon;
static tof_t D112_OffDly, D112_RunOn;
static tp_t D112_Pulse;
static rtrig_t D112_StartEdge;
static ftrig_t D112_StopEdge;
static ctu_t D112_Starts;
static ctd_t D112_Service;
static ctud_t D112_Pieces;
static ton_t D113_StartDly, D113_FbkMon;
static tof_t D113_OffDly, D113_RunOn;
static tp_t D113_Pulse;
static rtrig_t D113_StartEdge;
static ftrig_t D113_StopEdge;
static ctu_t D113_Starts;
static ctd_t D113_Service;
static ctud_t D113_Pieces;
static ton_t D114_StartDly, D114_FbkMon;
static tof_t D114_OffDly, D114_RunOn;
static tp_t D114_Pulse;
static rtrig_t D114_StartEdge;
static ftrig_t D114_StopEdge;
static ctu_t D114_Starts;
static ctd_t D114_Service;
static ctud_t D114_Pieces;
static ton_t D115_StartDly, D115_FbkMon;
static tof_t D115_OffDly, D115_RunOn;
static tp_t D115_Pulse;
static rtrig_t D115_StartEdge;
static ftrig_t D115_StopEdge;
static ctu_t D115_Starts;
static ctd_t D115_Service;
static ctud_t D115_Pieces;
static ton_t D116_StartDly, D116_FbkMon;
static tof_t D116_OffDly, D116_RunOn;
static tp_t D116_Pulse;
static rtrig_t D116_StartEdge;
static ftrig_t D116_StopEdge;
static ctu_t D116_Starts;
static ctd_t D116_Service;
static ctud_t D116_Pieces;
static ton_t D117_StartDly, D117_FbkMon;
static tof_t D117_OffDly, D117_RunOn;
static tp_t D117_Pulse;
static rtrig_t D117_StartEdge;
static ftrig_t D117_StopEdge;
static ctu_t D117_Starts;
static ctd_t D117_Service;
static ctud_t D117_Pieces;
static ton_t D118_StartDly, D118_FbkMon;
static tof_t D118_OffDly, D118_RunOn;
static tp_t D118_Pulse;
static rtrig_t D118_StartEdge;
static ftrig_t D118_StopEdge;
static ctu_t D118_Starts;
static ctd_t D118_Service;
static ctud_t D118_Pieces;
static ton_t D119_StartDly, D119_FbkMon;
static tof_t D119_OffDly, D119_RunOn;
static tp_t D119_Pulse;
static rtrig_t D119_StartEdge;
static ftrig_t D119_StopEdge;
static ctu_t D119_Starts;
static ctd_t D119_Service;
static ctud_t D119_Pieces;
static ton_t D120_StartDly, D120_FbkMon;
static tof_t D120_OffDly, D120_RunOn;
static tp_t D120_Pulse;
static rtrig_t D120_StartEdge;
static ftrig_t D120_StopEdge;
static ctu_t D120_Starts;
static ctd_t D120_Service;
static ctud_t D120_Pieces;
static ton_t D121_StartDly, D121_FbkMon;
static tof_t D121_OffDly, D121_RunOn;
static tp_t D121_Pulse;
static rtrig_t D121_StartEdge;
static ftrig_t D121_StopEdge;
static ctu_t D121_Starts;
static ctd_t D121_Service;
static ctud_t D121_Pieces;
static ton_t D122_StartDly, D122_FbkMon;
static tof_t D122_OffDly, D122_RunOn;
static tp_t D122_Pulse;
static rtrig_t D122_StartEdge;
static ftrig_t D122_StopEdge;
static ctu_t D122_Starts;
static ctd_t D122_Service;
static ctud_t D122_Pieces;
static ton_t D123_StartDly, D123_FbkMon;
static tof_t D123_OffDly, D123_RunOn;
static tp_t D123_Pulse;
static rtrig_t D123_StartEdge;
static ftrig_t D123_StopEdge;
static ctu_t D123_Starts;
static ctd_t D123_Service;
static ctud_t D123_Pieces;
static ton_t D124_StartDly, D124_FbkMon;
static tof_t D124_OffDly, D124_RunOn;
static tp_t D124_Pulse;
static rtrig_t D124_StartEdge;
static ftrig_t D124_StopEdge;
static ctu_t D124_Starts;
static ctd_t D124_Service;
static ctud_t D124_Pieces;
static ton_t D125_StartDly, D125_FbkMon;
static tof_t D125_OffDly, D125_RunOn;
static tp_t D125_Pulse;
static rtrig_t D125_StartEdge;
static ftrig_t D125_StopEdge;
static ctu_t D125_Starts;
static ctd_t D125_Service;
static ctud_t D125_Pieces;

void scan(void)
{
    int32_t sum = 0;

    now = (uint32_t)(now_us / 1000);
    if (!started) {
        started = true;
        for (int i = 0; i < 64; i++) {
            period[i] = 5 + i * 7 % 61;
            phase[i] = i % 5;
        }
    }
    for (int i = 0; i < 64; i++) {
        if (++phase[i] >= period[i]) {
            phase[i] = 0;
            DI[i] = !DI[i];
        }
    }

    /* drive D101 */
    ton(&D101_StartDly, DI[29], 140);
    tof(&D101_OffDly, D101_StartDly.q, 140);
    ton(&D101_FbkMon, D101_OffDly.q && !DI[31], 80);
    tof(&D101_RunOn, DI[17] && !D101_FbkMon.q, 210);
    rtrig(&D101_StartEdge, D101_OffDly.q);
    ftrig(&D101_StopEdge, D101_RunOn.q);
    tp(&D101_Pulse, D101_StartEdge.q || DI[11], 70);
    ctu(&D101_Starts, D101_StartEdge.q, D101_Service.q && DI[49], 11);
    ctd(&D101_Service, D101_StopEdge.q, DI[49] && DI[32], 11);
    ctud(&D101_Pieces, DI[32], D101_Pulse.q, D101_FbkMon.q, DI[49] && DI[17], 2);
    if (D101_OffDly.q) sum += 1;
    if (D101_FbkMon.et > 50) sum += 2;
    if (D101_RunOn.q != D101_Pulse.q) sum += 4;
    sum += D101_Starts.cv + D101_Service.cv + D101_Pieces.cv;

    /* drive D102 */
    ton(&D102_StartDly, DI[27], 210);
    tof(&D102_OffDly, D102_StartDly.q, 170);
    ton(&D102_FbkMon, D102_OffDly.q && !DI[47], 80);
    tof(&D102_RunOn, DI[49] && !D102_FbkMon.q, 150);
    rtrig(&D102_StartEdge, D102_OffDly.q);
    ftrig(&D102_StopEdge, D102_RunOn.q);
    tp(&D102_Pulse, D102_StartEdge.q || DI[27], 250);
    ctu(&D102_Starts, D102_StartEdge.q, D102_Service.q && DI[59], 5);
    ctd(&D102_Service, D102_StopEdge.q, DI[59] && DI[19], 8);
    ctud(&D102_Pieces, DI[19], D102_Pulse.q, D102_FbkMon.q, DI[59] && DI[49], 2);
    if (D102_OffDly.q) sum += 1;
    if (D102_FbkMon.et > 50) sum += 2;
    if (D102_RunOn.q != D102_Pulse.q) sum += 4;
    sum += D102_Starts.cv + D102_Service.cv + D102_Pieces.cv;

    /* drive D103 */
    ton(&D103_StartDly, DI[60], 240);
    tof(&D103_OffDly, D103_StartDly.q, 180);
    ton(&D103_FbkMon, D103_OffDly.q && !DI[40], 230);
    tof(&D103_RunOn, DI[51] && !D103_FbkMon.q, 260);
    rtrig(&D103_StartEdge, D103_OffDly.q);
    ftrig(&D103_StopEdge, D103_RunOn.q);
    tp(&D103_Pulse, D103_StartEdge.q || DI[5], 40);
    ctu(&D103_Starts, D103_StartEdge.q, D103_Service.q && DI[0], 9);
    ctd(&D103_Service, D103_StopEdge.q, DI[0] && DI[34], 6);
    ctud(&D103_Pieces, DI[34], D103_Pulse.q, D103_FbkMon.q, DI[0] && DI[51], 4);
    if (D103_OffDly.q) sum += 1;
    if (D103_FbkMon.et > 50) sum += 2;
    if (D103_RunOn.q != D103_Pulse.q) sum += 4;
    sum += D103_Starts.cv + D103_Service.cv + D103_Pieces.cv;

    /* drive D104 */
    ton(&D104_StartDly, DI[59], 190);
    tof(&D104_OffDly, D104_StartDly.q, 40);
    ton(&D104_FbkMon, D104_OffDly.q && !DI[6], 160);
    tof(&D104_RunOn, DI[45] && !D104_FbkMon.q, 180);
    rtrig(&D104_StartEdge, D104_OffDly.q);
    ftrig(&D104_StopEdge, D104_RunOn.q);
    tp(&D104_Pulse, D104_StartEdge.q || DI[16], 80);
    ctu(&D104_Starts, D104_StartEdge.q, D104_Service.q && DI[20], 10);
    ctd(&D104_Service, D104_StopEdge.q, DI[20] && DI[27], 5);
    ctud(&D104_Pieces, DI[27], D104_Pulse.q, D104_FbkMon.q, DI[20] && DI[45], 6);
    if (D104_OffDly.q) sum += 1;
    if (D104_FbkMon.et > 50) sum += 2;
    if (D104_RunOn.q != D104_Pulse.q) sum += 4;
    sum += D104_Starts.cv + D104_Service.cv + D104_Pieces.cv;

    /* drive D105 */
    ton(&D105_StartDly, DI[21], 230);
    tof(&D105_OffDly, D105_StartDly.q, 70);
    ton(&D105_FbkMon, D105_OffDly.q && !DI[60], 30);
    tof(&D105_RunOn, DI[53] && !D105_FbkMon.q, 50);
    rtrig(&D105_StartEdge, D105_OffDly.q);
    ftrig(&D105_StopEdge, D105_RunOn.q);
    tp(&D105_Pulse, D105_StartEdge.q || DI[10], 20);
    ctu(&D105_Starts, D105_StartEdge.q, D105_Service.q && DI[11], 5);
    ctd(&D105_Service, D105_StopEdge.q, DI[11] && DI[54], 7);
    ctud(&D105_Pieces, DI[54], D105_Pulse.q, D105_FbkMon.q, DI[11] && DI[53], 6);
    if (D105_OffDly.q) sum += 1;
    if (D105_FbkMon.et > 50) sum += 2;
    if (D105_RunOn.q != D105_Pulse.q) sum += 4;
    sum += D105_Starts.cv + D105_Service.cv + D105_Pieces.cv;

    /* drive D106 */
    ton(&D106_StartDly, DI[51], 20);
    tof(&D106_OffDly, D106_StartDly.q, 140);
    ton(&D106_FbkMon, D106_OffDly.q && !DI[25], 120);
    tof(&D106_RunOn, DI[7] && !D106_FbkMon.q, 60);
    rtrig(&D106_StartEdge, D106_OffDly.q);
    ftrig(&D106_StopEdge, D106_RunOn.q);
    tp(&D106_Pulse, D106_StartEdge.q || DI[27], 180);
    ctu(&D106_Starts, D106_StartEdge.q, D106_Service.q && DI[32], 11);
    ctd(&D106_Service, D106_StopEdge.q, DI[32] && DI[56], 9);
    ctud(&D106_Pieces, DI[56], D106_Pulse.q, D106_FbkMon.q, DI[32] && DI[7], 8);
    if (D106_OffDly.q) sum += 1;
    if (D106_FbkMon.et > 50) sum += 2;
    if (D106_RunOn.q != D106_Pulse.q) sum += 4;
    sum += D106_Starts.cv + D106_Service.cv + D106_Pieces.cv;

    /* drive D107 */
    ton(&D107_StartDly, DI[7], 260);
    tof(&D107_OffDly, D107_StartDly.q, 60);
    ton(&D107_FbkMon, D107_OffDly.q && !DI[16], 130);
    tof(&D107_RunOn, DI[19] && !D107_FbkMon.q, 240);
    rtrig(&D107_StartEdge, D107_OffDly.q);
    ftrig(&D107_StopEdge, D107_RunOn.q);
    tp(&D107_Pulse, D107_StartEdge.q || DI[52], 170);
    ctu(&D107_Starts, D107_StartEdge.q, D107_Service.q && DI[12], 4);
    ctd(&D107_Service, D107_StopEdge.q, DI[12] && DI[15], 5);
    ctud(&D107_Pieces, DI[15], D107_Pulse.q, D107_FbkMon.q, DI[12] && DI[19], 4);
    if (D107_OffDly.q) sum += 1;
    if (D107_FbkMon.et > 50) sum += 2;
    if (D107_RunOn.q != D107_Pulse.q) sum += 4;
    sum += D107_Starts.cv + D107_Service.cv + D107_Pieces.cv;

    /* drive D108 */
    ton(&D108_StartDly, DI[40], 70);
    tof(&D108_OffDly, D108_StartDly.q, 70);
    ton(&D108_FbkMon, D108_OffDly.q && !DI[63], 150);
    tof(&D108_RunOn, DI[29] && !D108_FbkMon.q, 60);
    rtrig(&D108_StartEdge, D108_OffDly.q);
    ftrig(&D108_StopEdge, D108_RunOn.q);
    tp(&D108_Pulse, D108_StartEdge.q || DI[32], 80);
    ctu(&D108_Starts, D108_StartEdge.q, D108_Service.q && DI[46], 5);
    ctd(&D108_Service, D108_StopEdge.q, DI[46] && DI[15], 4);
    ctud(&D108_Pieces, DI[15], D108_Pulse.q, D108_FbkMon.q, DI[46] && DI[29], 6);
    if (D108_OffDly.q) sum += 1;
    if (D108_FbkMon.et > 50) sum += 2;
    if (D108_RunOn.q != D108_Pulse.q) sum += 4;
    sum += D108_Starts.cv + D108_Service.cv + D108_Pieces.cv;

    /* drive D109 */
    ton(&D109_StartDly, DI[43], 110);
    tof(&D109_OffDly, D109_StartDly.q, 20);
    ton(&D109_FbkMon, D109_OffDly.q && !DI[27], 200);
    tof(&D109_RunOn, DI[48] && !D109_FbkMon.q, 280);
    rtrig(&D109_StartEdge, D109_OffDly.q);
    ftrig(&D109_StopEdge, D109_RunOn.q);
    tp(&D109_Pulse, D109_StartEdge.q || DI[51], 30);
    ctu(&D109_Starts, D109_StartEdge.q, D109_Service.q && DI[51], 9);
    ctd(&D109_Service, D109_StopEdge.q, DI[51] && DI[43], 9);
    ctud(&D109_Pieces, DI[43], D109_Pulse.q, D109_FbkMon.q, DI[51] && DI[48], 8);
    if (D109_OffDly.q) sum += 1;
    if (D109_FbkMon.et > 50) sum += 2;
    if (D109_RunOn.q != D109_Pulse.q) sum += 4;
    sum += D109_Starts.cv + D109_Service.cv + D109_Pieces.cv;

    /* drive D110 */
    ton(&D110_StartDly, DI[47], 130);
    tof(&D110_OffDly, D110_StartDly.q, 190);
    ton(&D110_FbkMon, D110_OffDly.q && !DI[51], 40);
    tof(&D110_RunOn, DI[56] && !D110_FbkMon.q, 70);
    rtrig(&D110_StartEdge, D110_OffDly.q);
    ftrig(&D110_StopEdge, D110_RunOn.q);
    tp(&D110_Pulse, D110_StartEdge.q || DI[29], 30);
    ctu(&D110_Starts, D110_StartEdge.q, D110_Service.q && DI[28], 7);
    ctd(&D110_Service, D110_StopEdge.q, DI[28] && DI[39], 4);
    ctud(&D110_Pieces, DI[39], D110_Pulse.q, D110_FbkMon.q, DI[28] && DI[56], 8);
    if (D110_OffDly.q) sum += 1;
    if (D110_FbkMon.et > 50) sum += 2;
    if (D110_RunOn.q != D110_Pulse.q) sum += 4;
    sum += D110_Starts.cv + D110_Service.cv + D110_Pieces.cv;

    /* drive D111 */
    ton(&D111_StartDly, DI[31], 240);
    tof(&D111_OffDly, D111_StartDly.q, 250);
    ton(&D111_FbkMon, D111_OffDly.q && !DI[49], 120);
    tof(&D111_RunOn, DI[37] && !D111_FbkMon.q, 80);
    rtrig(&D111_StartEdge, D111_OffDly.q);
    ftrig(&D111_StopEdge, D111_RunOn.q);
    tp(&D111_Pulse, D111_StartEdge.q || DI[56], 260);
    ctu(&D111_Starts, D111_StartEdge.q, D111_Service.q && DI[56], 9);
    ctd(&D111_Service, D111_StopEdge.q, DI[56] && DI[10], 7);
    ctud(&D111_Pieces, DI[10], D111_Pulse.q, D111_FbkMon.q, DI[56] && DI[37], 2);
    if (D111_OffDly.q) sum += 1;
    if (D111_FbkMon.et > 50) sum += 2;
    if (D111_RunOn.q != D111_Pulse.q) sum += 4;
    sum += D111_Starts.cv + D111_Service.cv + D111_Pieces.cv;

    /* drive D112 */
    ton(&D112_StartDly, DI[61], 180);
    tof(&D112_OffDly, D112_StartDly.q, 110);
    ton(&D112_FbkMon, D112_OffDly.q && !DI[16], 230);
    tof(&D112_RunOn, DI[32] && !D112_FbkMon.q, 290);
    rtrig(&D112_StartEdge, D112_OffDly.q);
    ftrig(&D112_StopEdge, D112_RunOn.q);
    tp(&D112_Pulse, D112_StartEdge.q || DI[55], 120);
    ctu(&D112_Starts, D112_StartEdge.q, D112_Service.q && DI[52], 5);
    ctd(&D112_Service, D112_StopEdge.q, DI[52] && DI[37], 7);
    ctud(&D112_Pieces, DI[37], D112_Pulse.q, D112_FbkMon.q, DI[52] && DI[32], 5);
    if (D112_OffDly.q) sum += 1;
    if (D112_FbkMon.et > 50) sum += 2;
    if (D112_RunOn.q != D112_Pulse.q) sum += 4;
    sum += D112_Starts.cv + D112_Service.cv + D112_Pieces.cv;

    /* drive D113 */
    ton(&D113_StartDly, DI[56], 230);
    tof(&D113_OffDly, D113_StartDly.q, 230);
    ton(&D113_FbkMon, D113_OffDly.q && !DI[24], 210);
    tof(&D113_RunOn, DI[48] && !D113_FbkMon.q, 290);
    rtrig(&D113_StartEdge, D113_OffDly.q);
    ftrig(&D113_StopEdge, D113_RunOn.q);
    tp(&D113_Pulse, D113_StartEdge.q || DI[43], 210);
    ctu(&D113_Starts, D113_StartEdge.q, D113_Service.q && DI[44], 3);
    ctd(&D113_Service, D113_StopEdge.q, DI[44] && DI[25], 8);
    ctud(&D113_Pieces, DI[25], D113_Pulse.q, D113_FbkMon.q, DI[44] && DI[48], 7);
    if (D113_OffDly.q) sum += 1;
    if (D113_FbkMon.et > 50) sum += 2;
    if (D113_RunOn.q != D113_Pulse.q) sum += 4;
    sum += D113_Starts.cv + D113_Service.cv + D113_Pieces.cv;

    /* drive D114 */
    ton(&D114_StartDly, DI[21], 110);
    tof(&D114_OffDly, D114_StartDly.q, 290);
    ton(&D114_FbkMon, D114_OffDly.q && !DI[33], 80);
    tof(&D114_RunOn, DI[53] && !D114_FbkMon.q, 230);
    rtrig(&D114_StartEdge, D114_OffDly.q);
    ftrig(&D114_StopEdge, D114_RunOn.q);
    tp(&D114_Pulse, D114_StartEdge.q || DI[29], 230);
    ctu(&D114_Starts, D114_StartEdge.q, D114_Service.q && DI[44], 9);
    ctd(&D114_Service, D114_StopEdge.q, DI[44] && DI[52], 3);
    ctud(&D114_Pieces, DI[52], D114_Pulse.q, D114_FbkMon.q, DI[44] && DI[53], 2);
    if (D114_OffDly.q) sum += 1;
    if (D114_FbkMon.et > 50) sum += 2;
    if (D114_RunOn.q != D114_Pulse.q) sum += 4;
    sum += D114_Starts.cv + D114_Service.cv + D114_Pieces.cv;

    /* drive D115 */
    ton(&D115_StartDly, DI[39], 180);
    tof(&D115_OffDly, D115_StartDly.q, 190);
    ton(&D115_FbkMon, D115_OffDly.q && !DI[21], 80);
    tof(&D115_RunOn, DI[56] && !D115_FbkMon.q, 20);
    rtrig(&D115_StartEdge, D115_OffDly.q);
    ftrig(&D115_StopEdge, D115_RunOn.q);
    tp(&D115_Pulse, D115_StartEdge.q || DI[26], 180);
    ctu(&D115_Starts, D115_StartEdge.q, D115_Service.q && DI[53], 10);
    ctd(&D115_Service, D115_StopEdge.q, DI[53] && DI[33], 11);
    ctud(&D115_Pieces, DI[33], D115_Pulse.q, D115_FbkMon.q, DI[53] && DI[56], 6);
    if (D115_OffDly.q) sum += 1;
    if (D115_FbkMon.et > 50) sum += 2;
    if (D115_RunOn.q != D115_Pulse.q) sum += 4;
    sum += D115_Starts.cv + D115_Service.cv + D115_Pieces.cv;

    /* drive D116 */
    ton(&D116_StartDly, DI[36], 220);
    tof(&D116_OffDly, D116_StartDly.q, 210);
    ton(&D116_FbkMon, D116_OffDly.q && !DI[25], 260);
    tof(&D116_RunOn, DI[2] && !D116_FbkMon.q, 220);
    rtrig(&D116_StartEdge, D116_OffDly.q);
    ftrig(&D116_StopEdge, D116_RunOn.q);
    tp(&D116_Pulse, D116_StartEdge.q || DI[13], 280);
    ctu(&D116_Starts, D116_StartEdge.q, D116_Service.q && DI[9], 3);
    ctd(&D116_Service, D116_StopEdge.q, DI[9] && DI[39], 3);
    ctud(&D116_Pieces, DI[39], D116_Pulse.q, D116_FbkMon.q, DI[9] && DI[2], 5);
    if (D116_OffDly.q) sum += 1;
    if (D116_FbkMon.et > 50) sum += 2;
    if (D116_RunOn.q != D116_Pulse.q) sum += 4;
    sum += D116_Starts.cv + D116_Service.cv + D116_Pieces.cv;

    /* drive D117 */
    ton(&D117_StartDly, DI[37], 110);
    tof(&D117_OffDly, D117_StartDly.q, 130);
    ton(&D117_FbkMon, D117_OffDly.q && !DI[24], 190);
    tof(&D117_RunOn, DI[12] && !D117_FbkMon.q, 220);
    rtrig(&D117_StartEdge, D117_OffDly.q);
    ftrig(&D117_StopEdge, D117_RunOn.q);
    tp(&D117_Pulse, D117_StartEdge.q || DI[50], 240);
    ctu(&D117_Starts, D117_StartEdge.q, D117_Service.q && DI[22], 7);
    ctd(&D117_Service, D117_StopEdge.q, DI[22] && DI[51], 10);
    ctud(&D117_Pieces, DI[51], D117_Pulse.q, D117_FbkMon.q, DI[22] && DI[12], 4);
    if (D117_OffDly.q) sum += 1;
    if (D117_FbkMon.et > 50) sum += 2;
    if (D117_RunOn.q != D117_Pulse.q) sum += 4;
    sum += D117_Starts.cv + D117_Service.cv + D117_Pieces.cv;

    /* drive D118 */
    ton(&D118_StartDly, DI[49], 60);
    tof(&D118_OffDly, D118_StartDly.q, 60);
    ton(&D118_FbkMon, D118_OffDly.q && !DI[53], 160);
    tof(&D118_RunOn, DI[22] && !D118_FbkMon.q, 290);
    rtrig(&D118_StartEdge, D118_OffDly.q);
    ftrig(&D118_StopEdge, D118_RunOn.q);
    tp(&D118_Pulse, D118_StartEdge.q || DI[46], 290);
    ctu(&D118_Starts, D118_StartEdge.q, D118_Service.q && DI[26], 7);
    ctd(&D118_Service, D118_StopEdge.q, DI[26] && DI[32], 10);
    ctud(&D118_Pieces, DI[32], D118_Pulse.q, D118_FbkMon.q, DI[26] && DI[22], 6);
    if (D118_OffDly.q) sum += 1;
    if (D118_FbkMon.et > 50) sum += 2;
    if (D118_RunOn.q != D118_Pulse.q) sum += 4;
    sum += D118_Starts.cv + D118_Service.cv + D118_Pieces.cv;

    /* drive D119 */
    ton(&D119_StartDly, DI[61], 290);
    tof(&D119_OffDly, D119_StartDly.q, 240);
    ton(&D119_FbkMon, D119_OffDly.q && !DI[60], 140);
    tof(&D119_RunOn, DI[21] && !D119_FbkMon.q, 70);
    rtrig(&D119_StartEdge, D119_OffDly.q);
    ftrig(&D119_StopEdge, D119_RunOn.q);
    tp(&D119_Pulse, D119_StartEdge.q || DI[9], 280);
    ctu(&D119_Starts, D119_StartEdge.q, D119_Service.q && DI[58], 11);
    ctd(&D119_Service, D119_StopEdge.q, DI[58] && DI[30], 3);
    ctud(&D119_Pieces, DI[30], D119_Pulse.q, D119_FbkMon.q, DI[58] && DI[21], 2);
    if (D119_OffDly.q) sum += 1;
    if (D119_FbkMon.et > 50) sum += 2;
    if (D119_RunOn.q != D119_Pulse.q) sum += 4;
    sum += D119_Starts.cv + D119_Service.cv + D119_Pieces.cv;

    /* drive D120 */
    ton(&D120_StartDly, DI[0], 120);
    tof(&D120_OffDly, D120_StartDly.q, 270);
    ton(&D120_FbkMon, D120_OffDly.q && !DI[35], 170);
    tof(&D120_RunOn, DI[1] && !D120_FbkMon.q, 40);
    rtrig(&D120_StartEdge, D120_OffDly.q);
    ftrig(&D120_StopEdge, D120_RunOn.q);
    tp(&D120_Pulse, D120_StartEdge.q || DI[40], 120);
    ctu(&D120_Starts, D120_StartEdge.q, D120_Service.q && DI[33], 5);
    ctd(&D120_Service, D120_StopEdge.q, DI[33] && DI[52], 5);
    ctud(&D120_Pieces, DI[52], D120_Pulse.q, D120_FbkMon.q, DI[33] && DI[1], 6);
    if (D120_OffDly.q) sum += 1;
    if (D120_FbkMon.et > 50) sum += 2;
    if (D120_RunOn.q != D120_Pulse.q) sum += 4;
    sum += D120_Starts.cv + D120_Service.cv + D120_Pieces.cv;

    /* drive D121 */
    ton(&D121_StartDly, DI[29], 30);
    tof(&D121_OffDly, D121_StartDly.q, 140);
    ton(&D121_FbkMon, D121_OffDly.q && !DI[37], 30);
    tof(&D121_RunOn, DI[20] && !D121_FbkMon.q, 30);
    rtrig(&D121_StartEdge, D121_OffDly.q);
    ftrig(&D121_StopEdge, D121_RunOn.q);
    tp(&D121_Pulse, D121_StartEdge.q || DI[56], 120);
    ctu(&D121_Starts, D121_StartEdge.q, D121_Service.q && DI[53], 6);
    ctd(&D121_Service, D121_StopEdge.q, DI[53] && DI[7], 6);
    ctud(&D121_Pieces, DI[7], D121_Pulse.q, D121_FbkMon.q, DI[53] && DI[20], 2);
    if (D121_OffDly.q) sum += 1;
    if (D121_FbkMon.et > 50) sum += 2;
    if (D121_RunOn.q != D121_Pulse.q) sum += 4;
    sum += D121_Starts.cv + D121_Service.cv + D121_Pieces.cv;

    /* drive D122 */
    ton(&D122_StartDly, DI[46], 170);
    tof(&D122_OffDly, D122_StartDly.q, 70);
    ton(&D122_FbkMon, D122_OffDly.q && !DI[9], 100);
    tof(&D122_RunOn, DI[25] && !D122_FbkMon.q, 100);
    rtrig(&D122_StartEdge, D122_OffDly.q);
    ftrig(&D122_StopEdge, D122_RunOn.q);
    tp(&D122_Pulse, D122_StartEdge.q || DI[22], 230);
    ctu(&D122_Starts, D122_StartEdge.q, D122_Service.q && DI[10], 4);
    ctd(&D122_Service, D122_StopEdge.q, DI[10] && DI[45], 5);
    ctud(&D122_Pieces, DI[45], D122_Pulse.q, D122_FbkMon.q, DI[10] && DI[25], 8);
    if (D122_OffDly.q) sum += 1;
    if (D122_FbkMon.et > 50) sum += 2;
    if (D122_RunOn.q != D122_Pulse.q) sum += 4;
    sum += D122_Starts.cv + D122_Service.cv + D122_Pieces.cv;

    /* drive D123 */
    ton(&D123_StartDly, DI[48], 60);
    tof(&D123_OffDly, D123_StartDly.q, 60);
    ton(&D123_FbkMon, D123_OffDly.q && !DI[21], 190);
    tof(&D123_RunOn, DI[45] && !D123_FbkMon.q, 40);
    rtrig(&D123_StartEdge, D123_OffDly.q);
    ftrig(&D123_StopEdge, D123_RunOn.q);
    tp(&D123_Pulse, D123_StartEdge.q || DI[29], 30);
    ctu(&D123_Starts, D123_StartEdge.q, D123_Service.q && DI[43], 3);
    ctd(&D123_Service, D123_StopEdge.q, DI[43] && DI[20], 8);
    ctud(&D123_Pieces, DI[20], D123_Pulse.q, D123_FbkMon.q, DI[43] && DI[45], 8);
    if (D123_OffDly.q) sum += 1;
    if (D123_FbkMon.et > 50) sum += 2;
    if (D123_RunOn.q != D123_Pulse.q) sum += 4;
    sum += D123_Starts.cv + D123_Service.cv + D123_Pieces.cv;

    /* drive D124 */
    ton(&D124_StartDly, DI[14], 220);
    tof(&D124_OffDly, D124_StartDly.q, 150);
    ton(&D124_FbkMon, D124_OffDly.q && !DI[18], 80);
    tof(&D124_RunOn, DI[63] && !D124_FbkMon.q, 110);
    rtrig(&D124_StartEdge, D124_OffDly.q);
    ftrig(&D124_StopEdge, D124_RunOn.q);
    tp(&D124_Pulse, D124_StartEdge.q || DI[1], 70);
    ctu(&D124_Starts, D124_StartEdge.q, D124_Service.q && DI[48], 4);
    ctd(&D124_Service, D124_StopEdge.q, DI[48] && DI[29], 6);
    ctud(&D124_Pieces, DI[29], D124_Pulse.q, D124_FbkMon.q, DI[48] && DI[63], 6);
    if (D124_OffDly.q) sum += 1;
    if (D124_FbkMon.et > 50) sum += 2;
    if (D124_RunOn.q != D124_Pulse.q) sum += 4;
    sum += D124_Starts.cv + D124_Service.cv + D124_Pieces.cv;

    /* drive D125 */
    ton(&D125_StartDly, DI[10], 160);
    tof(&D125_OffDly, D125_StartDly.q, 250);
    ton(&D125_FbkMon, D125_OffDly.q && !DI[20], 270);
    tof(&D125_RunOn, DI[21] && !D125_FbkMon.q, 210);
    rtrig(&D125_StartEdge, D125_OffDly.q);
    ftrig(&D125_StopEdge, D125_RunOn.q);
    tp(&D125_Pulse, D125_StartEdge.q || DI[56], 290);
    ctu(&D125_Starts, D125_StartEdge.q, D125_Service.q && DI[32], 8);
    ctd(&D125_Service, D125_StopEdge.q, DI[32] && DI[47], 3);
    ctud(&D125_Pieces, DI[47], D125_Pulse.q, D125_FbkMon.q, DI[32] && DI[21], 6);
    if (D125_OffDly.q) sum += 1;
    if (D125_FbkMon.et > 50) sum += 2;
    if (D125_RunOn.q != D125_Pulse.q) sum += 4;
    sum += D125_Starts.cv + D125_Service.cv + D125_Pieces.cv;

    /* sensor channels */
    for (int i = 0; i < 50; i++) {
        Ch[i].raw = DI[i] != DI[i + 10];
        ton(&ChOn[i], Ch[i].raw, 40);
        tof(&ChOff[i], ChOn[i].q, 70);
        Ch[i].debounced = ChOff[i].q;
        rtrig(&ChRise[i], Ch[i].debounced);
        ctu(&ChCnt[i], ChRise[i].q, ChCnt[i].q && !Ch[i].raw, 5);
        Ch[i].count = ChCnt[i].cv;
        tp(&ChStretch[i], ChCnt[i].q, 150);
        if (ChStretch[i].q)
            sum += i;
        if (ChOff[i].et >= 30)
            sum += 1;
        sum += Ch[i].count;
    }
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)sum);
}
