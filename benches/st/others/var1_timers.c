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
static ton_t ton_[100]; static tof_t tof_[100]; static tp_t tp_[100]; static ctr_t ctu_[100], ctd_[100];
static bool in[100], ready; static int32_t pt[100], scan_no; static int16_t pv[100];
void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 100; i++) { pt[i] = 5 + 3 * i; pv[i] = (int16_t)(2 + i % 9); }
        ready = true;
    }
    for (int i = 0; i < 100; i++)
        in[i] = (scan_no / (2 + i % 13)) % 3 == 0;
    int32_t n = 0, et = 0;
    for (int i = 0; i < 100; i++) {
        ton(&ton_[i], in[i], pt[i]);
        tof(&tof_[i], ton_[i].q, pt[i]);
        tp(&tp_[i], in[i], pt[99 - i]);
        ctu(&ctu_[i], tp_[i].q, ctu_[i].q, pv[i]);
        ctd(&ctd_[i], tof_[i].q, ctd_[i].q, pv[99 - i]);
        if (ton_[i].q) n += 1;
        if (tof_[i].q) n += 2;
        if (tp_[i].q) n += 4;
        et += ton_[i].et + tp_[i].et;
        n += ctu_[i].cv + ctd_[i].cv;
    }
    scan_no = (scan_no + 1) % 30000;
    check = (check % 100003) * 7 + n * 3 + et;
}
