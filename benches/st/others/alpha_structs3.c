/* Historian: 96 channels with a ring of samples each, an event queue, statistics */
#include <stdbool.h>
#include "st.h"

typedef struct { int32_t t; float v; uint8_t q; } Sample;
typedef struct {
    int16_t head, count;
    Sample buf[32];
    float sum, min_v, max_v, last_stored, band;
} Channel;
typedef struct { int16_t channel, code; Sample s; } Event;
typedef struct { int16_t head, tail, n; int32_t lost; Event ev[50]; } EventQueue;

static bool push(EventQueue *q, const Event *e)
{
    if (q->n >= 50) {
        q->lost++;
        return false;
    }
    q->ev[q->head] = *e;
    q->head = (q->head + 1) % 50;
    q->n++;
    return true;
}

static bool pop(EventQueue *q, Event *e)
{
    if (q->n == 0)
        return false;
    *e = q->ev[q->tail];
    q->tail = (q->tail + 1) % 50;
    q->n--;
    return true;
}

static float absf(float x) { return x < 0.0f ? -x : x; }

static bool first = true;
static int32_t cycle;
static uint32_t seed = 31415;
static Channel ch[96];
static EventQueue queue;

void scan(void)
{
    int c, i, k, popped;
    if (first) {
        for (c = 0; c < 96; c++)
            ch[c].band = 0.5f + (float)(c % 6) * 0.5f;
        first = false;
    }
    cycle++;
    for (c = 0; c < 96; c++) {
        Channel *h = &ch[c];
        float x;
        seed = seed * 1664525u + 1013904223u;
        x = (float)(seed / 65536u % 1024u) * 0.01f + (float)((cycle + c * 10) % 100) * 0.2f;
        if (absf(x - h->last_stored) > h->band) {
            Sample s;
            s.t = cycle;
            s.v = x;
            s.q = 0xC0;
            if (x > 26.0f) s.q = 0x40;
            if (h->count == 32)
                h->sum = h->sum - h->buf[h->head].v;
            else
                h->count++;
            h->buf[h->head] = s;
            h->sum = h->sum + x;
            h->last_stored = x;
            h->head++;
            if (h->head > 31) h->head = 0;
            if (s.q == 0x40) {
                Event e;
                e.channel = c;
                e.code = 17;
                e.s = s;
                push(&queue, &e);
            }
        }
        if ((c + cycle) % 8 == 0 && h->count > 0) {
            float avg;
            h->min_v = h->buf[0].v;
            h->max_v = h->buf[0].v;
            for (i = 1; i < h->count; i++) {
                if (h->buf[i].v < h->min_v) h->min_v = h->buf[i].v;
                if (h->buf[i].v > h->max_v) h->max_v = h->buf[i].v;
            }
            k = h->head - 1;
            if (k < 0) k = 31;
            i = 0;
            while (i < h->count && cycle - h->buf[k].t < 20) {
                i++;
                k--;
                if (k < 0) k = 31;
            }
            avg = h->sum / (float)h->count;
            check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(avg * 16.0f) + (int32_t)((h->max_v - h->min_v) * 100.0f) + i));
        }
    }

    popped = 0;
    while (popped < 4) {
        Event got;
        if (!pop(&queue, &got)) break;
        popped++;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(got.channel + got.s.t + (int32_t)(got.s.v * 10.0f) + got.code));
    }
    check = (int32_t)((uint32_t)check + (uint32_t)queue.lost + (uint32_t)queue.n);
}
