/* Batch dosing: 4 lines with 6 dosing heads each */
#include <stdbool.h>
#include "st.h"

typedef struct {
    int16_t material;
    int32_t setpoint;
    int32_t tol;
    int16_t coarse;
    int16_t fine;
    bool active;
} Ingredient;

static int16_t flow_factor(int16_t material)
{
    switch (material) {
    case 0: return 100;
    case 1: case 2: return 85;
    case 3: case 4: case 5: return 120;
    case 6: return 60;
    case 7: return 145;
    default: return 95;
    }
}

static int32_t flow_rate(int16_t opening, int16_t material)
{
    int32_t raw = (int32_t)opening * flow_factor(material);
    return raw / 100;
}

static bool in_tolerance(int32_t set, int32_t act, int32_t tol)
{
    return act >= set - tol && act <= set + tol;
}

static uint8_t crc8(uint8_t seed, uint8_t data)
{
    uint8_t crc = seed ^ data;
    for (int i = 1; i <= 8; i++) {
        if (crc & 0x80)
            crc = (uint8_t)(crc << 1) ^ 0x07;
        else
            crc = (uint8_t)(crc << 1);
    }
    return crc;
}

typedef struct {
    int16_t pos;
    bool opened, closed;
    int32_t strokes;
    bool old;
} Valve;

static void valve(Valve *v, bool cmd, int16_t speed)
{
    if (cmd && !v->old)
        v->strokes++;
    v->old = cmd;
    if (cmd) {
        int16_t p = v->pos + speed;
        v->pos = p < 100 ? p : 100;
    } else {
        int16_t p = v->pos - speed;
        v->pos = p > 0 ? p : 0;
    }
    v->opened = v->pos >= 100;
    v->closed = v->pos <= 0;
}

typedef struct {
    bool busy, done, error;
    int32_t weight;
    int16_t step;
    int16_t settle;
    Valve coarse, fine;
    bool open_c, open_f;
    int32_t preact;
} DosingHead;

static void dosing_head(DosingHead *h, bool start, const Ingredient *ing)
{
    switch (h->step) {
    case 0:
        h->done = false;
        h->error = false;
        if (start && ing->active) {
            h->weight = 0;
            h->busy = true;
            h->step = 10;
        }
        break;
    case 10:
        h->open_c = true;
        h->open_f = true;
        if (h->weight >= ing->setpoint * 8 / 10) {
            h->open_c = false;
            h->step = 20;
        }
        break;
    case 20:
        if (h->weight >= ing->setpoint - h->preact) {
            h->open_f = false;
            h->settle = 0;
            h->step = 30;
        }
        break;
    case 30:
        h->settle++;
        if (h->settle >= 6 && h->fine.closed) {
            h->error = !in_tolerance(ing->setpoint, h->weight, ing->tol);
            if (h->weight > ing->setpoint)
                h->preact += 5;
            else
                h->preact -= 5;
            h->busy = false;
            h->done = true;
            h->step = 0;
        }
        break;
    }

    valve(&h->coarse, h->open_c, 20);
    valve(&h->fine, h->open_f, 50);
    h->weight = h->weight
              + flow_rate(h->coarse.pos, ing->material) * ing->coarse / 100
              + flow_rate(h->fine.pos, ing->material) * ing->fine / 100;
}

typedef struct {
    int32_t total, batches, errors;
    uint8_t crc;
    DosingHead sugar, salt, flour, cocoa, milk, aroma;
} DosingLine;

static void dosing_line(DosingLine *l, bool release, int16_t offset, const Ingredient recipe[6])
{
    dosing_head(&l->sugar, release, &recipe[0]);
    dosing_head(&l->salt, l->sugar.busy, &recipe[1]);
    dosing_head(&l->flour, release, &recipe[2]);
    dosing_head(&l->cocoa, l->flour.busy && !l->salt.busy, &recipe[3]);
    dosing_head(&l->milk, l->salt.done || l->cocoa.done, &recipe[4]);
    Ingredient aroma = recipe[5];
    aroma.setpoint += offset;
    dosing_head(&l->aroma, l->milk.busy, &aroma);

    l->total = l->sugar.weight + l->salt.weight + l->flour.weight + l->cocoa.weight
             + l->milk.weight + l->aroma.weight;
    if (l->aroma.done)
        l->batches++;
    if (l->sugar.error || l->salt.error || l->flour.error || l->cocoa.error
        || l->milk.error || l->aroma.error)
        l->errors++;
    l->crc = crc8(l->crc, (uint8_t)(l->sugar.weight % 256));
    l->crc = crc8(l->crc, (uint8_t)(l->salt.weight % 256));
    l->crc = crc8(l->crc, (uint8_t)(l->flour.weight % 256));
    l->crc = crc8(l->crc, (uint8_t)(l->cocoa.weight % 256));
    l->crc = crc8(l->crc, (uint8_t)(l->milk.weight % 256));
    l->crc = crc8(l->crc, (uint8_t)(l->aroma.weight % 256));
}

static bool init;
static DosingLine line_a, line_b, line_c, line_d;
static Ingredient recipe1[6], recipe2[6];
static int32_t scan_no;

static void init_line(DosingLine *l)
{
    l->sugar.preact = l->salt.preact = l->flour.preact = 150;
    l->cocoa.preact = l->milk.preact = l->aroma.preact = 150;
}

void scan(void)
{
    if (!init) {
        for (int i = 1; i <= 6; i++) {
            Ingredient *r = &recipe1[i - 1];
            r->material = i;
            r->setpoint = 2500 + 400 * i;
            r->tol = 40 + 10 * i;
            r->coarse = 150;
            r->fine = 30 + i;
            r->active = true;
            recipe2[i - 1] = *r;
            recipe2[i - 1].material = 9 - i;
            recipe2[i - 1].setpoint = 5200 - 350 * i;
        }
        init_line(&line_a);
        init_line(&line_b);
        init_line(&line_c);
        init_line(&line_d);
        init = true;
    }
    scan_no++;
    dosing_line(&line_a, true, 0, recipe1);
    dosing_line(&line_b, (scan_no % 64) < 32, 50, recipe1);
    dosing_line(&line_c, line_a.batches >= line_b.batches, -30, recipe2);
    dosing_line(&line_d, (scan_no % 100) > 20, 10, recipe2);

    uint32_t c = (uint32_t)check * 31u + (uint32_t)(line_a.total + line_b.total * 3 + line_c.total * 5 + line_d.total * 7);
    c += (uint32_t)(line_a.errors + line_d.batches + line_a.crc * 11 + line_b.crc + line_c.crc * 13 + line_d.crc);
    check = (int32_t)c;
}
