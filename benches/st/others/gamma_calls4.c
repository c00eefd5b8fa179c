/* Checkweigher / filler: 24 analog channels, FIFOs, reject shift registers */
#include <stdbool.h>
#include "st.h"

static float scale(uint16_t raw, float low, float high)
{
    return low + (high - low) * raw / 27648.0f;
}

typedef struct { float out, z1, z2; } Median3;

static void median3(Median3 *m, float in)
{
    if (in > m->z1) {
        if (m->z1 > m->z2)
            m->out = m->z1;
        else if (in > m->z2)
            m->out = m->z2;
        else
            m->out = in;
    } else {
        if (in > m->z2)
            m->out = in;
        else if (m->z1 > m->z2)
            m->out = m->z2;
        else
            m->out = m->z1;
    }
    m->z2 = m->z1;
    m->z1 = in;
}

typedef struct { float out; float buf[8]; int16_t idx; } MovAvg8;

static void movavg8(MovAvg8 *m, float in)
{
    m->buf[m->idx] = in;
    m->idx = (m->idx + 1) % 8;
    float sum = 0.0f;
    for (int i = 0; i < 8; i++)
        sum += m->buf[i];
    m->out = sum / 8.0f;
}

typedef struct { bool q; } Hyst;

static void hyst(Hyst *h, float in, float high, float low)
{
    if (in > high)
        h->q = true;
    else if (in < low)
        h->q = false;
}

typedef struct { bool alarm, unack; uint16_t count; uint16_t cnt; } AlarmLatch;

static void alarm_latch(AlarmLatch *a, bool cond, bool ack, uint16_t delay)
{
    if (cond) {
        if (a->cnt < delay) {
            a->cnt++;
        } else if (!a->alarm) {
            a->alarm = true;
            a->unack = true;
            a->count++;
        }
    } else {
        a->cnt = 0;
        a->alarm = false;
    }
    if (ack)
        a->unack = false;
}

typedef struct {
    float value;
    uint16_t state;
    Median3 med;
    MovAvg8 avg;
    Hyst high, low;
    AlarmLatch alm;
} AnalogIn;

static void analog_in(AnalogIn *a, uint16_t raw, float min, float max, bool ack)
{
    median3(&a->med, scale(raw, min, max));
    movavg8(&a->avg, a->med.out);
    a->value = a->avg.out;
    hyst(&a->high, a->value, min + (max - min) * 0.6f, min + (max - min) * 0.55f);
    hyst(&a->low, a->value, min + (max - min) * 0.45f, min + (max - min) * 0.4f);
    alarm_latch(&a->alm, a->high.q || !a->low.q, ack, 4);
    a->state = 0;
    if (a->high.q)
        a->state |= 0x0001;
    if (!a->low.q)
        a->state |= 0x0002;
    if (a->alm.alarm)
        a->state |= 0x0100;
    if (a->alm.unack)
        a->state |= 0x0200;
}

typedef struct { int32_t data[32]; int16_t head, tail, count; } Fifo;

static bool fifo_push(Fifo *f, int32_t value)
{
    if (f->count >= 32)
        return false;
    f->data[f->head] = value;
    f->head = (f->head + 1) % 32;
    f->count++;
    return true;
}

static bool fifo_pop(Fifo *f, int32_t *value)
{
    if (f->count == 0) {
        *value = 0;
        return false;
    }
    *value = f->data[f->tail];
    f->tail = (f->tail + 1) % 32;
    f->count--;
    return true;
}

static int16_t fifo_level(const Fifo *f) { return f->count; }

typedef struct { bool kick; int32_t kicks; uint32_t reg; } RejectGate;

static void reject_gate(RejectGate *g, bool shift, bool bad)
{
    if (shift) {
        g->reg <<= 1;
        if (bad)
            g->reg |= 1u;
        g->kick = (g->reg & 0x400u) != 0;
        if (g->kick)
            g->kicks++;
    } else {
        g->kick = false;
    }
}

static AnalogIn ai[24];
static Fifo fifo1, fifo2;
static RejectGate gates[8];
static uint32_t seed = 12345;
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    bool ack = (scan_no % 50) == 0;
    int32_t sum = 0, val;
    for (int i = 1; i <= 24; i++) {
        AnalogIn *a = &ai[i - 1];
        seed = seed * 1664525u + 1013904223u;
        uint16_t raw = (uint16_t)((seed / 65536u) % 27649u);
        analog_in(a, raw, 0.0f, 10.0f * i, ack);
        sum += (int32_t)(a->value * 16.0f) + (int16_t)a->state;
        if (i % 2 == 0)
            fifo_push(&fifo1, sum);
    }

    while (fifo_level(&fifo1) > 8) {
        fifo_pop(&fifo1, &val);
        if (!fifo_push(&fifo2, val + 1))
            sum += 100000;
    }

    for (int i = 1; i <= 8; i++) {
        RejectGate *g = &gates[i - 1];
        if (fifo_pop(&fifo2, &val)) {
            reject_gate(g, true, (val % 5) == 0);
            sum += val % 1000;
        } else {
            reject_gate(g, false, false);
        }
        if (g->kick)
            sum += 17 * i;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + gates[1].kicks + fifo_level(&fifo2)));
}
