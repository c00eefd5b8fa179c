#include "st.h"
#include <stdbool.h>

typedef struct { bool q, running; int32_t et; uint32_t start; } Ton;
typedef struct { bool q, running; int32_t et; uint32_t start; } Tof;
typedef struct { bool q, running, prev; int32_t et; uint32_t start; } Tp;
typedef struct { bool q, prev; int16_t cv; } Ctu;
typedef struct { bool q, prev; int16_t cv; } Ctd;

static void ton(Ton *t, bool in, int32_t pt, uint32_t now)
{
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = now;
    }
    if (!t->q) {
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tof(Tof *t, bool in, int32_t pt, uint32_t now)
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
            t->start = now;
        }
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->q = false;
            t->running = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt, uint32_t now)
{
    if (t->running) {
        int32_t e = (int32_t)(now - t->start);
        if (e >= pt) {
            t->running = false;
            t->q = false;
            t->et = pt;
        } else {
            t->et = e;
        }
    } else if (in && !t->prev) {
        t->running = true;
        t->q = true;
        t->start = now;
        t->et = 0;
    }
    if (!t->running && !in)
        t->et = 0;
    t->prev = in;
}

static void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->prev && c->cv < INT16_MAX)
        c->cv++;
    c->prev = cu;
    c->q = c->cv >= pv;
}

static void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->prev && c->cv > INT16_MIN)
        c->cv--;
    c->prev = cd;
    c->q = c->cv <= 0;
}

typedef enum { STOPPED, STARTING, RUNNING, STOPPING } StationState;

typedef struct {
    int32_t start_delay;
    int32_t hold_time;
    int16_t batch;
} Recipe;

typedef struct {
    StationState state;
    bool eject;
    int32_t batches;
    Ton t_start;
    Tof t_hold;
    Tp t_eject;
    Ctu c_good;
    Ctd c_left;
} Station;

static void station(Station *s, bool run, bool sensor, const Recipe *rec, uint32_t now)
{
    ton(&s->t_start, run, rec->start_delay, now);
    tof(&s->t_hold, s->t_start.q, rec->hold_time, now);
    switch (s->state) {
    case STOPPED:
        if (run)
            s->state = STARTING;
        break;
    case STARTING:
        if (s->t_start.q)
            s->state = RUNNING;
        else if (!run)
            s->state = STOPPED;
        break;
    case RUNNING:
        if (!run)
            s->state = STOPPING;
        break;
    case STOPPING:
        if (!s->t_hold.q)
            s->state = STOPPED;
        break;
    }
    ctu(&s->c_good, sensor && s->t_hold.q, s->c_good.q, rec->batch);
    if (s->c_good.q)
        s->batches++;
    tp(&s->t_eject, s->c_good.q, 45, now);
    s->eject = s->t_eject.q;
    ctd(&s->c_left, s->eject, s->state == STOPPED, 20);
}

static bool ready;
static Station stations[100];
static Recipe recipes[4];
static int16_t tick;

void scan(void)
{
    uint32_t now = (uint32_t)(now_us / 1000);
    if (!ready) {
        ready = true;
        recipes[0].start_delay = 100;
        recipes[0].hold_time = 250;
        recipes[0].batch = 4;
        recipes[1].start_delay = 20;
        recipes[1].hold_time = 1000;
        recipes[1].batch = 6;
        recipes[2].start_delay = 330;
        recipes[2].hold_time = 60;
        recipes[2].batch = 3;
        recipes[3].start_delay = 1200;
        recipes[3].hold_time = 500;
        recipes[3].batch = 10;
    }
    tick++;
    if (tick >= 12000)
        tick = 0;
    int32_t running = 0, sum = 0;
    for (int i = 1; i <= 100; i++) {
        Station *s = &stations[i - 1];
        station(s, (tick + i * 11) % 400 < 300, (tick + i) % 6 < 3, &recipes[i % 4], now);
        if (s->state == RUNNING)
            running++;
        if (s->eject)
            sum += i;
        sum += s->batches % 1000;
    }
    check = (int32_t)((uint32_t)check * 13u + (uint32_t)running * 3u + (uint32_t)sum);
}
