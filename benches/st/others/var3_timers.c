#include <stdbool.h>
#include "st.h"
typedef struct { bool q, run; int32_t et; uint32_t start; } ton_t;
typedef struct { bool q, run, seen; int32_t et; uint32_t start; } tof_t;
typedef struct { bool q, run, old; int32_t et; uint32_t start; } tp_t;
typedef struct { bool q, old; int16_t cv; } ctr_t;
static uint32_t now_ms(void) { return (uint32_t)(now_us / 1000); }
static void ton(ton_t *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false; t->run = false; t->et = 0;
        return;
    }
    uint32_t now = now_ms();
    if (!t->run) { t->run = true; t->start = now; }
    if (!t->q) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) { t->et = pt; t->q = true; }
        else t->et = el;
    }
}
static void tof(tof_t *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true; t->run = false; t->et = 0;
        return;
    }
    if (!t->q) return;
    uint32_t now = now_ms();
    if (!t->run) { t->run = true; t->start = now; }
    int32_t el = (int32_t)(now - t->start);
    if (el >= pt) { t->et = pt; t->q = false; t->run = false; }
    else t->et = el;
}
static void tp(tp_t *t, bool in, int32_t pt)
{
    uint32_t now = now_ms();
    if (!t->run && in && !t->old) { t->run = true; t->start = now; t->et = 0; t->q = true; }
    if (t->run) {
        int32_t el = (int32_t)(now - t->start);
        if (el >= pt) { t->et = pt; t->q = false; t->run = false; }
        else t->et = el;
    }
    if (!t->run && !in) t->et = 0;
    t->old = in;
}
static void ctu(ctr_t *c, bool cu, bool r, int16_t pv)
{
    if (r) c->cv = 0;
    else if (cu && !c->old && c->cv < 32767) c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}
static void ctd(ctr_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld) c->cv = pv;
    else if (cd && !c->old && c->cv > -32768) c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static int32_t clk;
static ton_t A01_start_dly, A01_ready_dly, A01_watchdog;
static tof_t A01_fan_run, A01_lamp_off;
static tp_t A01_horn, A01_lube;
static ctr_t A01_pieces, A01_starts, A01_rest;
static bool A01_call, A01_run, A01_fault;
static ton_t A02_start_dly, A02_ready_dly, A02_watchdog;
static tof_t A02_fan_run, A02_lamp_off;
static tp_t A02_horn, A02_lube;
static ctr_t A02_pieces, A02_starts, A02_rest;
static bool A02_call, A02_run, A02_fault;
static ton_t A03_start_dly, A03_ready_dly, A03_watchdog;
static tof_t A03_fan_run, A03_lamp_off;
static tp_t A03_horn, A03_lube;
static ctr_t A03_pieces, A03_starts, A03_rest;
static bool A03_call, A03_run, A03_fault;
static ton_t A04_start_dly, A04_ready_dly, A04_watchdog;
static tof_t A04_fan_run, A04_lamp_off;
static tp_t A04_horn, A04_lube;
static ctr_t A04_pieces, A04_starts, A04_rest;
static bool A04_call, A04_run, A04_fault;
static ton_t A05_start_dly, A05_ready_dly, A05_watchdog;
static tof_t A05_fan_run, A05_lamp_off;
static tp_t A05_horn, A05_lube;
static ctr_t A05_pieces, A05_starts, A05_rest;
static bool A05_call, A05_run, A05_fault;
static ton_t A06_start_dly, A06_ready_dly, A06_watchdog;
static tof_t A06_fan_run, A06_lamp_off;
static tp_t A06_horn, A06_lube;
static ctr_t A06_pieces, A06_starts, A06_rest;
static bool A06_call, A06_run, A06_fault;
static ton_t A07_start_dly, A07_ready_dly, A07_watchdog;
static tof_t A07_fan_run, A07_lamp_off;
static tp_t A07_horn, A07_lube;
static ctr_t A07_pieces, A07_starts, A07_rest;
static bool A07_call, A07_run, A07_fault;
static ton_t A08_start_dly, A08_ready_dly, A08_watchdog;
static tof_t A08_fan_run, A08_lamp_off;
static tp_t A08_horn, A08_lube;
static ctr_t A08_pieces, A08_starts, A08_rest;
static bool A08_call, A08_run, A08_fault;
static ton_t A09_start_dly, A09_ready_dly, A09_watchdog;
static tof_t A09_fan_run, A09_lamp_off;
static tp_t A09_horn, A09_lube;
static ctr_t A09_pieces, A09_starts, A09_rest;
static bool A09_call, A09_run, A09_fault;
static ton_t A10_start_dly, A10_ready_dly, A10_watchdog;
static tof_t A10_fan_run, A10_lamp_off;
static tp_t A10_horn, A10_lube;
static ctr_t A10_pieces, A10_starts, A10_rest;
static bool A10_call, A10_run, A10_fault;
static ton_t A11_start_dly, A11_ready_dly, A11_watchdog;
static tof_t A11_fan_run, A11_lamp_off;
static tp_t A11_horn, A11_lube;
static ctr_t A11_pieces, A11_starts, A11_rest;
static bool A11_call, A11_run, A11_fault;
static ton_t A12_start_dly, A12_ready_dly, A12_watchdog;
static tof_t A12_fan_run, A12_lamp_off;
static tp_t A12_horn, A12_lube;
static ctr_t A12_pieces, A12_starts, A12_rest;
static bool A12_call, A12_run, A12_fault;
static ton_t A13_start_dly, A13_ready_dly, A13_watchdog;
static tof_t A13_fan_run, A13_lamp_off;
static tp_t A13_horn, A13_lube;
static ctr_t A13_pieces, A13_starts, A13_rest;
static bool A13_call, A13_run, A13_fault;
static ton_t A14_start_dly, A14_ready_dly, A14_watchdog;
static tof_t A14_fan_run, A14_lamp_off;
static tp_t A14_horn, A14_lube;
static ctr_t A14_pieces, A14_starts, A14_rest;
static bool A14_call, A14_run, A14_fault;
static ton_t A15_start_dly, A15_ready_dly, A15_watchdog;
static tof_t A15_fan_run, A15_lamp_off;
static tp_t A15_horn, A15_lube;
static ctr_t A15_pieces, A15_starts, A15_rest;
static bool A15_call, A15_run, A15_fault;
static ton_t A16_start_dly, A16_ready_dly, A16_watchdog;
static tof_t A16_fan_run, A16_lamp_off;
static tp_t A16_horn, A16_lube;
static ctr_t A16_pieces, A16_starts, A16_rest;
static bool A16_call, A16_run, A16_fault;
static ton_t A17_start_dly, A17_ready_dly, A17_watchdog;
static tof_t A17_fan_run, A17_lamp_off;
static tp_t A17_horn, A17_lube;
static ctr_t A17_pieces, A17_starts, A17_rest;
static bool A17_call, A17_run, A17_fault;
static ton_t A18_start_dly, A18_ready_dly, A18_watchdog;
static tof_t A18_fan_run, A18_lamp_off;
static tp_t A18_horn, A18_lube;
static ctr_t A18_pieces, A18_starts, A18_rest;
static bool A18_call, A18_run, A18_fault;
static ton_t A19_start_dly, A19_ready_dly, A19_watchdog;
static tof_t A19_fan_run, A19_lamp_off;
static tp_t A19_horn, A19_lube;
static ctr_t A19_pieces, A19_starts, A19_rest;
static bool A19_call, A19_run, A19_fault;
static ton_t A20_start_dly, A20_ready_dly, A20_watchdog;
static tof_t A20_fan_run, A20_lamp_off;
static tp_t A20_horn, A20_lube;
static ctr_t A20_pieces, A20_starts, A20_rest;
static bool A20_call, A20_run, A20_fault;
static ton_t A21_start_dly, A21_ready_dly, A21_watchdog;
static tof_t A21_fan_run, A21_lamp_off;
static tp_t A21_horn, A21_lube;
static ctr_t A21_pieces, A21_starts, A21_rest;
static bool A21_call, A21_run, A21_fault;
static ton_t A22_start_dly, A22_ready_dly, A22_watchdog;
static tof_t A22_fan_run, A22_lamp_off;
static tp_t A22_horn, A22_lube;
static ctr_t A22_pieces, A22_starts, A22_rest;
static bool A22_call, A22_run, A22_fault;
static ton_t A23_start_dly, A23_ready_dly, A23_watchdog;
static tof_t A23_fan_run, A23_lamp_off;
static tp_t A23_horn, A23_lube;
static ctr_t A23_pieces, A23_starts, A23_rest;
static bool A23_call, A23_run, A23_fault;
static ton_t A24_start_dly, A24_ready_dly, A24_watchdog;
static tof_t A24_fan_run, A24_lamp_off;
static tp_t A24_horn, A24_lube;
static ctr_t A24_pieces, A24_starts, A24_rest;
static bool A24_call, A24_run, A24_fault;
static ton_t A25_start_dly, A25_ready_dly, A25_watchdog;
static tof_t A25_fan_run, A25_lamp_off;
static tp_t A25_horn, A25_lube;
static ctr_t A25_pieces, A25_starts, A25_rest;
static bool A25_call, A25_run, A25_fault;
static ton_t A26_start_dly, A26_ready_dly, A26_watchdog;
static tof_t A26_fan_run, A26_lamp_off;
static tp_t A26_horn, A26_lube;
static ctr_t A26_pieces, A26_starts, A26_rest;
static bool A26_call, A26_run, A26_fault;
static ton_t A27_start_dly, A27_ready_dly, A27_watchdog;
static tof_t A27_fan_run, A27_lamp_off;
static tp_t A27_horn, A27_lube;
static ctr_t A27_pieces, A27_starts, A27_rest;
static bool A27_call, A27_run, A27_fault;
static ton_t A28_start_dly, A28_ready_dly, A28_watchdog;
static tof_t A28_fan_run, A28_lamp_off;
static tp_t A28_horn, A28_lube;
static ctr_t A28_pieces, A28_starts, A28_rest;
static bool A28_call, A28_run, A28_fault;
static ton_t A29_start_dly, A29_ready_dly, A29_watchdog;
static tof_t A29_fan_run, A29_lamp_off;
static tp_t A29_horn, A29_lube;
static ctr_t A29_pieces, A29_starts, A29_rest;
static bool A29_call, A29_run, A29_fault;
static ton_t A30_start_dly, A30_ready_dly, A30_watchdog;
static tof_t A30_fan_run, A30_lamp_off;
static tp_t A30_horn, A30_lube;
static ctr_t A30_pieces, A30_starts, A30_rest;
static bool A30_call, A30_run, A30_fault;
static ton_t A31_start_dly, A31_ready_dly, A31_watchdog;
static tof_t A31_fan_run, A31_lamp_off;
static tp_t A31_horn, A31_lube;
static ctr_t A31_pieces, A31_starts, A31_rest;
static bool A31_call, A31_run, A31_fault;
static ton_t A32_start_dly, A32_ready_dly, A32_watchdog;
static tof_t A32_fan_run, A32_lamp_off;
static tp_t A32_horn, A32_lube;
static ctr_t A32_pieces, A32_starts, A32_rest;
static bool A32_call, A32_run, A32_fault;
static ton_t A33_start_dly, A33_ready_dly, A33_watchdog;
static tof_t A33_fan_run, A33_lamp_off;
static tp_t A33_horn, A33_lube;
static ctr_t A33_pieces, A33_starts, A33_rest;
static bool A33_call, A33_run, A33_fault;
static ton_t A34_start_dly, A34_ready_dly, A34_watchdog;
static tof_t A34_fan_run, A34_lamp_off;
static tp_t A34_horn, A34_lube;
static ctr_t A34_pieces, A34_starts, A34_rest;
static bool A34_call, A34_run, A34_fault;
static ton_t A35_start_dly, A35_ready_dly, A35_watchdog;
static tof_t A35_fan_run, A35_lamp_off;
static tp_t A35_horn, A35_lube;
static ctr_t A35_pieces, A35_starts, A35_rest;
static bool A35_call, A35_run, A35_fault;
static ton_t A36_start_dly, A36_ready_dly, A36_watchdog;
static tof_t A36_fan_run, A36_lamp_off;
static tp_t A36_horn, A36_lube;
static ctr_t A36_pieces, A36_starts, A36_rest;
static bool A36_call, A36_run, A36_fault;
static ton_t A37_start_dly, A37_ready_dly, A37_watchdog;
static tof_t A37_fan_run, A37_lamp_off;
static tp_t A37_horn, A37_lube;
static ctr_t A37_pieces, A37_starts, A37_rest;
static bool A37_call, A37_run, A37_fault;
static ton_t A38_start_dly, A38_ready_dly, A38_watchdog;
static tof_t A38_fan_run, A38_lamp_off;
static tp_t A38_horn, A38_lube;
static ctr_t A38_pieces, A38_starts, A38_rest;
static bool A38_call, A38_run, A38_fault;
static ton_t A39_start_dly, A39_ready_dly, A39_watchdog;
static tof_t A39_fan_run, A39_lamp_off;
static tp_t A39_horn, A39_lube;
static ctr_t A39_pieces, A39_starts, A39_rest;
static bool A39_call, A39_run, A39_fault;
static ton_t A40_start_dly, A40_ready_dly, A40_watchdog;
static tof_t A40_fan_run, A40_lamp_off;
static tp_t A40_horn, A40_lube;
static ctr_t A40_pieces, A40_starts, A40_rest;
static bool A40_call, A40_run, A40_fault;
static ton_t A41_start_dly, A41_ready_dly, A41_watchdog;
static tof_t A41_fan_run, A41_lamp_off;
static tp_t A41_horn, A41_lube;
static ctr_t A41_pieces, A41_starts, A41_rest;
static bool A41_call, A41_run, A41_fault;
static ton_t A42_start_dly, A42_ready_dly, A42_watchdog;
static tof_t A42_fan_run, A42_lamp_off;
static tp_t A42_horn, A42_lube;
static ctr_t A42_pieces, A42_starts, A42_rest;
static bool A42_call, A42_run, A42_fault;
static ton_t A43_start_dly, A43_ready_dly, A43_watchdog;
static tof_t A43_fan_run, A43_lamp_off;
static tp_t A43_horn, A43_lube;
static ctr_t A43_pieces, A43_starts, A43_rest;
static bool A43_call, A43_run, A43_fault;
static ton_t A44_start_dly, A44_ready_dly, A44_watchdog;
static tof_t A44_fan_run, A44_lamp_off;
static tp_t A44_horn, A44_lube;
static ctr_t A44_pieces, A44_starts, A44_rest;
static bool A44_call, A44_run, A44_fault;
static ton_t A45_start_dly, A45_ready_dly, A45_watchdog;
static tof_t A45_fan_run, A45_lamp_off;
static tp_t A45_horn, A45_lube;
static ctr_t A45_pieces, A45_starts, A45_rest;
static bool A45_call, A45_run, A45_fault;
static ton_t A46_start_dly, A46_ready_dly, A46_watchdog;
static tof_t A46_fan_run, A46_lamp_off;
static tp_t A46_horn, A46_lube;
static ctr_t A46_pieces, A46_starts, A46_rest;
static bool A46_call, A46_run, A46_fault;
static ton_t A47_start_dly, A47_ready_dly, A47_watchdog;
static tof_t A47_fan_run, A47_lamp_off;
static tp_t A47_horn, A47_lube;
static ctr_t A47_pieces, A47_starts, A47_rest;
static bool A47_call, A47_run, A47_fault;
static ton_t A48_start_dly, A48_ready_dly, A48_watchdog;
static tof_t A48_fan_run, A48_lamp_off;
static tp_t A48_horn, A48_lube;
static ctr_t A48_pieces, A48_starts, A48_rest;
static bool A48_call, A48_run, A48_fault;
static ton_t A49_start_dly, A49_ready_dly, A49_watchdog;
static tof_t A49_fan_run, A49_lamp_off;
static tp_t A49_horn, A49_lube;
static ctr_t A49_pieces, A49_starts, A49_rest;
static bool A49_call, A49_run, A49_fault;
static ton_t A50_start_dly, A50_ready_dly, A50_watchdog;
static tof_t A50_fan_run, A50_lamp_off;
static tp_t A50_horn, A50_lube;
static ctr_t A50_pieces, A50_starts, A50_rest;
static bool A50_call, A50_run, A50_fault;
void scan(void)
{
    int32_t s = 0;
    clk = (clk + 1) % 1000000;

    /* machine 1 */
    A01_call = clk % 43 < 28;
    ton(&A01_start_dly, A01_call && !A01_fault, 11);
    ton(&A01_ready_dly, A01_start_dly.q && !A50_fault, 32);
    A01_run = A01_start_dly.q;
    tof(&A01_fan_run, A01_run, 32);
    tof(&A01_lamp_off, A01_ready_dly.q || A01_fan_run.q, 16);
    tp(&A01_horn, A01_call, 9);
    tp(&A01_lube, A01_ready_dly.q, 21);
    ctu(&A01_starts, A01_run, A01_starts.q, 4);
    ctu(&A01_pieces, A01_horn.q || A01_lube.q, A01_starts.q, 50);
    ctd(&A01_rest, A01_lube.q, A01_rest.q, 5);
    ton(&A01_watchdog, A01_run && !A01_lube.q, 103);
    A01_fault = A01_watchdog.q;
    if (A01_lamp_off.q) s += 1;
    s += A01_pieces.cv + A01_rest.cv;

    /* machine 2 */
    A02_call = clk % 46 < 30;
    ton(&A02_start_dly, A02_call && !A02_fault, 12);
    ton(&A02_ready_dly, A02_start_dly.q && !A01_fault, 39);
    A02_run = A02_start_dly.q;
    tof(&A02_fan_run, A02_run, 34);
    tof(&A02_lamp_off, A02_ready_dly.q || A02_fan_run.q, 17);
    tp(&A02_horn, A02_call, 10);
    tp(&A02_lube, A02_ready_dly.q, 22);
    ctu(&A02_starts, A02_run, A02_starts.q, 5);
    ctu(&A02_pieces, A02_horn.q || A02_lube.q, A02_starts.q, 50);
    ctd(&A02_rest, A02_lube.q, A02_rest.q, 6);
    ton(&A02_watchdog, A02_run && !A02_lube.q, 106);
    A02_fault = A02_watchdog.q;
    if (A02_lamp_off.q) s += 2;
    s += A02_pieces.cv + A02_rest.cv;

    /* machine 3 */
    A03_call = clk % 49 < 32;
    ton(&A03_start_dly, A03_call && !A03_fault, 13);
    ton(&A03_ready_dly, A03_start_dly.q && !A02_fault, 46);
    A03_run = A03_start_dly.q;
    tof(&A03_fan_run, A03_run, 36);
    tof(&A03_lamp_off, A03_ready_dly.q || A03_fan_run.q, 18);
    tp(&A03_horn, A03_call, 11);
    tp(&A03_lube, A03_ready_dly.q, 23);
    ctu(&A03_starts, A03_run, A03_starts.q, 6);
    ctu(&A03_pieces, A03_horn.q || A03_lube.q, A03_starts.q, 50);
    ctd(&A03_rest, A03_lube.q, A03_rest.q, 7);
    ton(&A03_watchdog, A03_run && !A03_lube.q, 109);
    A03_fault = A03_watchdog.q;
    if (A03_lamp_off.q) s += 3;
    s += A03_pieces.cv + A03_rest.cv;

    /* machine 4 */
    A04_call = clk % 52 < 34;
    ton(&A04_start_dly, A04_call && !A04_fault, 14);
    ton(&A04_ready_dly, A04_start_dly.q && !A03_fault, 53);
    A04_run = A04_start_dly.q;
    tof(&A04_fan_run, A04_run, 38);
    tof(&A04_lamp_off, A04_ready_dly.q || A04_fan_run.q, 19);
    tp(&A04_horn, A04_call, 12);
    tp(&A04_lube, A04_ready_dly.q, 24);
    ctu(&A04_starts, A04_run, A04_starts.q, 7);
    ctu(&A04_pieces, A04_horn.q || A04_lube.q, A04_starts.q, 50);
    ctd(&A04_rest, A04_lube.q, A04_rest.q, 8);
    ton(&A04_watchdog, A04_run && !A04_lube.q, 112);
    A04_fault = A04_watchdog.q;
    if (A04_lamp_off.q) s += 4;
    s += A04_pieces.cv + A04_rest.cv;

    /* machine 5 */
    A05_call = clk % 55 < 36;
    ton(&A05_start_dly, A05_call && !A05_fault, 15);
    ton(&A05_ready_dly, A05_start_dly.q && !A04_fault, 60);
    A05_run = A05_start_dly.q;
    tof(&A05_fan_run, A05_run, 40);
    tof(&A05_lamp_off, A05_ready_dly.q || A05_fan_run.q, 20);
    tp(&A05_horn, A05_call, 13);
    tp(&A05_lube, A05_ready_dly.q, 25);
    ctu(&A05_starts, A05_run, A05_starts.q, 3);
    ctu(&A05_pieces, A05_horn.q || A05_lube.q, A05_starts.q, 50);
    ctd(&A05_rest, A05_lube.q, A05_rest.q, 9);
    ton(&A05_watchdog, A05_run && !A05_lube.q, 115);
    A05_fault = A05_watchdog.q;
    if (A05_lamp_off.q) s += 5;
    s += A05_pieces.cv + A05_rest.cv;

    /* machine 6 */
    A06_call = clk % 58 < 38;
    ton(&A06_start_dly, A06_call && !A06_fault, 16);
    ton(&A06_ready_dly, A06_start_dly.q && !A05_fault, 27);
    A06_run = A06_start_dly.q;
    tof(&A06_fan_run, A06_run, 42);
    tof(&A06_lamp_off, A06_ready_dly.q || A06_fan_run.q, 21);
    tp(&A06_horn, A06_call, 14);
    tp(&A06_lube, A06_ready_dly.q, 26);
    ctu(&A06_starts, A06_run, A06_starts.q, 4);
    ctu(&A06_pieces, A06_horn.q || A06_lube.q, A06_starts.q, 50);
    ctd(&A06_rest, A06_lube.q, A06_rest.q, 10);
    ton(&A06_watchdog, A06_run && !A06_lube.q, 118);
    A06_fault = A06_watchdog.q;
    if (A06_lamp_off.q) s += 6;
    s += A06_pieces.cv + A06_rest.cv;

    /* machine 7 */
    A07_call = clk % 61 < 40;
    ton(&A07_start_dly, A07_call && !A07_fault, 17);
    ton(&A07_ready_dly, A07_start_dly.q && !A06_fault, 34);
    A07_run = A07_start_dly.q;
    tof(&A07_fan_run, A07_run, 44);
    tof(&A07_lamp_off, A07_ready_dly.q || A07_fan_run.q, 22);
    tp(&A07_horn, A07_call, 15);
    tp(&A07_lube, A07_ready_dly.q, 27);
    ctu(&A07_starts, A07_run, A07_starts.q, 5);
    ctu(&A07_pieces, A07_horn.q || A07_lube.q, A07_starts.q, 50);
    ctd(&A07_rest, A07_lube.q, A07_rest.q, 4);
    ton(&A07_watchdog, A07_run && !A07_lube.q, 121);
    A07_fault = A07_watchdog.q;
    if (A07_lamp_off.q) s += 7;
    s += A07_pieces.cv + A07_rest.cv;

    /* machine 8 */
    A08_call = clk % 64 < 42;
    ton(&A08_start_dly, A08_call && !A08_fault, 18);
    ton(&A08_ready_dly, A08_start_dly.q && !A07_fault, 41);
    A08_run = A08_start_dly.q;
    tof(&A08_fan_run, A08_run, 46);
    tof(&A08_lamp_off, A08_ready_dly.q || A08_fan_run.q, 23);
    tp(&A08_horn, A08_call, 16);
    tp(&A08_lube, A08_ready_dly.q, 28);
    ctu(&A08_starts, A08_run, A08_starts.q, 6);
    ctu(&A08_pieces, A08_horn.q || A08_lube.q, A08_starts.q, 50);
    ctd(&A08_rest, A08_lube.q, A08_rest.q, 5);
    ton(&A08_watchdog, A08_run && !A08_lube.q, 124);
    A08_fault = A08_watchdog.q;
    if (A08_lamp_off.q) s += 8;
    s += A08_pieces.cv + A08_rest.cv;

    /* machine 9 */
    A09_call = clk % 67 < 44;
    ton(&A09_start_dly, A09_call && !A09_fault, 19);
    ton(&A09_ready_dly, A09_start_dly.q && !A08_fault, 48);
    A09_run = A09_start_dly.q;
    tof(&A09_fan_run, A09_run, 48);
    tof(&A09_lamp_off, A09_ready_dly.q || A09_fan_run.q, 24);
    tp(&A09_horn, A09_call, 8);
    tp(&A09_lube, A09_ready_dly.q, 29);
    ctu(&A09_starts, A09_run, A09_starts.q, 7);
    ctu(&A09_pieces, A09_horn.q || A09_lube.q, A09_starts.q, 50);
    ctd(&A09_rest, A09_lube.q, A09_rest.q, 6);
    ton(&A09_watchdog, A09_run && !A09_lube.q, 127);
    A09_fault = A09_watchdog.q;
    if (A09_lamp_off.q) s += 9;
    s += A09_pieces.cv + A09_rest.cv;

    /* machine 10 */
    A10_call = clk % 70 < 46;
    ton(&A10_start_dly, A10_call && !A10_fault, 20);
    ton(&A10_ready_dly, A10_start_dly.q && !A09_fault, 55);
    A10_run = A10_start_dly.q;
    tof(&A10_fan_run, A10_run, 50);
    tof(&A10_lamp_off, A10_ready_dly.q || A10_fan_run.q, 25);
    tp(&A10_horn, A10_call, 9);
    tp(&A10_lube, A10_ready_dly.q, 30);
    ctu(&A10_starts, A10_run, A10_starts.q, 3);
    ctu(&A10_pieces, A10_horn.q || A10_lube.q, A10_starts.q, 50);
    ctd(&A10_rest, A10_lube.q, A10_rest.q, 7);
    ton(&A10_watchdog, A10_run && !A10_lube.q, 130);
    A10_fault = A10_watchdog.q;
    if (A10_lamp_off.q) s += 10;
    s += A10_pieces.cv + A10_rest.cv;

    /* machine 11 */
    A11_call = clk % 73 < 48;
    ton(&A11_start_dly, A11_call && !A11_fault, 21);
    ton(&A11_ready_dly, A11_start_dly.q && !A10_fault, 62);
    A11_run = A11_start_dly.q;
    tof(&A11_fan_run, A11_run, 52);
    tof(&A11_lamp_off, A11_ready_dly.q || A11_fan_run.q, 15);
    tp(&A11_horn, A11_call, 10);
    tp(&A11_lube, A11_ready_dly.q, 31);
    ctu(&A11_starts, A11_run, A11_starts.q, 4);
    ctu(&A11_pieces, A11_horn.q || A11_lube.q, A11_starts.q, 50);
    ctd(&A11_rest, A11_lube.q, A11_rest.q, 8);
    ton(&A11_watchdog, A11_run && !A11_lube.q, 133);
    A11_fault = A11_watchdog.q;
    if (A11_lamp_off.q) s += 11;
    s += A11_pieces.cv + A11_rest.cv;

    /* machine 12 */
    A12_call = clk % 76 < 50;
    ton(&A12_start_dly, A12_call && !A12_fault, 22);
    ton(&A12_ready_dly, A12_start_dly.q && !A11_fault, 29);
    A12_run = A12_start_dly.q;
    tof(&A12_fan_run, A12_run, 54);
    tof(&A12_lamp_off, A12_ready_dly.q || A12_fan_run.q, 16);
    tp(&A12_horn, A12_call, 11);
    tp(&A12_lube, A12_ready_dly.q, 32);
    ctu(&A12_starts, A12_run, A12_starts.q, 5);
    ctu(&A12_pieces, A12_horn.q || A12_lube.q, A12_starts.q, 50);
    ctd(&A12_rest, A12_lube.q, A12_rest.q, 9);
    ton(&A12_watchdog, A12_run && !A12_lube.q, 136);
    A12_fault = A12_watchdog.q;
    if (A12_lamp_off.q) s += 12;
    s += A12_pieces.cv + A12_rest.cv;

    /* machine 13 */
    A13_call = clk % 79 < 52;
    ton(&A13_start_dly, A13_call && !A13_fault, 23);
    ton(&A13_ready_dly, A13_start_dly.q && !A12_fault, 36);
    A13_run = A13_start_dly.q;
    tof(&A13_fan_run, A13_run, 56);
    tof(&A13_lamp_off, A13_ready_dly.q || A13_fan_run.q, 17);
    tp(&A13_horn, A13_call, 12);
    tp(&A13_lube, A13_ready_dly.q, 33);
    ctu(&A13_starts, A13_run, A13_starts.q, 6);
    ctu(&A13_pieces, A13_horn.q || A13_lube.q, A13_starts.q, 50);
    ctd(&A13_rest, A13_lube.q, A13_rest.q, 10);
    ton(&A13_watchdog, A13_run && !A13_lube.q, 139);
    A13_fault = A13_watchdog.q;
    if (A13_lamp_off.q) s += 13;
    s += A13_pieces.cv + A13_rest.cv;

    /* machine 14 */
    A14_call = clk % 82 < 54;
    ton(&A14_start_dly, A14_call && !A14_fault, 24);
    ton(&A14_ready_dly, A14_start_dly.q && !A13_fault, 43);
    A14_run = A14_start_dly.q;
    tof(&A14_fan_run, A14_run, 58);
    tof(&A14_lamp_off, A14_ready_dly.q || A14_fan_run.q, 18);
    tp(&A14_horn, A14_call, 13);
    tp(&A14_lube, A14_ready_dly.q, 34);
    ctu(&A14_starts, A14_run, A14_starts.q, 7);
    ctu(&A14_pieces, A14_horn.q || A14_lube.q, A14_starts.q, 50);
    ctd(&A14_rest, A14_lube.q, A14_rest.q, 4);
    ton(&A14_watchdog, A14_run && !A14_lube.q, 142);
    A14_fault = A14_watchdog.q;
    if (A14_lamp_off.q) s += 14;
    s += A14_pieces.cv + A14_rest.cv;

    /* machine 15 */
    A15_call = clk % 85 < 56;
    ton(&A15_start_dly, A15_call && !A15_fault, 25);
    ton(&A15_ready_dly, A15_start_dly.q && !A14_fault, 50);
    A15_run = A15_start_dly.q;
    tof(&A15_fan_run, A15_run, 60);
    tof(&A15_lamp_off, A15_ready_dly.q || A15_fan_run.q, 19);
    tp(&A15_horn, A15_call, 14);
    tp(&A15_lube, A15_ready_dly.q, 35);
    ctu(&A15_starts, A15_run, A15_starts.q, 3);
    ctu(&A15_pieces, A15_horn.q || A15_lube.q, A15_starts.q, 50);
    ctd(&A15_rest, A15_lube.q, A15_rest.q, 5);
    ton(&A15_watchdog, A15_run && !A15_lube.q, 145);
    A15_fault = A15_watchdog.q;
    if (A15_lamp_off.q) s += 15;
    s += A15_pieces.cv + A15_rest.cv;

    /* machine 16 */
    A16_call = clk % 88 < 58;
    ton(&A16_start_dly, A16_call && !A16_fault, 26);
    ton(&A16_ready_dly, A16_start_dly.q && !A15_fault, 57);
    A16_run = A16_start_dly.q;
    tof(&A16_fan_run, A16_run, 62);
    tof(&A16_lamp_off, A16_ready_dly.q || A16_fan_run.q, 20);
    tp(&A16_horn, A16_call, 15);
    tp(&A16_lube, A16_ready_dly.q, 36);
    ctu(&A16_starts, A16_run, A16_starts.q, 4);
    ctu(&A16_pieces, A16_horn.q || A16_lube.q, A16_starts.q, 50);
    ctd(&A16_rest, A16_lube.q, A16_rest.q, 6);
    ton(&A16_watchdog, A16_run && !A16_lube.q, 148);
    A16_fault = A16_watchdog.q;
    if (A16_lamp_off.q) s += 16;
    s += A16_pieces.cv + A16_rest.cv;

    /* machine 17 */
    A17_call = clk % 91 < 60;
    ton(&A17_start_dly, A17_call && !A17_fault, 27);
    ton(&A17_ready_dly, A17_start_dly.q && !A16_fault, 64);
    A17_run = A17_start_dly.q;
    tof(&A17_fan_run, A17_run, 64);
    tof(&A17_lamp_off, A17_ready_dly.q || A17_fan_run.q, 21);
    tp(&A17_horn, A17_call, 16);
    tp(&A17_lube, A17_ready_dly.q, 37);
    ctu(&A17_starts, A17_run, A17_starts.q, 5);
    ctu(&A17_pieces, A17_horn.q || A17_lube.q, A17_starts.q, 50);
    ctd(&A17_rest, A17_lube.q, A17_rest.q, 7);
    ton(&A17_watchdog, A17_run && !A17_lube.q, 151);
    A17_fault = A17_watchdog.q;
    if (A17_lamp_off.q) s += 17;
    s += A17_pieces.cv + A17_rest.cv;

    /* machine 18 */
    A18_call = clk % 94 < 62;
    ton(&A18_start_dly, A18_call && !A18_fault, 28);
    ton(&A18_ready_dly, A18_start_dly.q && !A17_fault, 31);
    A18_run = A18_start_dly.q;
    tof(&A18_fan_run, A18_run, 66);
    tof(&A18_lamp_off, A18_ready_dly.q || A18_fan_run.q, 22);
    tp(&A18_horn, A18_call, 8);
    tp(&A18_lube, A18_ready_dly.q, 38);
    ctu(&A18_starts, A18_run, A18_starts.q, 6);
    ctu(&A18_pieces, A18_horn.q || A18_lube.q, A18_starts.q, 50);
    ctd(&A18_rest, A18_lube.q, A18_rest.q, 8);
    ton(&A18_watchdog, A18_run && !A18_lube.q, 154);
    A18_fault = A18_watchdog.q;
    if (A18_lamp_off.q) s += 18;
    s += A18_pieces.cv + A18_rest.cv;

    /* machine 19 */
    A19_call = clk % 97 < 64;
    ton(&A19_start_dly, A19_call && !A19_fault, 29);
    ton(&A19_ready_dly, A19_start_dly.q && !A18_fault, 38);
    A19_run = A19_start_dly.q;
    tof(&A19_fan_run, A19_run, 68);
    tof(&A19_lamp_off, A19_ready_dly.q || A19_fan_run.q, 23);
    tp(&A19_horn, A19_call, 9);
    tp(&A19_lube, A19_ready_dly.q, 39);
    ctu(&A19_starts, A19_run, A19_starts.q, 7);
    ctu(&A19_pieces, A19_horn.q || A19_lube.q, A19_starts.q, 50);
    ctd(&A19_rest, A19_lube.q, A19_rest.q, 9);
    ton(&A19_watchdog, A19_run && !A19_lube.q, 157);
    A19_fault = A19_watchdog.q;
    if (A19_lamp_off.q) s += 19;
    s += A19_pieces.cv + A19_rest.cv;

    /* machine 20 */
    A20_call = clk % 100 < 66;
    ton(&A20_start_dly, A20_call && !A20_fault, 30);
    ton(&A20_ready_dly, A20_start_dly.q && !A19_fault, 45);
    A20_run = A20_start_dly.q;
    tof(&A20_fan_run, A20_run, 70);
    tof(&A20_lamp_off, A20_ready_dly.q || A20_fan_run.q, 24);
    tp(&A20_horn, A20_call, 10);
    tp(&A20_lube, A20_ready_dly.q, 40);
    ctu(&A20_starts, A20_run, A20_starts.q, 3);
    ctu(&A20_pieces, A20_horn.q || A20_lube.q, A20_starts.q, 50);
    ctd(&A20_rest, A20_lube.q, A20_rest.q, 10);
    ton(&A20_watchdog, A20_run && !A20_lube.q, 160);
    A20_fault = A20_watchdog.q;
    if (A20_lamp_off.q) s += 20;
    s += A20_pieces.cv + A20_rest.cv;

    /* machine 21 */
    A21_call = clk % 103 < 68;
    ton(&A21_start_dly, A21_call && !A21_fault, 31);
    ton(&A21_ready_dly, A21_start_dly.q && !A20_fault, 52);
    A21_run = A21_start_dly.q;
    tof(&A21_fan_run, A21_run, 72);
    tof(&A21_lamp_off, A21_ready_dly.q || A21_fan_run.q, 25);
    tp(&A21_horn, A21_call, 11);
    tp(&A21_lube, A21_ready_dly.q, 41);
    ctu(&A21_starts, A21_run, A21_starts.q, 4);
    ctu(&A21_pieces, A21_horn.q || A21_lube.q, A21_starts.q, 50);
    ctd(&A21_rest, A21_lube.q, A21_rest.q, 4);
    ton(&A21_watchdog, A21_run && !A21_lube.q, 163);
    A21_fault = A21_watchdog.q;
    if (A21_lamp_off.q) s += 21;
    s += A21_pieces.cv + A21_rest.cv;

    /* machine 22 */
    A22_call = clk % 106 < 70;
    ton(&A22_start_dly, A22_call && !A22_fault, 32);
    ton(&A22_ready_dly, A22_start_dly.q && !A21_fault, 59);
    A22_run = A22_start_dly.q;
    tof(&A22_fan_run, A22_run, 74);
    tof(&A22_lamp_off, A22_ready_dly.q || A22_fan_run.q, 15);
    tp(&A22_horn, A22_call, 12);
    tp(&A22_lube, A22_ready_dly.q, 42);
    ctu(&A22_starts, A22_run, A22_starts.q, 5);
    ctu(&A22_pieces, A22_horn.q || A22_lube.q, A22_starts.q, 50);
    ctd(&A22_rest, A22_lube.q, A22_rest.q, 5);
    ton(&A22_watchdog, A22_run && !A22_lube.q, 166);
    A22_fault = A22_watchdog.q;
    if (A22_lamp_off.q) s += 22;
    s += A22_pieces.cv + A22_rest.cv;

    /* machine 23 */
    A23_call = clk % 109 < 72;
    ton(&A23_start_dly, A23_call && !A23_fault, 33);
    ton(&A23_ready_dly, A23_start_dly.q && !A22_fault, 26);
    A23_run = A23_start_dly.q;
    tof(&A23_fan_run, A23_run, 76);
    tof(&A23_lamp_off, A23_ready_dly.q || A23_fan_run.q, 16);
    tp(&A23_horn, A23_call, 13);
    tp(&A23_lube, A23_ready_dly.q, 43);
    ctu(&A23_starts, A23_run, A23_starts.q, 6);
    ctu(&A23_pieces, A23_horn.q || A23_lube.q, A23_starts.q, 50);
    ctd(&A23_rest, A23_lube.q, A23_rest.q, 6);
    ton(&A23_watchdog, A23_run && !A23_lube.q, 169);
    A23_fault = A23_watchdog.q;
    if (A23_lamp_off.q) s += 23;
    s += A23_pieces.cv + A23_rest.cv;

    /* machine 24 */
    A24_call = clk % 112 < 74;
    ton(&A24_start_dly, A24_call && !A24_fault, 34);
    ton(&A24_ready_dly, A24_start_dly.q && !A23_fault, 33);
    A24_run = A24_start_dly.q;
    tof(&A24_fan_run, A24_run, 78);
    tof(&A24_lamp_off, A24_ready_dly.q || A24_fan_run.q, 17);
    tp(&A24_horn, A24_call, 14);
    tp(&A24_lube, A24_ready_dly.q, 44);
    ctu(&A24_starts, A24_run, A24_starts.q, 7);
    ctu(&A24_pieces, A24_horn.q || A24_lube.q, A24_starts.q, 50);
    ctd(&A24_rest, A24_lube.q, A24_rest.q, 7);
    ton(&A24_watchdog, A24_run && !A24_lube.q, 172);
    A24_fault = A24_watchdog.q;
    if (A24_lamp_off.q) s += 24;
    s += A24_pieces.cv + A24_rest.cv;

    /* machine 25 */
    A25_call = clk % 115 < 76;
    ton(&A25_start_dly, A25_call && !A25_fault, 35);
    ton(&A25_ready_dly, A25_start_dly.q && !A24_fault, 40);
    A25_run = A25_start_dly.q;
    tof(&A25_fan_run, A25_run, 80);
    tof(&A25_lamp_off, A25_ready_dly.q || A25_fan_run.q, 18);
    tp(&A25_horn, A25_call, 15);
    tp(&A25_lube, A25_ready_dly.q, 45);
    ctu(&A25_starts, A25_run, A25_starts.q, 3);
    ctu(&A25_pieces, A25_horn.q || A25_lube.q, A25_starts.q, 50);
    ctd(&A25_rest, A25_lube.q, A25_rest.q, 8);
    ton(&A25_watchdog, A25_run && !A25_lube.q, 175);
    A25_fault = A25_watchdog.q;
    if (A25_lamp_off.q) s += 25;
    s += A25_pieces.cv + A25_rest.cv;

    /* machine 26 */
    A26_call = clk % 118 < 78;
    ton(&A26_start_dly, A26_call && !A26_fault, 36);
    ton(&A26_ready_dly, A26_start_dly.q && !A25_fault, 47);
    A26_run = A26_start_dly.q;
    tof(&A26_fan_run, A26_run, 82);
    tof(&A26_lamp_off, A26_ready_dly.q || A26_fan_run.q, 19);
    tp(&A26_horn, A26_call, 16);
    tp(&A26_lube, A26_ready_dly.q, 46);
    ctu(&A26_starts, A26_run, A26_starts.q, 4);
    ctu(&A26_pieces, A26_horn.q || A26_lube.q, A26_starts.q, 50);
    ctd(&A26_rest, A26_lube.q, A26_rest.q, 9);
    ton(&A26_watchdog, A26_run && !A26_lube.q, 178);
    A26_fault = A26_watchdog.q;
    if (A26_lamp_off.q) s += 26;
    s += A26_pieces.cv + A26_rest.cv;

    /* machine 27 */
    A27_call = clk % 121 < 80;
    ton(&A27_start_dly, A27_call && !A27_fault, 37);
    ton(&A27_ready_dly, A27_start_dly.q && !A26_fault, 54);
    A27_run = A27_start_dly.q;
    tof(&A27_fan_run, A27_run, 84);
    tof(&A27_lamp_off, A27_ready_dly.q || A27_fan_run.q, 20);
    tp(&A27_horn, A27_call, 8);
    tp(&A27_lube, A27_ready_dly.q, 47);
    ctu(&A27_starts, A27_run, A27_starts.q, 5);
    ctu(&A27_pieces, A27_horn.q || A27_lube.q, A27_starts.q, 50);
    ctd(&A27_rest, A27_lube.q, A27_rest.q, 10);
    ton(&A27_watchdog, A27_run && !A27_lube.q, 181);
    A27_fault = A27_watchdog.q;
    if (A27_lamp_off.q) s += 27;
    s += A27_pieces.cv + A27_rest.cv;

    /* machine 28 */
    A28_call = clk % 124 < 82;
    ton(&A28_start_dly, A28_call && !A28_fault, 38);
    ton(&A28_ready_dly, A28_start_dly.q && !A27_fault, 61);
    A28_run = A28_start_dly.q;
    tof(&A28_fan_run, A28_run, 86);
    tof(&A28_lamp_off, A28_ready_dly.q || A28_fan_run.q, 21);
    tp(&A28_horn, A28_call, 9);
    tp(&A28_lube, A28_ready_dly.q, 48);
    ctu(&A28_starts, A28_run, A28_starts.q, 6);
    ctu(&A28_pieces, A28_horn.q || A28_lube.q, A28_starts.q, 50);
    ctd(&A28_rest, A28_lube.q, A28_rest.q, 4);
    ton(&A28_watchdog, A28_run && !A28_lube.q, 184);
    A28_fault = A28_watchdog.q;
    if (A28_lamp_off.q) s += 28;
    s += A28_pieces.cv + A28_rest.cv;

    /* machine 29 */
    A29_call = clk % 127 < 84;
    ton(&A29_start_dly, A29_call && !A29_fault, 39);
    ton(&A29_ready_dly, A29_start_dly.q && !A28_fault, 28);
    A29_run = A29_start_dly.q;
    tof(&A29_fan_run, A29_run, 88);
    tof(&A29_lamp_off, A29_ready_dly.q || A29_fan_run.q, 22);
    tp(&A29_horn, A29_call, 10);
    tp(&A29_lube, A29_ready_dly.q, 49);
    ctu(&A29_starts, A29_run, A29_starts.q, 7);
    ctu(&A29_pieces, A29_horn.q || A29_lube.q, A29_starts.q, 50);
    ctd(&A29_rest, A29_lube.q, A29_rest.q, 5);
    ton(&A29_watchdog, A29_run && !A29_lube.q, 187);
    A29_fault = A29_watchdog.q;
    if (A29_lamp_off.q) s += 29;
    s += A29_pieces.cv + A29_rest.cv;

    /* machine 30 */
    A30_call = clk % 130 < 86;
    ton(&A30_start_dly, A30_call && !A30_fault, 40);
    ton(&A30_ready_dly, A30_start_dly.q && !A29_fault, 35);
    A30_run = A30_start_dly.q;
    tof(&A30_fan_run, A30_run, 90);
    tof(&A30_lamp_off, A30_ready_dly.q || A30_fan_run.q, 23);
    tp(&A30_horn, A30_call, 11);
    tp(&A30_lube, A30_ready_dly.q, 50);
    ctu(&A30_starts, A30_run, A30_starts.q, 3);
    ctu(&A30_pieces, A30_horn.q || A30_lube.q, A30_starts.q, 50);
    ctd(&A30_rest, A30_lube.q, A30_rest.q, 6);
    ton(&A30_watchdog, A30_run && !A30_lube.q, 190);
    A30_fault = A30_watchdog.q;
    if (A30_lamp_off.q) s += 30;
    s += A30_pieces.cv + A30_rest.cv;

    /* machine 31 */
    A31_call = clk % 133 < 88;
    ton(&A31_start_dly, A31_call && !A31_fault, 41);
    ton(&A31_ready_dly, A31_start_dly.q && !A30_fault, 42);
    A31_run = A31_start_dly.q;
    tof(&A31_fan_run, A31_run, 92);
    tof(&A31_lamp_off, A31_ready_dly.q || A31_fan_run.q, 24);
    tp(&A31_horn, A31_call, 12);
    tp(&A31_lube, A31_ready_dly.q, 51);
    ctu(&A31_starts, A31_run, A31_starts.q, 4);
    ctu(&A31_pieces, A31_horn.q || A31_lube.q, A31_starts.q, 50);
    ctd(&A31_rest, A31_lube.q, A31_rest.q, 7);
    ton(&A31_watchdog, A31_run && !A31_lube.q, 193);
    A31_fault = A31_watchdog.q;
    if (A31_lamp_off.q) s += 31;
    s += A31_pieces.cv + A31_rest.cv;

    /* machine 32 */
    A32_call = clk % 136 < 90;
    ton(&A32_start_dly, A32_call && !A32_fault, 42);
    ton(&A32_ready_dly, A32_start_dly.q && !A31_fault, 49);
    A32_run = A32_start_dly.q;
    tof(&A32_fan_run, A32_run, 94);
    tof(&A32_lamp_off, A32_ready_dly.q || A32_fan_run.q, 25);
    tp(&A32_horn, A32_call, 13);
    tp(&A32_lube, A32_ready_dly.q, 52);
    ctu(&A32_starts, A32_run, A32_starts.q, 5);
    ctu(&A32_pieces, A32_horn.q || A32_lube.q, A32_starts.q, 50);
    ctd(&A32_rest, A32_lube.q, A32_rest.q, 8);
    ton(&A32_watchdog, A32_run && !A32_lube.q, 196);
    A32_fault = A32_watchdog.q;
    if (A32_lamp_off.q) s += 32;
    s += A32_pieces.cv + A32_rest.cv;

    /* machine 33 */
    A33_call = clk % 139 < 92;
    ton(&A33_start_dly, A33_call && !A33_fault, 43);
    ton(&A33_ready_dly, A33_start_dly.q && !A32_fault, 56);
    A33_run = A33_start_dly.q;
    tof(&A33_fan_run, A33_run, 96);
    tof(&A33_lamp_off, A33_ready_dly.q || A33_fan_run.q, 15);
    tp(&A33_horn, A33_call, 14);
    tp(&A33_lube, A33_ready_dly.q, 53);
    ctu(&A33_starts, A33_run, A33_starts.q, 6);
    ctu(&A33_pieces, A33_horn.q || A33_lube.q, A33_starts.q, 50);
    ctd(&A33_rest, A33_lube.q, A33_rest.q, 9);
    ton(&A33_watchdog, A33_run && !A33_lube.q, 199);
    A33_fault = A33_watchdog.q;
    if (A33_lamp_off.q) s += 33;
    s += A33_pieces.cv + A33_rest.cv;

    /* machine 34 */
    A34_call = clk % 142 < 94;
    ton(&A34_start_dly, A34_call && !A34_fault, 44);
    ton(&A34_ready_dly, A34_start_dly.q && !A33_fault, 63);
    A34_run = A34_start_dly.q;
    tof(&A34_fan_run, A34_run, 98);
    tof(&A34_lamp_off, A34_ready_dly.q || A34_fan_run.q, 16);
    tp(&A34_horn, A34_call, 15);
    tp(&A34_lube, A34_ready_dly.q, 54);
    ctu(&A34_starts, A34_run, A34_starts.q, 7);
    ctu(&A34_pieces, A34_horn.q || A34_lube.q, A34_starts.q, 50);
    ctd(&A34_rest, A34_lube.q, A34_rest.q, 10);
    ton(&A34_watchdog, A34_run && !A34_lube.q, 202);
    A34_fault = A34_watchdog.q;
    if (A34_lamp_off.q) s += 34;
    s += A34_pieces.cv + A34_rest.cv;

    /* machine 35 */
    A35_call = clk % 145 < 96;
    ton(&A35_start_dly, A35_call && !A35_fault, 45);
    ton(&A35_ready_dly, A35_start_dly.q && !A34_fault, 30);
    A35_run = A35_start_dly.q;
    tof(&A35_fan_run, A35_run, 100);
    tof(&A35_lamp_off, A35_ready_dly.q || A35_fan_run.q, 17);
    tp(&A35_horn, A35_call, 16);
    tp(&A35_lube, A35_ready_dly.q, 55);
    ctu(&A35_starts, A35_run, A35_starts.q, 3);
    ctu(&A35_pieces, A35_horn.q || A35_lube.q, A35_starts.q, 50);
    ctd(&A35_rest, A35_lube.q, A35_rest.q, 4);
    ton(&A35_watchdog, A35_run && !A35_lube.q, 205);
    A35_fault = A35_watchdog.q;
    if (A35_lamp_off.q) s += 35;
    s += A35_pieces.cv + A35_rest.cv;

    /* machine 36 */
    A36_call = clk % 148 < 98;
    ton(&A36_start_dly, A36_call && !A36_fault, 46);
    ton(&A36_ready_dly, A36_start_dly.q && !A35_fault, 37);
    A36_run = A36_start_dly.q;
    tof(&A36_fan_run, A36_run, 102);
    tof(&A36_lamp_off, A36_ready_dly.q || A36_fan_run.q, 18);
    tp(&A36_horn, A36_call, 8);
    tp(&A36_lube, A36_ready_dly.q, 56);
    ctu(&A36_starts, A36_run, A36_starts.q, 4);
    ctu(&A36_pieces, A36_horn.q || A36_lube.q, A36_starts.q, 50);
    ctd(&A36_rest, A36_lube.q, A36_rest.q, 5);
    ton(&A36_watchdog, A36_run && !A36_lube.q, 208);
    A36_fault = A36_watchdog.q;
    if (A36_lamp_off.q) s += 36;
    s += A36_pieces.cv + A36_rest.cv;

    /* machine 37 */
    A37_call = clk % 151 < 100;
    ton(&A37_start_dly, A37_call && !A37_fault, 47);
    ton(&A37_ready_dly, A37_start_dly.q && !A36_fault, 44);
    A37_run = A37_start_dly.q;
    tof(&A37_fan_run, A37_run, 104);
    tof(&A37_lamp_off, A37_ready_dly.q || A37_fan_run.q, 19);
    tp(&A37_horn, A37_call, 9);
    tp(&A37_lube, A37_ready_dly.q, 57);
    ctu(&A37_starts, A37_run, A37_starts.q, 5);
    ctu(&A37_pieces, A37_horn.q || A37_lube.q, A37_starts.q, 50);
    ctd(&A37_rest, A37_lube.q, A37_rest.q, 6);
    ton(&A37_watchdog, A37_run && !A37_lube.q, 211);
    A37_fault = A37_watchdog.q;
    if (A37_lamp_off.q) s += 37;
    s += A37_pieces.cv + A37_rest.cv;

    /* machine 38 */
    A38_call = clk % 154 < 102;
    ton(&A38_start_dly, A38_call && !A38_fault, 48);
    ton(&A38_ready_dly, A38_start_dly.q && !A37_fault, 51);
    A38_run = A38_start_dly.q;
    tof(&A38_fan_run, A38_run, 106);
    tof(&A38_lamp_off, A38_ready_dly.q || A38_fan_run.q, 20);
    tp(&A38_horn, A38_call, 10);
    tp(&A38_lube, A38_ready_dly.q, 58);
    ctu(&A38_starts, A38_run, A38_starts.q, 6);
    ctu(&A38_pieces, A38_horn.q || A38_lube.q, A38_starts.q, 50);
    ctd(&A38_rest, A38_lube.q, A38_rest.q, 7);
    ton(&A38_watchdog, A38_run && !A38_lube.q, 214);
    A38_fault = A38_watchdog.q;
    if (A38_lamp_off.q) s += 38;
    s += A38_pieces.cv + A38_rest.cv;

    /* machine 39 */
    A39_call = clk % 157 < 104;
    ton(&A39_start_dly, A39_call && !A39_fault, 49);
    ton(&A39_ready_dly, A39_start_dly.q && !A38_fault, 58);
    A39_run = A39_start_dly.q;
    tof(&A39_fan_run, A39_run, 108);
    tof(&A39_lamp_off, A39_ready_dly.q || A39_fan_run.q, 21);
    tp(&A39_horn, A39_call, 11);
    tp(&A39_lube, A39_ready_dly.q, 59);
    ctu(&A39_starts, A39_run, A39_starts.q, 7);
    ctu(&A39_pieces, A39_horn.q || A39_lube.q, A39_starts.q, 50);
    ctd(&A39_rest, A39_lube.q, A39_rest.q, 8);
    ton(&A39_watchdog, A39_run && !A39_lube.q, 217);
    A39_fault = A39_watchdog.q;
    if (A39_lamp_off.q) s += 39;
    s += A39_pieces.cv + A39_rest.cv;

    /* machine 40 */
    A40_call = clk % 160 < 106;
    ton(&A40_start_dly, A40_call && !A40_fault, 50);
    ton(&A40_ready_dly, A40_start_dly.q && !A39_fault, 25);
    A40_run = A40_start_dly.q;
    tof(&A40_fan_run, A40_run, 110);
    tof(&A40_lamp_off, A40_ready_dly.q || A40_fan_run.q, 22);
    tp(&A40_horn, A40_call, 12);
    tp(&A40_lube, A40_ready_dly.q, 60);
    ctu(&A40_starts, A40_run, A40_starts.q, 3);
    ctu(&A40_pieces, A40_horn.q || A40_lube.q, A40_starts.q, 50);
    ctd(&A40_rest, A40_lube.q, A40_rest.q, 9);
    ton(&A40_watchdog, A40_run && !A40_lube.q, 220);
    A40_fault = A40_watchdog.q;
    if (A40_lamp_off.q) s += 40;
    s += A40_pieces.cv + A40_rest.cv;

    /* machine 41 */
    A41_call = clk % 163 < 108;
    ton(&A41_start_dly, A41_call && !A41_fault, 51);
    ton(&A41_ready_dly, A41_start_dly.q && !A40_fault, 32);
    A41_run = A41_start_dly.q;
    tof(&A41_fan_run, A41_run, 112);
    tof(&A41_lamp_off, A41_ready_dly.q || A41_fan_run.q, 23);
    tp(&A41_horn, A41_call, 13);
    tp(&A41_lube, A41_ready_dly.q, 61);
    ctu(&A41_starts, A41_run, A41_starts.q, 4);
    ctu(&A41_pieces, A41_horn.q || A41_lube.q, A41_starts.q, 50);
    ctd(&A41_rest, A41_lube.q, A41_rest.q, 10);
    ton(&A41_watchdog, A41_run && !A41_lube.q, 223);
    A41_fault = A41_watchdog.q;
    if (A41_lamp_off.q) s += 41;
    s += A41_pieces.cv + A41_rest.cv;

    /* machine 42 */
    A42_call = clk % 166 < 110;
    ton(&A42_start_dly, A42_call && !A42_fault, 52);
    ton(&A42_ready_dly, A42_start_dly.q && !A41_fault, 39);
    A42_run = A42_start_dly.q;
    tof(&A42_fan_run, A42_run, 114);
    tof(&A42_lamp_off, A42_ready_dly.q || A42_fan_run.q, 24);
    tp(&A42_horn, A42_call, 14);
    tp(&A42_lube, A42_ready_dly.q, 62);
    ctu(&A42_starts, A42_run, A42_starts.q, 5);
    ctu(&A42_pieces, A42_horn.q || A42_lube.q, A42_starts.q, 50);
    ctd(&A42_rest, A42_lube.q, A42_rest.q, 4);
    ton(&A42_watchdog, A42_run && !A42_lube.q, 226);
    A42_fault = A42_watchdog.q;
    if (A42_lamp_off.q) s += 42;
    s += A42_pieces.cv + A42_rest.cv;

    /* machine 43 */
    A43_call = clk % 169 < 112;
    ton(&A43_start_dly, A43_call && !A43_fault, 53);
    ton(&A43_ready_dly, A43_start_dly.q && !A42_fault, 46);
    A43_run = A43_start_dly.q;
    tof(&A43_fan_run, A43_run, 116);
    tof(&A43_lamp_off, A43_ready_dly.q || A43_fan_run.q, 25);
    tp(&A43_horn, A43_call, 15);
    tp(&A43_lube, A43_ready_dly.q, 63);
    ctu(&A43_starts, A43_run, A43_starts.q, 6);
    ctu(&A43_pieces, A43_horn.q || A43_lube.q, A43_starts.q, 50);
    ctd(&A43_rest, A43_lube.q, A43_rest.q, 5);
    ton(&A43_watchdog, A43_run && !A43_lube.q, 229);
    A43_fault = A43_watchdog.q;
    if (A43_lamp_off.q) s += 43;
    s += A43_pieces.cv + A43_rest.cv;

    /* machine 44 */
    A44_call = clk % 172 < 114;
    ton(&A44_start_dly, A44_call && !A44_fault, 54);
    ton(&A44_ready_dly, A44_start_dly.q && !A43_fault, 53);
    A44_run = A44_start_dly.q;
    tof(&A44_fan_run, A44_run, 118);
    tof(&A44_lamp_off, A44_ready_dly.q || A44_fan_run.q, 15);
    tp(&A44_horn, A44_call, 16);
    tp(&A44_lube, A44_ready_dly.q, 64);
    ctu(&A44_starts, A44_run, A44_starts.q, 7);
    ctu(&A44_pieces, A44_horn.q || A44_lube.q, A44_starts.q, 50);
    ctd(&A44_rest, A44_lube.q, A44_rest.q, 6);
    ton(&A44_watchdog, A44_run && !A44_lube.q, 232);
    A44_fault = A44_watchdog.q;
    if (A44_lamp_off.q) s += 44;
    s += A44_pieces.cv + A44_rest.cv;

    /* machine 45 */
    A45_call = clk % 175 < 116;
    ton(&A45_start_dly, A45_call && !A45_fault, 55);
    ton(&A45_ready_dly, A45_start_dly.q && !A44_fault, 60);
    A45_run = A45_start_dly.q;
    tof(&A45_fan_run, A45_run, 120);
    tof(&A45_lamp_off, A45_ready_dly.q || A45_fan_run.q, 16);
    tp(&A45_horn, A45_call, 8);
    tp(&A45_lube, A45_ready_dly.q, 65);
    ctu(&A45_starts, A45_run, A45_starts.q, 3);
    ctu(&A45_pieces, A45_horn.q || A45_lube.q, A45_starts.q, 50);
    ctd(&A45_rest, A45_lube.q, A45_rest.q, 7);
    ton(&A45_watchdog, A45_run && !A45_lube.q, 235);
    A45_fault = A45_watchdog.q;
    if (A45_lamp_off.q) s += 45;
    s += A45_pieces.cv + A45_rest.cv;

    /* machine 46 */
    A46_call = clk % 178 < 118;
    ton(&A46_start_dly, A46_call && !A46_fault, 56);
    ton(&A46_ready_dly, A46_start_dly.q && !A45_fault, 27);
    A46_run = A46_start_dly.q;
    tof(&A46_fan_run, A46_run, 122);
    tof(&A46_lamp_off, A46_ready_dly.q || A46_fan_run.q, 17);
    tp(&A46_horn, A46_call, 9);
    tp(&A46_lube, A46_ready_dly.q, 66);
    ctu(&A46_starts, A46_run, A46_starts.q, 4);
    ctu(&A46_pieces, A46_horn.q || A46_lube.q, A46_starts.q, 50);
    ctd(&A46_rest, A46_lube.q, A46_rest.q, 8);
    ton(&A46_watchdog, A46_run && !A46_lube.q, 238);
    A46_fault = A46_watchdog.q;
    if (A46_lamp_off.q) s += 46;
    s += A46_pieces.cv + A46_rest.cv;

    /* machine 47 */
    A47_call = clk % 181 < 120;
    ton(&A47_start_dly, A47_call && !A47_fault, 57);
    ton(&A47_ready_dly, A47_start_dly.q && !A46_fault, 34);
    A47_run = A47_start_dly.q;
    tof(&A47_fan_run, A47_run, 124);
    tof(&A47_lamp_off, A47_ready_dly.q || A47_fan_run.q, 18);
    tp(&A47_horn, A47_call, 10);
    tp(&A47_lube, A47_ready_dly.q, 67);
    ctu(&A47_starts, A47_run, A47_starts.q, 5);
    ctu(&A47_pieces, A47_horn.q || A47_lube.q, A47_starts.q, 50);
    ctd(&A47_rest, A47_lube.q, A47_rest.q, 9);
    ton(&A47_watchdog, A47_run && !A47_lube.q, 241);
    A47_fault = A47_watchdog.q;
    if (A47_lamp_off.q) s += 47;
    s += A47_pieces.cv + A47_rest.cv;

    /* machine 48 */
    A48_call = clk % 184 < 122;
    ton(&A48_start_dly, A48_call && !A48_fault, 58);
    ton(&A48_ready_dly, A48_start_dly.q && !A47_fault, 41);
    A48_run = A48_start_dly.q;
    tof(&A48_fan_run, A48_run, 126);
    tof(&A48_lamp_off, A48_ready_dly.q || A48_fan_run.q, 19);
    tp(&A48_horn, A48_call, 11);
    tp(&A48_lube, A48_ready_dly.q, 68);
    ctu(&A48_starts, A48_run, A48_starts.q, 6);
    ctu(&A48_pieces, A48_horn.q || A48_lube.q, A48_starts.q, 50);
    ctd(&A48_rest, A48_lube.q, A48_rest.q, 10);
    ton(&A48_watchdog, A48_run && !A48_lube.q, 244);
    A48_fault = A48_watchdog.q;
    if (A48_lamp_off.q) s += 48;
    s += A48_pieces.cv + A48_rest.cv;

    /* machine 49 */
    A49_call = clk % 187 < 124;
    ton(&A49_start_dly, A49_call && !A49_fault, 59);
    ton(&A49_ready_dly, A49_start_dly.q && !A48_fault, 48);
    A49_run = A49_start_dly.q;
    tof(&A49_fan_run, A49_run, 128);
    tof(&A49_lamp_off, A49_ready_dly.q || A49_fan_run.q, 20);
    tp(&A49_horn, A49_call, 12);
    tp(&A49_lube, A49_ready_dly.q, 69);
    ctu(&A49_starts, A49_run, A49_starts.q, 7);
    ctu(&A49_pieces, A49_horn.q || A49_lube.q, A49_starts.q, 50);
    ctd(&A49_rest, A49_lube.q, A49_rest.q, 4);
    ton(&A49_watchdog, A49_run && !A49_lube.q, 247);
    A49_fault = A49_watchdog.q;
    if (A49_lamp_off.q) s += 49;
    s += A49_pieces.cv + A49_rest.cv;

    /* machine 50 */
    A50_call = clk % 190 < 126;
    ton(&A50_start_dly, A50_call && !A50_fault, 60);
    ton(&A50_ready_dly, A50_start_dly.q && !A49_fault, 55);
    A50_run = A50_start_dly.q;
    tof(&A50_fan_run, A50_run, 130);
    tof(&A50_lamp_off, A50_ready_dly.q || A50_fan_run.q, 21);
    tp(&A50_horn, A50_call, 13);
    tp(&A50_lube, A50_ready_dly.q, 70);
    ctu(&A50_starts, A50_run, A50_starts.q, 3);
    ctu(&A50_pieces, A50_horn.q || A50_lube.q, A50_starts.q, 50);
    ctd(&A50_rest, A50_lube.q, A50_rest.q, 5);
    ton(&A50_watchdog, A50_run && !A50_lube.q, 250);
    A50_fault = A50_watchdog.q;
    if (A50_lamp_off.q) s += 50;
    s += A50_pieces.cv + A50_rest.cv;
    check = (check % 100003) * 5 + s;
}
