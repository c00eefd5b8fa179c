#include <math.h>
#include <stdbool.h>
#include "st.h"

#define FEEDERS 50

enum conv_state { OFF, PRECHARGE, SYNC, RUN, RIDE_THROUGH, FAULT };

struct lowpass { float y; };
struct hysteresis { bool q; };
struct ramp { float y; bool done; };
struct converter { enum conv_state state; int16_t ticks; uint32_t status; bool running; };

static struct lowpass filt[FEEDERS];
static struct hysteresis hyst[FEEDERS];
static struct ramp ramp[FEEDERS];
static struct converter conv[FEEDERS];
static uint32_t rnd = 0xC0FFEE11u;
static int32_t n;

static inline float droop(float f, float nom, float dead, float slope)
{
    float d = f - nom;
    if (fabsf(d) <= dead)
        return 0.0f;
    return d > 0.0f ? (d - dead) * slope : (d + dead) * slope;
}

static inline float interp(float x, float x0, float y0, float x1, float y1)
{
    if (x <= x0)
        return y0;
    if (x >= x1)
        return y1;
    return y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

static inline void lowpass_step(struct lowpass *l, float x, float k)
{
    l->y += k * (x - l->y);
}

static inline void hysteresis_step(struct hysteresis *h, float x, float on, float off)
{
    if (x >= on)
        h->q = true;
    else if (x <= off)
        h->q = false;
}

static inline void ramp_step(struct ramp *r, float target, float up, float down)
{
    if (r->y < target) {
        float y = r->y + up;
        r->y = y < target ? y : target;
    } else if (r->y > target) {
        float y = r->y - down;
        r->y = y > target ? y : target;
    }
    r->done = r->y == target;
}

static void converter_step(struct converter *c, bool enable, bool over_volt, bool reset, float u)
{
    c->ticks++;
    if (over_volt && c->state != FAULT) {
        c->state = FAULT;
        c->ticks = 0;
    }
    switch (c->state) {
    case OFF:
        c->status = 0x0001;
        if (enable) {
            c->state = PRECHARGE;
            c->ticks = 0;
        }
        break;
    case PRECHARGE:
        c->status = 0x0003;
        if (c->ticks >= 8) {
            c->state = SYNC;
            c->ticks = 0;
        }
        break;
    case SYNC:
        c->status = 0x0006;
        if (u > 0.9f && u < 1.1f && c->ticks > 4) {
            c->state = RUN;
            c->ticks = 0;
        }
        break;
    case RUN:
        c->status = 0x001C;
        if (!enable) {
            c->state = OFF;
        } else if (u < 0.85f) {
            c->state = RIDE_THROUGH;
            c->ticks = 0;
        }
        break;
    case RIDE_THROUGH:
        c->status = 0x0038;
        if (u > 0.9f) {
            c->state = RUN;
            c->ticks = 0;
        } else if (c->ticks > 15) {
            c->state = FAULT;
        }
        break;
    case FAULT:
        c->status = 0x8000;
        if (reset)
            c->state = OFF;
        break;
    }
    c->running = c->state == RUN || c->state == RIDE_THROUGH;
}

void scan(void)
{
    n++;
    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;
    float f = 49.7f + (float)(int32_t)(rnd & 0xFF) * 0.0024f;
    float total = 0.0f;
    uint32_t acc = 0;
    for (int i = 0; i < FEEDERS; i++) {
        int32_t phase = (n + i * 13) % 257;
        float u = interp((float)phase, 20.0f, 0.7f, 60.0f, 1.04f);
        lowpass_step(&filt[i], u + (float)(phase * 7 % 19) * 0.005f, 0.2f);
        hysteresis_step(&hyst[i], filt[i].y, 1.07f, 0.95f);
        converter_step(&conv[i], phase > 5, hyst[i].q && phase == 200, phase == 250, filt[i].y);
        float target = conv[i].running ? 2.0f - droop(f, 50.0f, 0.05f, 1.5f) : 0.0f;
        ramp_step(&ramp[i], target, 0.05f, 0.2f);
        total += ramp[i].y;
        acc = acc * 3 + conv[i].status;
        if (ramp[i].done)
            acc++;
    }
    check = (int32_t)((uint32_t)check * 31u + acc + (uint32_t)(int32_t)lrintf(total * 1000.0f));
}
