#include <stdbool.h>
#include "st.h"
static int32_t hash(int32_t a, int32_t b) { return (a * 31 + b) % 65521; }
static bool in_window(int16_t x, int16_t centre, int16_t half) { return x >= centre - half && x <= centre + half; }
typedef struct { bool out; int16_t cnt; } debounce_t;
typedef struct { int16_t pos; bool opened, closed; debounce_t d_open, d_close; } valve_t;
typedef struct { int16_t value; bool wrapped, old; } counter_t;
typedef struct { int16_t step; bool busy; int16_t wait; } stepper_t;
typedef struct { int32_t sig; } signature_t;
static void debounce(debounce_t *d, bool in, int16_t n)
{
    if (in == d->out) {
        d->cnt = 0;
    } else {
        d->cnt++;
        if (d->cnt >= n) { d->out = in; d->cnt = 0; }
    }
}
static void valve(valve_t *v, bool open_cmd, bool close_cmd)
{
    debounce(&v->d_open, open_cmd, 3);
    debounce(&v->d_close, close_cmd, 2);
    if (v->d_open.out && !v->d_close.out)
        v->pos = v->pos + 5 < 100 ? (int16_t)(v->pos + 5) : 100;
    else if (v->d_close.out)
        v->pos = v->pos - 7 > 0 ? (int16_t)(v->pos - 7) : 0;
    v->opened = in_window(v->pos, 100, 2);
    v->closed = in_window(v->pos, 0, 2);
}
static void counter(counter_t *c, bool up, int16_t limit)
{
    c->wrapped = false;
    if (up && !c->old) {
        c->value++;
        if (c->value >= limit) { c->value = 0; c->wrapped = true; }
    }
    c->old = up;
}
static void stepper(stepper_t *s, bool go, bool done)
{
    switch (s->step) {
    case 0: if (go) { s->step = 10; s->wait = 0; } break;
    case 10: s->wait++; if (s->wait > 4) s->step = 20; break;
    case 20: if (done) s->step = 30; break;
    case 30: s->step = 40; s->wait = 10; break;
    case 40: s->wait--; if (s->wait <= 0) s->step = 0; break;
    default: s->step = 0;
    }
    s->busy = s->step != 0;
}
static void signature(signature_t *g, int16_t x, int32_t y) { g->sig = hash(hash(g->sig, x), y); }
static valve_t valves[50]; static counter_t counters[50]; static stepper_t steps[50]; static signature_t sigs[50];
static int32_t t;
void scan(void)
{
    t = (t + 1) % 100000;
    int32_t s = 0;
    for (int16_t i = 0; i < 50; i++) {
        valve(&valves[i], (t + i) % 64 < 30, (t + 2 * i) % 64 > 36);
        int16_t ps = valves[i].pos;
        bool full = valves[i].opened;
        counter(&counters[i], full, (int16_t)(3 + i % 4));
        int16_t cv = counters[i].value;
        bool wr = counters[i].wrapped;
        stepper(&steps[i], wr || (t + i) % 16 == 0, full);
        bool bz = steps[i].busy;
        signature(&sigs[i], (int16_t)(steps[i].step + ps), cv);
        s += sigs[i].sig;
        if (bz) s++;
    }
    check = (check % 100003) * 3 + s;
}
