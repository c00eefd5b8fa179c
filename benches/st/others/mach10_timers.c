#include <stdbool.h>
#include "st.h"

typedef struct { bool in, q; uint32_t start; } Timer;   /* TON, TOF */
typedef struct { bool in, q; uint32_t start; } Pulse;
typedef struct { bool cu, q; int16_t cv; } Ctu;
typedef struct { bool cd, q; int16_t cv; } Ctd;
typedef struct { bool cu, cd, qu, qd; int16_t cv; } Ctud;

static uint32_t now_ms;

static inline void ton(Timer *t, bool in, uint32_t pt)
{
    if (in && !t->in) t->start = now_ms;
    t->in = in;
    t->q = in && now_ms - t->start >= pt;
}

static inline void tof(Timer *t, bool in, uint32_t pt)
{
    if (!in && t->in) t->start = now_ms;
    t->in = in;
    if (in) t->q = true;
    else if (t->q && now_ms - t->start >= pt) t->q = false;
}

static inline void tp(Pulse *t, bool in, uint32_t pt)
{
    if (t->q) {
        if (now_ms - t->start >= pt) t->q = false;
    } else if (in && !t->in) {
        t->start = now_ms;
        t->q = true;
    }
    t->in = in;
}

static inline void ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r) c->cv = 0;
    else if (cu && !c->cu && c->cv < INT16_MAX) c->cv++;
    c->cu = cu;
    c->q = c->cv >= pv;
}

static inline void ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld) c->cv = pv;
    else if (cd && !c->cd && c->cv > INT16_MIN) c->cv--;
    c->cd = cd;
    c->q = c->cv <= 0;
}

static inline void ctud(Ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu, down = cd && !c->cd;
    c->cu = cu;
    c->cd = cd;
    if (r) c->cv = 0;
    else if (ld) c->cv = pv;
    else if (up && !down) { if (c->cv < INT16_MAX) c->cv++; }
    else if (down && !up) { if (c->cv > INT16_MIN) c->cv--; }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static inline bool rising(bool *old, bool clk)
{
    bool q = clk && !*old;
    *old = clk;
    return q;
}

static inline bool falling(bool *old, bool clk)
{
    bool q = !clk && *old;
    *old = clk;
    return q;
}

typedef struct {
    bool drive, fan, jam, full, primed;
    int16_t batches;
    Timer tonStart, tonJam, tonIdle, tofFan, tofLube;
    Pulse tpGlue, tpKnife;
    Ctu pieces;
    Ctd batch;
    Ctud buffer;
    bool partOld, ackOld, partFall, driveFall;
} Station;

static Station station[36];
static int16_t shaft[36];
static uint32_t delay[36];
static int32_t scanNo;
static bool initDone;

static void station_run(Station *s, int16_t angle, bool run, bool ackKey,
                        uint32_t startDelay, uint32_t runOn, int16_t batchSize)
{
    bool part = angle >= 80 && angle < 170;
    bool lubeCam = angle < 25 || angle >= 340;

    bool ack = rising(&s->ackOld, ackKey);
    ton(&s->tonStart, run && !s->jam, startDelay);
    s->drive = s->tonStart.q;
    bool driveEnd = falling(&s->driveFall, s->drive);
    bool partStart = rising(&s->partOld, part && s->drive);
    bool partEnd = falling(&s->partFall, part);

    tof(&s->tofFan, s->drive, runOn);
    s->fan = s->tofFan.q;
    tof(&s->tofLube, lubeCam && s->drive, 60);
    tp(&s->tpGlue, partStart, 40);
    tp(&s->tpKnife, partEnd && s->drive && s->primed, 70);

    ton(&s->tonJam, part && s->drive, 140);
    ton(&s->tonIdle, !part, 500);
    if (s->tonJam.q) s->jam = true;
    else if (ack) s->jam = false;

    ctu(&s->pieces, s->tpGlue.q, s->full && ack, 200);
    s->full = s->pieces.q;
    ctd(&s->batch, partStart, !s->primed || s->batch.q, batchSize);
    if (s->batch.q && s->primed) s->batches++;
    ctud(&s->buffer, s->tpKnife.q, lubeCam && s->fan, s->full, s->tonIdle.q, 12);
    if (driveEnd && s->primed) s->batches += 3;
    if (s->tofLube.q && s->buffer.qu) s->batches++;
    s->primed = true;
}

void scan(void)
{
    now_ms = (uint32_t)(now_us / 1000);
    if (!initDone) {
        for (int i = 0; i < 36; i++) delay[i] = 30 + 10 * ((i + 1) % 7);
        initDone = true;
    }
    if (++scanNo >= 1000) scanNo = 0;
    bool release = scanNo % 250 > 15;
    bool ackKey = scanNo % 90 > 80;

    int32_t sum = 0;
    for (int i = 0; i < 36; i++) {
        Station *s = &station[i];
        shaft[i] += 3 + (i + 1) % 11;
        if (shaft[i] >= 360) shaft[i] -= 360;
        station_run(s, shaft[i], release, ackKey, delay[i], 150, 5 + (i + 1) % 4);
        sum += s->batches;
        if (s->drive) sum += 100;
        if (s->fan) sum += 10000;
        if (s->jam) sum += 7;
        if (s->full) sum += 31;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
