/* 60 stations of 5 timers/counters each, 80 TON, 60 TOF, 60 CTU: 500 blocks */
#include "st.h"
#include <stdbool.h>

typedef struct { bool q, run; int32_t et, start; } ton_t;
typedef struct { bool q, run; int32_t et, start; } tof_t;
typedef struct { bool q, run, mem; int32_t et, start; } tp_t;
typedef struct { bool q, mem; int16_t cv; } ctu_t;
typedef struct { bool q, mem; int16_t cv; } ctd_t;

static int32_t now_ms(void)
{
    return (int32_t)(uint32_t)(now_us / 1000);
}

static int32_t elapsed(int32_t start)
{
    return (int32_t)((uint32_t)now_ms() - (uint32_t)start);
}

static void ton(ton_t *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->run = false;
        t->et = 0;
    } else if (!t->run) {
        t->run = true;
        t->start = now_ms();
        t->et = 0;
        t->q = pt <= 0;
    } else if (!t->q) {
        int32_t el = elapsed(t->start);
        if (el >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tof(tof_t *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
    } else if (t->q) {
        if (!t->run) {
            t->run = true;
            t->start = now_ms();
        }
        int32_t el = elapsed(t->start);
        if (el >= pt) {
            t->q = false;
            t->run = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tp(tp_t *t, bool in, int32_t pt)
{
    if (t->run) {
        int32_t el = elapsed(t->start);
        if (el >= pt) {
            t->run = false;
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    } else if (in && !t->mem) {
        t->run = true;
        t->q = true;
        t->start = now_ms();
        t->et = 0;
    }
    if (!t->run && !in)
        t->et = 0;
    t->mem = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->mem && c->cv < INT16_MAX)
        c->cv++;
    c->mem = cu;
    c->q = c->cv >= pv;
}

static void ctd(ctd_t *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->mem && c->cv > INT16_MIN)
        c->cv--;
    c->mem = cd;
    c->q = c->cv <= 0;
}

#define BATCH 12

typedef struct {
    bool run, batch_done;
    int16_t parts;
    ton_t ton_start;
    tof_t tof_run;
    tp_t tp_pulse;
    ctu_t ctu_parts;
    ctd_t ctd_batch;
} station_t;

static void station_step(station_t *s, bool sensor, bool enable, int32_t delay)
{
    ton(&s->ton_start, sensor && enable, delay);
    tof(&s->tof_run, s->ton_start.q, 60);
    tp(&s->tp_pulse, s->tof_run.q, 25);
    ctu(&s->ctu_parts, s->tp_pulse.q, s->ctu_parts.q, BATCH);
    ctd(&s->ctd_batch, s->tp_pulse.q, s->ctd_batch.q, 7);
    s->run = s->tof_run.q;
    s->batch_done = s->ctu_parts.q || s->ctd_batch.q;
    s->parts = (int16_t)(s->ctu_parts.cv + s->ctd_batch.cv);
}

#define N_STATION 60
#define N_TON 80
#define N_TOF 60
#define N_CTU 60

static bool init_done;
static station_t station[N_STATION];
static ton_t ton_alarm[N_TON];
static tof_t tof_fan[N_TOF];
static ctu_t ctu_hours[N_CTU];
static int32_t t_station[N_STATION];
static int32_t t_alarm[N_TON];
static bool sens[32];
static uint32_t inputs = 0x0F3355AA;
static uint32_t rnd = 0x1234567;

void scan(void)
{
    int i;
    int32_t sum = 0;

    if (!init_done) {
        init_done = true;
        for (i = 0; i < N_STATION; i++)
            t_station[i] = 10 + i;
        for (i = 0; i < N_TON; i++)
            t_alarm[i] = 15 + 3 * i;
    }

    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;
    inputs ^= 1u << (rnd & 0x1F);
    for (i = 0; i < 32; i++)
        sens[i] = (inputs >> i) & 1;

    for (i = 0; i < N_STATION; i++) {
        station_step(&station[i], sens[i % 32], sens[(i + 5) % 32] || i < 40, t_station[i]);
        if (station[i].batch_done)
            sum += 100;
        sum += station[i].parts;
    }
    for (i = 0; i < N_TON; i++) {
        ton(&ton_alarm[i], !sens[(i * 3) % 32], t_alarm[i]);
        if (ton_alarm[i].q)
            sum += 1;
        sum += ton_alarm[i].et;
    }
    for (i = 0; i < N_TOF; i++) {
        tof(&tof_fan[i], station[i].run && ton_alarm[i].q, 150);
        sum += tof_fan[i].et;
    }
    for (i = 0; i < N_CTU; i++) {
        ctu(&ctu_hours[i], tof_fan[i].q, ctu_hours[i].cv >= 500, 100);
        if (ctu_hours[i].q)
            sum += 3;
        sum += ctu_hours[i].cv;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
