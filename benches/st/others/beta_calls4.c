#include "st.h"
#include <stdbool.h>

typedef enum { WAITING, COARSE, FINE, SETTLING, EMPTYING } DoseState;
typedef struct { bool q; uint16_t phase; } PulseSource;
typedef struct { uint32_t bits; bool hit; } ShiftReg;
typedef struct { double total; int32_t count; double peak; } Totalizer;
typedef struct { DoseState state; double weight; bool done; int32_t waited; } DoseCell;

static void pulse_source(PulseSource *b, uint16_t period, uint16_t width)
{
    b->phase++;
    if (b->phase >= period)
        b->phase = 0;
    b->q = b->phase < width;
}

static void shift_reg(ShiftReg *b, bool d, uint32_t mask)
{
    b->bits <<= 1;
    if (d)
        b->bits |= 1;
    b->hit = (b->bits & mask) == mask;
}

static void tot_put(Totalizer *t, double amount)
{
    t->total += amount;
    t->count++;
    if (amount > t->peak)
        t->peak = amount;
}

static double tot_mean(const Totalizer *t)
{
    if (t->count == 0)
        return 0.0;
    return t->total / (double)t->count;
}

static void tot_clear(Totalizer *t)
{
    t->total = 0.0;
    t->count = 0;
    t->peak = 0.0;
}

static double tot_peak(const Totalizer *t)
{
    return t->peak;
}

static double flow_of(DoseState s, double opening)
{
    switch (s) {
    case COARSE: return 2.5 * opening;
    case FINE: return 0.4 * opening;
    case EMPTYING: return -6.0;
    default: return 0.0;
    }
}

static void dose_cell(DoseCell *b, bool go, double setpoint, int32_t settle)
{
    b->done = false;
    switch (b->state) {
    case WAITING:
        if (go)
            b->state = COARSE;
        break;
    case COARSE:
        if (b->weight >= setpoint * 0.9)
            b->state = FINE;
        break;
    case FINE:
        if (b->weight >= setpoint) {
            b->state = SETTLING;
            b->waited = 0;
        }
        break;
    case SETTLING:
        b->waited += 10;
        if (b->waited >= settle) {
            b->state = EMPTYING;
            b->done = true;
        }
        break;
    case EMPTYING:
        if (b->weight <= 0.0)
            b->state = WAITING;
        break;
    }
    b->weight += flow_of(b->state, 1.0 + setpoint * 0.001);
    if (b->weight < 0.0)
        b->weight = 0.0;
}

static PulseSource src[30];
static ShiftReg reg[30];
static DoseCell cell[30];
static Totalizer tot[30];
static int32_t batches;

void scan(void)
{
    int32_t sum = 0;
    for (int i = 0; i < 30; i++) {
        pulse_source(&src[i], 9 + i % 5, 4);
        shift_reg(&reg[i], src[i].q, 0x7);
        dose_cell(&cell[i], reg[i].hit, 40.0 + (double)i * 1.5, 80);
        if (cell[i].done) {
            tot_put(&tot[i], cell[i].weight);
            batches++;
            if (batches % 1000 == 0)
                tot_clear(&tot[i]);
        }
        double m = tot_mean(&tot[i]);
        if (tot_peak(&tot[i]) > m * 1.01)
            sum++;
        if (cell[i].state == FINE)
            sum += 3;
        sum += (int32_t)(cell[i].weight * 8.0) + (int32_t)m;
    }
    check = (int32_t)((uint32_t)check * 7u + (uint32_t)sum + (uint32_t)(batches % 100));
}
