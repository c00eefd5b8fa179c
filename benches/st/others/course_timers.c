/* Course unit 2: 500 standard timers and counters. */
#include "st.h"
#include <stdbool.h>

typedef struct { bool q, running; uint32_t start; int32_t et; } Ton;
typedef struct { bool q, running; uint32_t start; int32_t et; } Tof;
typedef struct { bool q, old; uint32_t start; int32_t et; } Tp;
typedef struct { bool q, old; int16_t cv; } Ctu;
typedef struct { bool q, old; int16_t cv; } Ctd;

static uint32_t now_ms;

static void ton(Ton *t, bool in, int32_t pt)
{
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
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

static void tof(Tof *t, bool in, int32_t pt)
{
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
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (t->q) {
        t->et = (int32_t)(now_ms - t->start);
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            if (!in)
                t->et = 0;
        }
    } else if (in && !t->old) {
        t->q = true;
        t->start = now_ms;
        t->et = 0;
    } else if (!in) {
        t->et = 0;
    }
    t->old = in;
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->old && c->cv < INT16_MAX)
        c->cv++;
    c->old = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->old && c->cv > INT16_MIN)
        c->cv--;
    c->old = cd;
    c->q = c->cv <= 0;
}

static int32_t scan_no;
static bool clocks[16];
static int32_t delays[8] = { 5, 12, 20, 33, 50, 80, 100, 150 };
static Ton on_delay[150];
static Tof off_delay[100];
static Tp pulse[100];
static Ctu up_count[75];
static Ctd down_count[75];

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);
    scan_no++;
    for (int i = 0; i < 16; i++)
        clocks[i] = (scan_no / (3 * i + 1)) % 2 == 1;

    int32_t sum = 0;
    for (int i = 0; i < 150; i++) {
        ton(&on_delay[i], clocks[i % 16], delays[i % 8]);
        if (on_delay[i].q)
            sum += 1;
        sum += on_delay[i].et;
    }
    for (int i = 0; i < 100; i++) {
        tof(&off_delay[i], clocks[(i + 5) % 16], delays[(i + 3) % 8]);
        if (off_delay[i].q)
            sum += 2;
    }
    for (int i = 0; i < 100; i++) {
        tp(&pulse[i], off_delay[i].q, delays[i % 8]);
        if (pulse[i].q)
            sum += 3;
        sum += pulse[i].et;
    }
    for (int i = 0; i < 75; i++) {
        ctu(&up_count[i], on_delay[i].q, up_count[i].q, 5);
        sum += up_count[i].cv;
    }
    for (int i = 0; i < 75; i++) {
        ctd(&down_count[i], pulse[i].q, down_count[i].q, 8);
        sum += down_count[i].cv;
    }
    check = (check * 31 + sum) % 1000003;
}
