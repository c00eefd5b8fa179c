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
typedef struct {
    bool active, lot_done, edge_old;
    uint16_t status;
    ton_t on_delay; tof_t off_delay; tp_t pulse; ctr_t parts, lots;
} station_t;
static void station(station_t *s, bool request, bool reset, int32_t delay)
{
    ton(&s->on_delay, request && !reset, delay);
    tof(&s->off_delay, s->on_delay.q, 35);
    s->active = s->off_delay.q;
    tp(&s->pulse, s->active, 12);
    ctu(&s->parts, s->pulse.q, reset || s->lot_done, 5);
    s->lot_done = s->parts.q;
    bool edge = s->lot_done && !s->edge_old;
    s->edge_old = s->lot_done;
    ctd(&s->lots, edge, reset, 3);
    s->status = 0;
    if (s->active) s->status |= 0x0001;
    if (s->lot_done) s->status |= 0x0002;
    if (s->lots.q) s->status |= 0x0004;
    if (s->on_delay.et > 10) s->status |= 0x0008;
    if (s->pulse.q) s->status |= 0x0010;
}
static station_t st[100];
static uint32_t cnt;
void scan(void)
{
    cnt++;
    int32_t sum = 0;
    for (int16_t i = 1; i <= 100; i++) {
        uint32_t k = (cnt + (uint32_t)i * 7) / 32;
        station(&st[i - 1], (k % 4) != 0, (k % 64) == 9, 8 + i % 20);
        sum += (int16_t)st[i - 1].status * i;
    }
    check = (check % 100003) * 5 + sum;
}
