#include <stdbool.h>
#include "st.h"

typedef enum { IDLE, FEEDING, FILLING, CAPPING, LABELLING, EJECTING, FAULTED } State;

typedef struct {
    int32_t id;
    int16_t level, torque;
    bool capped, label;
} Bottle;

typedef struct {
    State state;
    Bottle bottle;
    int16_t speed;
    int32_t good, bad;
} StationData;

typedef struct {
    int32_t next_id, score;
    int16_t pos, flow, label_count;
} Station;

static int16_t ramp(int16_t act, int16_t target, int16_t step)
{
    if (act < target) {
        int16_t up = (int16_t)(act + step);
        return up < target ? up : target;
    }
    int16_t down = (int16_t)(act - step);
    return down > target ? down : target;
}

static int16_t noise(int32_t seed, int16_t range)
{
    int32_t x = (int32_t)((uint32_t)seed * 1103u + 12345u);
    x = (x / 64) % range;
    return (int16_t)(x < 0 ? -x : x);
}

static bool in_window(int16_t value, int16_t centre, int16_t tol)
{
    int16_t d = (int16_t)(value - centre);
    return (d < 0 ? -d : d) <= tol;
}

static State advance(State now, bool done)
{
    if (!done)
        return now;
    switch (now) {
    case IDLE: return FEEDING;
    case FEEDING: return FILLING;
    case FILLING: return CAPPING;
    case CAPPING: return LABELLING;
    case LABELLING: return EJECTING;
    default: return IDLE;
    }
}

static void conveyor(Station *s, StationData *d, int32_t tick)
{
    d->speed = ramp(d->speed, d->state == FEEDING || d->state == EJECTING ? 100 : 20, 15);
    s->pos = (int16_t)(s->pos + d->speed);
    switch (d->state) {
    case IDLE:
        d->bottle = (Bottle){ .id = ++s->next_id };
        s->pos = noise(tick, 50);
        d->state = advance(d->state, true);
        break;
    case FEEDING:
        d->state = advance(d->state, s->pos > 250);
        break;
    default:
        break;
    }
}

static void filler(Station *s, StationData *d, int16_t target, int32_t tick)
{
    s->flow = ramp(s->flow, d->state == FILLING ? 60 : 0, 12);
    if (d->state == FILLING) {
        d->bottle.level = (int16_t)(d->bottle.level + s->flow + noise(tick + d->bottle.id, 7));
        d->state = advance(d->state, d->bottle.level >= target);
    }
}

static void capper(StationData *d, int32_t tick)
{
    if (d->state == CAPPING) {
        d->bottle.torque = ramp(d->bottle.torque, (int16_t)(90 + noise(tick, 25)), 30);
        d->bottle.capped = d->bottle.torque > 85;
        d->state = advance(d->state, d->bottle.capped);
    }
}

static void labeller(Station *s, StationData *d, int16_t ticks)
{
    if (d->state == LABELLING) {
        s->label_count = ramp(s->label_count, ticks, 1);
        d->bottle.label = in_window(s->label_count, ticks, 0);
        d->state = advance(d->state, d->bottle.label);
    } else {
        s->label_count = 0;
    }
}

static void quality(Station *s, StationData *d, int16_t target)
{
    if (d->state == EJECTING) {
        if (in_window(d->bottle.level, (int16_t)(target + 25), 24) && in_window(d->bottle.torque, 100, 12)
            && d->bottle.capped && d->bottle.label)
            d->good++;
        else
            d->bad++;
        d->state = advance(d->state, true);
    }
    s->score = d->good * 3 - d->bad + d->bottle.level;
}

static void station(Station *s, StationData *d, int index, int32_t tick)
{
    int16_t target = (int16_t)(330 + index * 5);
    conveyor(s, d, tick);
    filler(s, d, target, tick);
    capper(d, tick + index);
    labeller(s, d, (int16_t)(2 + index % 3));
    quality(s, d, target);
}

static Station stations[40];
static StationData data[40];
static int32_t ticks;

void scan(void)
{
    ticks++;
    uint32_t sum = 0;
    for (int i = 0; i < 40; i++) {
        station(&stations[i], &data[i], i, ticks + i * 17);
        sum = sum * 3u + (uint32_t)stations[i].score;
        if (data[i].state == FILLING)
            sum += (uint32_t)data[i].speed;
    }
    check = (int32_t)((uint32_t)check * 31u + sum + 1u);
}
