#include <stdbool.h>
#include "st.h"

typedef struct { bool in; int32_t pt; bool q; int32_t et; bool run; uint32_t start; } ton_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; bool old; bool run; uint32_t start; } tof_t;
typedef struct { bool in; int32_t pt; bool q; int32_t et; bool old; bool run; uint32_t start; } tp_t;
typedef struct { bool cu; bool r; int16_t pv; bool q; int16_t cv; bool old; } ctu_t;
typedef struct { bool cd; bool ld; int16_t pv; bool q; int16_t cv; bool old; } ctd_t;

static uint32_t now_ms;

static void ton(ton_t *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->et = 0;
        t->run = false;
    } else {
        if (!t->run && !t->q) {
            t->run = true;
            t->start = now_ms;
        }
        if (t->run) {
            int32_t el = (int32_t)(now_ms - t->start);
            if (el >= pt) {
                t->q = true;
                t->et = pt;
                t->run = false;
            } else {
                t->et = el;
            }
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (in) {
        t->q = true;
        t->et = 0;
        t->run = false;
    } else {
        if (t->old) {
            t->run = true;
            t->start = now_ms;
        }
        if (t->run) {
            int32_t el = (int32_t)(now_ms - t->start);
            if (el >= pt) {
                t->q = false;
                t->et = pt;
                t->run = false;
            } else {
                t->et = el;
            }
        }
    }
    t->old = in;
}

static void tp(tp_t *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (t->run) {
        int32_t el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->run = false;
            t->q = false;
            t->et = in ? pt : 0;
        } else {
            t->et = el;
        }
    } else if (in && !t->old) {
        t->run = true;
        t->q = true;
        t->start = now_ms;
        t->et = 0;
    } else if (!in) {
        t->et = 0;
    }
    t->old = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    c->cu = cu;
    c->r = r;
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < 32767)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    c->cd = cd;
    c->ld = ld;
    c->pv = pv;
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > -32768)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static ton_t onDelay[150];
static tof_t offDelay[100];
static tp_t pulse[100];
static ctu_t piece[75];
static ctd_t remain_[75];
static bool sensor[32];
static int32_t cycle;

void scan(void)
{
    int32_t i, sum;

    now_ms = (uint32_t)(now_us / 1000);
    cycle++;
    if (cycle >= 1000000)
        cycle = 0;

    for (i = 0; i < 32; i++)
        sensor[i] = ((cycle + i * 3) / (i + 2)) % 2 == 1;

    sum = 0;

    for (i = 0; i < 150; i++) {
        ton(&onDelay[i], sensor[i % 32], 5 + i);
        if (onDelay[i].q)
            sum += 1;
        sum += onDelay[i].et;
    }
    for (i = 0; i < 100; i++) {
        tof(&offDelay[i], sensor[(i + 7) % 32] && !onDelay[i].q, 10 + i / 2);
        if (offDelay[i].q)
            sum += 3;
    }
    for (i = 0; i < 100; i++) {
        tp(&pulse[i], offDelay[i].q && sensor[(i + 13) % 32], 25);
        if (pulse[i].q)
            sum += pulse[i].et;
    }
    for (i = 0; i < 75; i++) {
        ctu(&piece[i], sensor[i % 32], piece[i].q && pulse[i].q, 10);
        sum += piece[i].cv;
    }
    for (i = 0; i < 75; i++) {
        ctd(&remain_[i], pulse[i + 20].q, remain_[i].q && sensor[(i + 5) % 32], 8);
        if (remain_[i].q)
            sum += 7;
        sum += remain_[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
