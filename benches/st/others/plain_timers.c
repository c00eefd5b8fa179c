#include <stdint.h>
#include <stdbool.h>
#include "st.h"

typedef struct { bool in, q; int64_t start, et; } ton_t;
typedef struct { bool cu, q; int16_t cv; } ctu_t;

static void ton(ton_t *t, bool in, int64_t pt)
{
    if (!in) {
        t->q = false;
        t->et = 0;
    } else {
        if (!t->in)
            t->start = now_us;
        t->et = now_us - t->start;
        if (t->et >= pt) {
            t->et = pt;
            t->q = true;
        } else {
            t->q = false;
        }
    }
    t->in = in;
}

static void ctu(ctu_t *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX)
        c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static int32_t scans;
static ton_t timers[250];
static ctu_t counters[250];
static int64_t preset[250];

void scan(void)
{
    if (scans == 0)
        for (int i = 0; i < 250; i++)
            preset[i] = 20000 + (i + 1) * 1000;
    scans++;
    int32_t sum = 0;
    for (int i = 0; i < 250; i++) {
        ton(&timers[i], !timers[i].q, preset[i]);
        ctu(&counters[i], timers[i].q, counters[i].q, 10);
        if (timers[i].q)
            sum += i + 1;
        sum += counters[i].cv;
    }
    check = (check + sum + scans) % 1000000;
}
