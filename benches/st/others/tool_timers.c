/* 500 timers and counters */
#include <stdbool.h>
#include "st.h"

static int32_t now_ms;

struct ton { int32_t pt, et, start; bool in, q, running; };
struct tof { int32_t pt, et, start; bool in, q, running; };
struct tp  { int32_t pt, et, start; bool in, q; uint8_t state; };
struct ctu { int16_t pv, cv; bool cu, r, q, old; };
struct ctd { int16_t pv, cv; bool cd, ld, q, old; };

static void ton(struct ton *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->running = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now_ms;
    }
    if (!t->q) {
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(struct tof *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (in) {
        t->q = true;
        t->running = false;
        t->et = 0;
        return;
    }
    if (t->q) {
        if (!t->running) {
            t->running = true;
            t->start = now_ms;
        }
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
}

static void tp(struct tp *t, bool in, int32_t pt)
{
    t->in = in;
    t->pt = pt;
    if (t->state == 0 && in) {
        t->state = 1;
        t->start = now_ms;
    }
    if (t->state == 1) {
        t->et = now_ms - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->state = 2;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
    t->q = t->state == 1;
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    c->cu = cu;
    c->r = r;
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    c->cd = cd;
    c->ld = ld;
    c->pv = pv;
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static int32_t cnt;
static bool first = true;
static int32_t pt[150];
static struct ton ton1[150];
static struct tof tof1[100];
static struct tp tp1[100];
static struct ctu ctu1[100];
static struct ctd ctd1[50];

void scan(void)
{
    int i;
    int16_t n_on = 0, n_off = 0, n_pulse = 0, n_up = 0, n_down = 0;
    int32_t et_sum = 0, cv_sum = 0;

    now_ms = (int32_t)(now_us / 1000);
    if (first) {
        for (i = 0; i < 150; i++)
            pt[i] = 3 + 2 * (i % 60);
        first = false;
    }
    cnt++;
    if (cnt >= 1000000)
        cnt = 0;

    for (i = 0; i < 150; i++) {
        ton(&ton1[i], (cnt + i * 5) % 64 < 44, pt[i]);
        if (ton1[i].q)
            n_on++;
        et_sum += ton1[i].et;
    }
    for (i = 0; i < 100; i++) {
        tof(&tof1[i], (cnt + i * 3) % 48 < 12, pt[i]);
        if (tof1[i].q)
            n_off++;
        et_sum += tof1[i].et;
    }
    for (i = 0; i < 100; i++) {
        tp(&tp1[i], ton1[i].q && !tof1[99 - i].q, pt[i + 20]);
        if (tp1[i].q)
            n_pulse++;
        et_sum += tp1[i].et;
    }
    for (i = 0; i < 100; i++) {
        bool x = tp1[i].q || ton1[i + 50].q;
        ctu(&ctu1[i], x, ctu1[i].q && !x, (int16_t)(5 + i % 10));
        if (ctu1[i].q)
            n_up++;
        cv_sum += ctu1[i].cv;
    }
    for (i = 0; i < 50; i++) {
        ctd(&ctd1[i], tof1[i].q, ctd1[i].q && tof1[i + 50].q, (int16_t)(8 + i % 5));
        if (ctd1[i].q)
            n_down++;
        cv_sum += ctd1[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(et_sum + cv_sum * 7 + n_on + n_off * 2 + n_pulse * 3 + n_up * 4 + n_down * 5));
}
