/* 500 function blocks: 100 on-delays, 100 off-delays, 100 pulses, 60 up-counters, 40 down-counters,
   40 up-down-counters, 30 rising and 30 falling edges, stimulated by 16 square waves. */
#include <stdbool.h>
#include "st.h"

typedef int64_t Time; /* microseconds */
#define MS(n) ((Time)(n) * 1000)

typedef struct {
    bool level;
    int16_t position;
} SquareWave;

static void square_wave(SquareWave *w, int16_t period, int16_t width)
{
    w->position++;
    if (w->position >= period)
        w->position = 0;
    w->level = w->position < width;
}

typedef struct {
    bool q;
    bool running;
    Time et;
    Time start;
} OnDelay;

static void on_delay(OnDelay *t, bool in, Time pt)
{
    if (!in) {
        t->running = false;
        t->q = false;
        t->et = 0;
        return;
    }
    if (!t->running) {
        t->running = true;
        t->start = (Time)now_us;
    }
    if (!t->q) {
        t->et = (Time)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        }
    }
}

typedef struct {
    bool q;
    bool running;
    Time et;
    Time start;
} OffDelay;

static void off_delay(OffDelay *t, bool in, Time pt)
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
            t->start = (Time)now_us;
        }
        t->et = (Time)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
            t->running = false;
        }
    }
}

typedef struct {
    bool q;
    bool last;
    Time et;
    Time start;
} Pulse;

static void pulse_timer(Pulse *t, bool in, Time pt)
{
    if (t->q) {
        t->et = (Time)now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = false;
        }
    } else if (in && !t->last) {
        t->q = true;
        t->start = (Time)now_us;
        t->et = 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->last = in;
}

typedef struct {
    bool q;
    bool last;
    int16_t cv;
} UpCounter;

static void count_up(UpCounter *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->last && c->cv < INT16_MAX)
        c->cv++;
    c->last = cu;
    c->q = c->cv >= pv;
}

typedef struct {
    bool q;
    bool last;
    int16_t cv;
} DownCounter;

static void count_down(DownCounter *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->last && c->cv > INT16_MIN)
        c->cv--;
    c->last = cd;
    c->q = c->cv <= 0;
}

typedef struct {
    bool qu;
    bool qd;
    bool last_up;
    bool last_down;
    int16_t cv;
} BothCounter;

static void count_both(BothCounter *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->last_up;
    bool down = cd && !c->last_down;
    c->last_up = cu;
    c->last_down = cd;
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
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

typedef struct {
    bool q;
    bool memory;
} Edge;

static void rising_edge(Edge *e, bool clk)
{
    e->q = clk && !e->memory;
    e->memory = clk;
}

static void falling_edge(Edge *e, bool clk)
{
    e->q = !clk && !e->memory;
    e->memory = !clk;
}

static const int16_t period[16] = {7, 11, 13, 17, 19, 23, 29, 31, 37, 8, 14, 26, 41, 53, 61, 10};
static const int16_t width[16] = {3, 6, 4, 9, 12, 5, 15, 20, 7, 4, 10, 13, 30, 26, 8, 6};
static const Time wait_time[10] = {MS(20), MS(30), MS(45), MS(55), MS(60),
                                   MS(90), MS(120), MS(150), MS(250), MS(360)};

static SquareWave wave[16];
static OnDelay on[100];
static OffDelay off[100];
static Pulse pulse[100];
static UpCounter up[60];
static DownCounter down[40];
static BothCounter both[40];
static Edge rising[30];
static Edge falling[30];

void scan(void)
{
    int32_t sum = 0;

    for (int i = 0; i < 16; i++)
        square_wave(&wave[i], period[i], width[i]);

    /* Edges */
    for (int i = 0; i < 30; i++) {
        rising_edge(&rising[i], wave[i % 16].level && wave[(i + 5) % 16].level);
        falling_edge(&falling[i], wave[(i + 3) % 16].level || wave[(i + 10) % 16].level);
        if (rising[i].q)
            sum += i + 1;
        if (falling[i].q)
            sum += 2 * i + 1;
    }

    /* Timers */
    for (int i = 0; i < 100; i++) {
        on_delay(&on[i], wave[i % 16].level, wait_time[i % 10]);
        off_delay(&off[i], wave[(i + 7) % 16].level, wait_time[(i + 1) % 10]);
        pulse_timer(&pulse[i], wave[(i + 11) % 16].level, wait_time[(i + 2) % 10]);
        if (on[i].q)
            sum += i + 1;
        if (off[i].q)
            sum += 2 * i + 1;
        if (pulse[i].q)
            sum += 3 * i + 1;
        if (on[i].et > off[i].et)
            sum++;
        if (pulse[i].et >= MS(40))
            sum++;
    }

    /* Counters */
    for (int i = 0; i < 60; i++) {
        count_up(&up[i], pulse[i].q, rising[i % 30].q && on[i + 40].q, i % 9 + 2);
        sum += up[i].cv;
        if (up[i].q)
            sum += i;
    }
    for (int i = 0; i < 40; i++) {
        count_down(&down[i], on[i].q, falling[i % 30].q && pulse[i + 50].q, i % 11 + 3);
        sum += down[i].cv;
        if (down[i].q)
            sum += i;

        count_both(&both[i], off[i].q, pulse[i + 20].q, rising[i % 30].q && !off[i + 30].q,
                   falling[(i + 4) % 30].q, i % 6 + 4);
        sum += both[i].cv;
        if (both[i].qu)
            sum += 2 * i;
        else if (both[i].qd)
            sum += 3 * i;
    }

    check = (check * 31 + sum) % 1000003;
}
