/* 500 timers and counters: start delays, run-on times, pulses, start and batch counters */
#include <stdbool.h>
#include "st.h"

#define N_TON 160
#define N_TOF 100
#define N_TP   90
#define N_CTU  80
#define N_CTD  70

struct ton { bool in, q; int32_t pt, et, start; };
struct tof { bool in, q; int32_t pt, et, start; };
struct tp  { bool in, q, run; int32_t pt, et, start; };
struct ctu { bool cu, q; int16_t pv, cv; };
struct ctd { bool cd, q; int16_t pv, cv; };

static bool init;
static struct ton start_delay[N_TON];
static struct tof run_on[N_TOF];
static struct tp  pulse[N_TP];
static struct ctu starts[N_CTU];
static struct ctd batch[N_CTD];
static int32_t pt_delay[N_TON];
static int32_t pt_run_on[N_TOF];
static int32_t pt_pulse[N_TP];
static bool cmd[160];
static uint32_t seed = 99;

static int32_t now_ms(void)
{
    return (int32_t)(now_us / 1000);
}

static void ton(struct ton *t, bool in, int32_t pt)
{
    t->pt = pt;
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = now_ms();
        if (!t->q) {
            t->et = now_ms() - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = true;
            }
        }
    }
    t->in = in;
}

static void tof(struct tof *t, bool in, int32_t pt)
{
    t->pt = pt;
    if (in) {
        t->q = true;
        t->et = 0;
    } else {
        if (t->in)
            t->start = now_ms();
        if (t->q) {
            t->et = now_ms() - t->start;
            if (t->et >= pt) {
                t->et = pt;
                t->q = false;
            }
        }
    }
    t->in = in;
}

static void tp(struct tp *t, bool in, int32_t pt)
{
    t->pt = pt;
    if (t->run) {
        t->et = now_ms() - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->run = false;
        }
    } else if (in && !t->in) {
        t->start = now_ms();
        t->et = 0;
        t->q = true;
        t->run = true;
    }
    if (!t->run && !in)
        t->et = 0;
    t->in = in;
}

static void ctu(struct ctu *c, bool cu, bool r, int16_t pv)
{
    c->pv = pv;
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static void ctd(struct ctd *c, bool cd, bool ld, int16_t pv)
{
    c->pv = pv;
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN)
        c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

void scan(void)
{
    int i, k;
    int32_t n_on, sum_et, sum_cv;

    if (!init) {
        for (i = 0; i < N_TON; i++)
            pt_delay[i] = 100 + i * 25;
        for (i = 0; i < N_TOF; i++)
            pt_run_on[i] = 200 + i * 40;
        for (i = 0; i < N_TP; i++)
            pt_pulse[i] = 50 + i * 10;
        init = true;
    }

    /* a few commands toggle each scan */
    for (i = 1; i <= 4; i++) {
        seed = seed * 1664525u + 1013904223u;
        k = (seed / 65536) % 160;
        cmd[k] = !cmd[k];
    }

    n_on = 0;
    sum_et = 0;
    sum_cv = 0;

    /* pump start delays */
    for (i = 0; i < N_TON; i++) {
        ton(&start_delay[i], cmd[i], pt_delay[i]);
        if (start_delay[i].q)
            n_on++;
        sum_et += start_delay[i].et;
    }

    /* fan run-on */
    for (i = 0; i < N_TOF; i++) {
        tof(&run_on[i], start_delay[i].q, pt_run_on[i]);
        if (run_on[i].q)
            n_on++;
        sum_et += run_on[i].et;
    }

    /* valve pulses */
    for (i = 0; i < N_TP; i++) {
        tp(&pulse[i], cmd[i + 60] && !pulse[i].q, pt_pulse[i]);
        if (pulse[i].q)
            n_on++;
        sum_et += pulse[i].et;
    }

    /* start counters, reset when the service limit is reached and acknowledged */
    for (i = 0; i < N_CTU; i++) {
        ctu(&starts[i], start_delay[i].q, starts[i].q && cmd[159 - i], 5);
        sum_cv += starts[i].cv;
    }

    /* batch counters, reload when empty */
    for (i = 0; i < N_CTD; i++) {
        ctd(&batch[i], pulse[i].q, batch[i].q, 8);
        if (batch[i].q)
            n_on++;
        sum_cv += batch[i].cv;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(n_on + sum_et * 3 + sum_cv));
}
