/* Motor starters (45) and dosing pumps (60) with their own timers and counters */
#include <stdbool.h>
#include "st.h"

typedef struct { uint32_t start; int32_t et; bool run, q; } Ton;
typedef struct { uint32_t start; int32_t et; bool run, q; } Tof;
typedef struct { uint32_t start; int32_t et; uint8_t state; bool q; } Tp;
typedef struct { int16_t cv; bool q, old; } Ctu;
typedef struct { int16_t cv; bool q, old; } Ctd;

static uint32_t now_ms;

static void ton(Ton *t, bool in, int32_t pt)
{
    if (!in) {
        t->q = false;
        t->run = false;
        t->et = 0;
    } else if (!t->q) {
        int32_t el;
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->q = true;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tof(Tof *t, bool in, int32_t pt)
{
    if (in) {
        t->q = true;
        t->run = false;
        t->et = 0;
    } else if (t->q) {
        int32_t el;
        if (!t->run) {
            t->run = true;
            t->start = now_ms;
        }
        el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
}

static void tp(Tp *t, bool in, int32_t pt)
{
    if (t->state == 0 && in) {
        t->state = 1;
        t->q = true;
        t->start = now_ms;
    }
    if (t->state == 1) {
        int32_t el = (int32_t)(now_ms - t->start);
        if (el >= pt) {
            t->state = 2;
            t->q = false;
            t->et = pt;
        } else {
            t->et = el;
        }
    }
    if (t->state == 2 && !in) {
        t->state = 0;
        t->et = 0;
    }
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

typedef struct {
    bool run, fan, fault;
    int16_t starts;
    Ton t_start;
    Tp t_horn;
    Ton t_monitor;
    Tof t_fan;
    Ctu c_starts, c_trips;
} MotorStarter;

static void motor_starter(MotorStarter *m, bool request, bool feedback, bool reset, int32_t start_delay)
{
    tp(&m->t_horn, request, 60);
    ton(&m->t_start, request && !m->fault, start_delay);
    m->run = m->t_start.q && !m->t_horn.q && !m->fault;
    ton(&m->t_monitor, m->run && !feedback, 45);
    if (m->t_monitor.q)
        m->fault = true;
    else if (reset)
        m->fault = false;
    tof(&m->t_fan, m->run, 200);
    m->fan = m->t_fan.q;
    ctu(&m->c_starts, m->run, m->c_starts.cv >= 500, 1000);
    ctu(&m->c_trips, m->fault, m->c_trips.q && reset, 20);
    m->starts = m->c_starts.cv;
}

typedef struct {
    bool coil, done;
    int16_t left;
    Tp t_on;
    Ton t_pause;
    Ctd c_stroke;
    Ton t_refill;
} DosePump;

static void dose_pump(DosePump *p, bool enable, int16_t strokes)
{
    ton(&p->t_pause, enable && !p->t_on.q && !p->done, 30);
    tp(&p->t_on, p->t_pause.q, 20);
    p->coil = p->t_on.q;
    ctd(&p->c_stroke, p->coil, p->t_refill.q || !enable, strokes);
    p->done = p->c_stroke.q;
    ton(&p->t_refill, p->done && enable, 150);
    p->left = p->c_stroke.cv;
}

static int32_t cycle;
static MotorStarter motor[45];
static DosePump pump[60];

void scan(void)
{
    int i;
    bool prev_run = true;
    int32_t n = 0;
    now_ms = (uint32_t)(now_us / 1000);
    cycle++;
    for (i = 0; i < 45; i++) {
        motor_starter(&motor[i], (cycle + i * 11) % 150 < 100 && (prev_run || i % 5 == 0),
                      motor[i].run && (cycle + i) % 400 < 380, cycle % 100 == 99, 80);
        prev_run = motor[i].run;
        if (motor[i].fan) n += 1;
        if (motor[i].fault) n += 100;
        check = (int32_t)((uint32_t)check * 3u + (uint32_t)motor[i].starts);
    }
    for (i = 0; i < 60; i++) {
        dose_pump(&pump[i], motor[i % 45].run || i % 3 == 0, 4 + i % 6);
        if (pump[i].coil) n += 1;
        if (pump[i].done) n += 10;
        check = (int32_t)((uint32_t)check * 3u + (uint32_t)pump[i].left);
    }
    check = (int32_t)((uint32_t)check + (uint32_t)n);
}
