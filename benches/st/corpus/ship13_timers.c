#include <stdbool.h>
#include "st.h"

typedef struct { bool running, q; uint64_t start; } Ton;
typedef struct { bool in_old, timing, q; uint64_t start; } Tof;
typedef struct { bool in_old, q; uint64_t start; } Tp;
typedef struct { bool cu_old, q; int16_t cv; } Ctu;
typedef struct { bool cd_old, q; int16_t cv; } Ctd;
typedef struct { bool cu_old, cd_old, qu, qd; int16_t cv; } Ctud;

#define MS(x) ((uint64_t)(x) * 1000u)

static inline bool ton(Ton *t, bool in, uint64_t pt)
{
    if (!in) {
        t->running = false;
        t->q = false;
    } else if (!t->running) {
        t->running = true;
        t->start = now_us;
        t->q = pt == 0;
    } else if (!t->q) {
        t->q = now_us - t->start >= pt;
    }
    return t->q;
}

static inline bool tof(Tof *t, bool in, uint64_t pt)
{
    if (in) {
        t->q = true;
        t->timing = false;
    } else {
        if (t->in_old) {
            t->start = now_us;
            t->timing = true;
        }
        if (t->timing && now_us - t->start >= pt) {
            t->q = false;
            t->timing = false;
        }
    }
    t->in_old = in;
    return t->q;
}

static inline bool tp(Tp *t, bool in, uint64_t pt)
{
    if (t->q) {
        if (now_us - t->start >= pt)
            t->q = false;
    } else if (in && !t->in_old) {
        t->start = now_us;
        t->q = true;
    }
    t->in_old = in;
    return t->q;
}

static inline bool ctu(Ctu *c, bool cu, bool r, int16_t pv)
{
    if (r)
        c->cv = 0;
    else if (cu && !c->cu_old && c->cv < INT16_MAX)
        c->cv++;
    c->cu_old = cu;
    c->q = c->cv >= pv;
    return c->q;
}

static inline bool ctd(Ctd *c, bool cd, bool ld, int16_t pv)
{
    if (ld)
        c->cv = pv;
    else if (cd && !c->cd_old && c->cv > INT16_MIN)
        c->cv--;
    c->cd_old = cd;
    c->q = c->cv <= 0;
    return c->q;
}

static inline void ctud(Ctud *c, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
    bool up = cu && !c->cu_old, down = cd && !c->cd_old;
    c->cu_old = cu;
    c->cd_old = cd;
    if (r)
        c->cv = 0;
    else if (ld)
        c->cv = pv;
    else if (up != down) {
        if (up && c->cv < INT16_MAX)
            c->cv++;
        else if (down && c->cv > INT16_MIN)
            c->cv--;
    }
    c->qu = c->cv >= pv;
    c->qd = c->cv <= 0;
}

typedef struct {
    bool active, unack, horn, chatter, old;
    Ton delay;
    Tof hold;
    Tp horn_pulse;
    Ctu trips;
} AlarmChannel;

typedef struct {
    bool run, no_flow, service, cmd, started;
    Ton flow;
    Tof run_on;
    Ctd serv;
    Ctud level;
} PumpStarter;

static void alarm_channel(AlarmChannel *a, bool raw, bool inhibit, bool ack, uint64_t t_on, uint64_t t_off)
{
    a->active = tof(&a->hold, ton(&a->delay, raw && !inhibit, t_on), t_off);
    if (a->active && !a->old)
        a->unack = true;
    else if (ack)
        a->unack = false;
    a->old = a->active;
    a->horn = tp(&a->horn_pulse, a->unack, MS(200));
    a->chatter = ctu(&a->trips, a->active, a->chatter && ack, 5);
}

static void pump_starter(PumpStarter *p, bool start, bool stop, bool flow, bool fill, uint64_t t_start)
{
    p->cmd = (p->cmd || start) && !stop && !p->no_flow;
    p->run = tof(&p->run_on, p->cmd, MS(150));
    p->no_flow = ton(&p->flow, p->run && !flow, t_start);
    p->service = ctd(&p->serv, p->run, p->service || !p->started, 12);
    p->started = true;
    ctud(&p->level, p->run && fill, p->run && !fill, stop && p->no_flow, false, 20);
}

static AlarmChannel alm[100];
static PumpStarter pump[25];
static uint32_t noise = 0x1234567, crc;
static int32_t scans;

void scan(void)
{
    int active = 0, horn = 0, late = 0;

    scans++;
    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;
    bool ack = (noise & 0x0F000000) == 0;

    for (int i = 1; i <= 100; i++) {
        AlarmChannel *a = &alm[i - 1];
        bool raw = (scans + i * 7) % 40 < 15 + i % 10;
        alarm_channel(a, raw, i % 20 == 0 && ack, ack, MS(100), MS(60));
        active += a->active;
        horn += a->horn;
        if (a->chatter)
            crc += i;
    }

    for (int i = 1; i <= 25; i++) {
        PumpStarter *p = &pump[i - 1];
        pump_starter(p, (noise >> i) & 1, (scans + i) % 31 == 0, (scans + i * 3) % 64 < 40,
                     i % 3 != 0, MS(120));
        late += p->no_flow;
        if (p->run)
            crc = crc * 3 + p->level.cv;
        if (p->service)
            crc += 1000;
    }

    crc = crc * 31 + active * 10000 + horn * 100 + late;
    check = (int32_t)crc;
}
